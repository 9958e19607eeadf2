// Operations on objects and holes, and their variants: plain rows of a table.
#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string_view>

#include "dispatch/variant_choice.hpp"
#include "regions/label_store.hpp"

namespace thinbench::detail {

/// What is asked for: lists of regions (holes, components), a number (the Euler number with 8- or
/// 4-connected objects) or an image (interior contours filled).
enum class HolesTask : std::uint8_t { holes, components, euler_eight, euler_four, fill };

/// What a state needs to know beside its technique.
struct HolesSetting {
  HolesTask task;
  Isa isa;
  Index width;
  Index height;
  int threads;
};

/// One variant at work; owns all memory.
class HolesState {
 public:
  HolesState() = default;
  virtual ~HolesState() = default;
  HolesState(const HolesState&) = delete;
  HolesState& operator=(const HolesState&) = delete;
  HolesState(HolesState&&) = delete;
  HolesState& operator=(HolesState&&) = delete;

  virtual void load(const ConstImageView& source) = 0;
  virtual void compute() = 0;
  /// What the task asked for; the two others throw std::logic_error.
  [[nodiscard]] virtual RegionLists regions() const { refuse_result(); }
  [[nodiscard]] virtual std::int64_t number() const { refuse_result(); }
  virtual void store(const ImageView& /*destination*/) const { refuse_result(); }
  [[nodiscard]] virtual bool margins_are_zero() const = 0;

 private:
  [[noreturn]] static void refuse_result() {
    throw std::logic_error("the operation gives another kind of result");
  }
};

using MakeHolesState = std::unique_ptr<HolesState> (*)(const HolesSetting& setting);

struct HolesVariant {
  Technique technique;
  Isa isa;
  bool threaded;    // runs on bands of rows with as many threads as asked for
  Index max_width;  // wider images need another variant
  MakeHolesState make;
};

struct HolesOperation {
  std::string_view name;
  std::string_view description;
  HolesTask task;
  std::span<const HolesVariant> variants;
};

/// The largest width and height: keys of boundaries are 32-bit numbers.
inline constexpr Index kMaxHolesSide = Index{1} << 29;
/// The most pixels: labels are 32-bit numbers, sums of coordinates 64-bit ones.
inline constexpr Index kMaxHolesPixels = Index{1} << 32;

[[nodiscard]] inline VariantFacts facts_of(const HolesVariant& variant) {
  return {variant.technique, variant.isa, variant.threaded, variant.max_width};
}

}  // namespace thinbench::detail
