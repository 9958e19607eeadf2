// The part of the golden test that calls the library: from a case to its result.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "golden/cases.hpp"
#include "golden/hash.hpp"
#include "harness/holes_family.hpp"
#include "reference.hpp"
#include "thinbench.hpp"
#include "thinbench_edges.hpp"
#include "thinbench_holes.hpp"
#include "thinbench_localise.hpp"

namespace thinbench::golden {

inline Border border_of(const Case& one) {
  return one.border == border_name(Border::kKeep) ? Border::kKeep : Border::kBackground;
}

/// As the catalog names an operation that is limited to one iteration.
inline std::string catalog_name(const Case& one) {
  return one.max_iterations == "1" ? one.operation + "_pass" : one.operation;
}

/// Of this size, filled with what no operation gives, so that pixels left unwritten show.
inline ByteImage unwritten(Index width, Index height) {
  ByteImage image(width, height);
  for (Index y = 0; y < height; ++y) {
    for (Index x = 0; x < width; ++x) image.at(x, y) = 77;
  }
  return image;
}

inline Result run_thinning(const Case& one, const ByteImage& image, int threads) {
  ByteImage output = unwritten(image.width(), image.height());
  const int iterations = thin(catalog_name(one), image.view(), output.view(),
                              {.threads = threads, .border = border_of(one)});
  return {hash_of(output), std::to_string(iterations)};
}

/// Filling holes always runs on one thread.
inline Result run_image_operation(const Case& one, const ByteImage& image, int threads) {
  ByteImage output = unwritten(image.width(), image.height());
  if (one.operation == "fill_holes") {
    fill_holes(image.view(), output.view());
  } else {
    detect_edges(one.operation, image.view(), output.view(), {}, {.threads = threads});
  }
  return {hash_of(output)};
}

inline std::vector<std::int64_t> lists_of(const FoundHoles& found) {
  return numbers_of({found.objects, found.holes});
}

/// Throws std::invalid_argument for an unknown name.
inline std::vector<std::int64_t> numbers_found(std::string_view operation, ConstByteView image,
                                               int threads) {
  const VariantWish wish = {.threads = threads};
  if (operation == "holes") return lists_of(find_holes(image, wish));
  if (operation == "components") return lists_of({find_components(image, wish), {}});
  if (operation == "euler_number") return {euler_number(image, wish)};
  if (operation == "euler_number_4") return {euler_number_4(image, wish)};
  if (operation == "localise_objects") return lists_of(localise_objects(image, {}, wish));
  throw std::invalid_argument("no operation is named " + std::string(operation));
}

/// By the library's own choice of technique.
inline Result run_case(const Case& one, const ByteImage& image, int threads) {
  const bool gives_image = one.operation.starts_with("edges_") || one.operation == "fill_holes";
  if (one.operation == kInput) return {hash_of(image)};
  if (one.border != "-") return run_thinning(one, image, threads);
  if (gives_image) return run_image_operation(one, image, threads);
  return {hash_of(numbers_found(one.operation, image.view(), threads))};
}

using BorderedThinning = int (*)(Border, ConstByteView, ByteView);

struct NamedThinning {
  std::string_view operation;
  BorderedThinning function;
};

inline constexpr std::array kBorderedReferences = {
    NamedThinning{"thin_zhang_suen", &reference::thin_zhang_suen},
    NamedThinning{"thin_guo_hall", &reference::thin_guo_hall},
    NamedThinning{"thin_spta_directional", &reference::thin_spta_directional},
    NamedThinning{"thin_mb2", &reference::thin_mb2}};

/// By the plain reference; nothing where there is none for the operation and its border.
inline std::optional<Result> run_reference(const Case& one, const ByteImage& image) {
  ByteImage output = unwritten(image.width(), image.height());
  const auto result = [&](int iterations) {
    return Result{hash_of(output), std::to_string(iterations)};
  };
  for (const auto& [operation, function] : kBorderedReferences) {
    if (operation != one.operation) continue;
    return result(function(border_of(one), image.view(), output.view()));
  }
  const reference::Thinning function = reference::find_thinning(catalog_name(one));
  if (function == nullptr || border_of(one) == Border::kKeep) return std::nullopt;
  return result(function(image.view(), output.view()));
}

}  // namespace thinbench::golden
