// Choosing among the variants of an operation, the same for every family.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "dispatch/isa.hpp"
#include "dispatch/technique.hpp"
#include "image/plane_view.hpp"

namespace thinbench {

/// What a choice depends on.
struct VariantFacts {
  Technique technique;
  Isa isa;
  bool threaded;
  Index max_width = std::numeric_limits<Index>::max();
};

/// What is asked for. What is left open is chosen: the fastest technique that this machine offers.
struct VariantRequest {
  std::optional<Technique> technique = std::nullopt;
  std::optional<Isa> isa = std::nullopt;
  int threads = 1;
};

inline constexpr int kMaxThreads = 1024;

/// Why a variant cannot run here on an image of this width; empty where it can.
[[nodiscard]] std::string_view unavailable_reason(const VariantFacts& variant, Index width);
/// The same with numbers, for messages: "wider than this variant's limit of 512 pixels".
[[nodiscard]] std::string obstacle(const VariantFacts& variant, Index width);

/// The place of the variant of `operation` that fits the wish on an image of this width. Throws
/// std::invalid_argument where none fits, naming what keeps the last that would; where there is
/// none at all, the techniques there are, or the levels of the technique.
[[nodiscard]] std::size_t choose_variant(std::string_view operation,
                                         std::span<const VariantFacts> variants, Index width,
                                         const VariantRequest& wish);

}  // namespace thinbench
