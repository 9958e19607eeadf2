// The cases of the golden file: an operation, its options and an image; and how they are run.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "harness/families.hpp"
#include "support/fnv1a.hpp"
#include "support/made_image.hpp"
#include "support/reference_thinning.hpp"
#include "techniques/variants.hpp"
#include "thinbench/edges.hpp"
#include "thinbench/localise.hpp"
#include "thinbench/midpoint_scan.hpp"
#include "thinbench/regions.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench::golden {

/// "-" stands for an option that does not apply.
struct Case {
  std::string operation;
  std::string border;  // "background", "keep" or "-"
  std::string image;

  /// The order of lines and columns.
  friend bool operator<(const Case& a, const Case& b) {
    return std::tie(a.operation, a.border, a.image) < std::tie(b.operation, b.border, b.image);
  }
};

/// The hash of the output and, of operations that iterate, "/" and the number of iterations.
using Result = std::string;

/// Not an operation: the hash of the input image. If it differs, the generator of the image has
/// changed, and the other cases on this image are meaningless.
inline constexpr const char* kInput = "input";

inline constexpr std::array kOtherBinary = {"holes",           "objects",       "fill_holes",
                                            "fill_holes_4",    "euler_number",  "euler_number_4",
                                            "label_image",     "label_image_4", "label_objects",
                                            "label_objects_4", "label_regions"};
inline constexpr std::array kGrey = {"edges_roberts4",       "edges_roberts9", "edges_mero_vassy",
                                     "edges_mero_vassy_5x5", "edges_sobel",    "edges_prewitt",
                                     "localise_objects"};

inline std::vector<Case> thinning_cases_on(const std::string& image) {
  std::vector<Case> cases;
  for (const char* border : {"background", "keep"}) {
    for (const auto& operation : detail::study::thinning_operations()) {
      cases.push_back({std::string(operation.name), border, image});
    }
    cases.push_back({"midpoint_scan", border, image});
  }
  return cases;
}

/// All cases on the image with this name.
inline std::vector<Case> cases_on(const std::string& image, InputKind kind) {
  std::vector<Case> cases = {{kInput, "-", image}};
  if (kind == InputKind::grey) {
    for (const char* name : kGrey) cases.push_back({name, "-", image});
    return cases;
  }
  for (Case& one : thinning_cases_on(image)) cases.push_back(std::move(one));
  for (const char* name : kOtherBinary) cases.push_back({name, "-", image});
  return cases;
}

/// The first 8 digits of the hash: 32 bits tell a wrong output, too.
inline std::string digits_of(const Fnv1a& hash) {
  return hash.text().substr(0, 8);
}

/// Hashes width, height and pixels.
inline std::string hash_of(const ByteImage& image) {
  Fnv1a hash;
  hash.add_number(image.width());
  hash.add_number(image.height());
  hash.add_pixels(image.view());
  return digits_of(hash);
}

inline std::string hash_of(const std::vector<std::int64_t>& numbers) {
  Fnv1a hash;
  for (const std::int64_t number : numbers) hash.add_number(number);
  return digits_of(hash);
}

inline Border border_of(const Case& one) {
  return one.border == border_name(Border::keep) ? Border::keep : Border::background;
}

/// Filled with a value that no operation writes, so that unwritten pixels are noticed.
inline ByteImage unwritten(Index width, Index height) {
  return filled_image(width, height, 77);
}

/// Of the product or, where it has none of this name, of the study by its best variant.
inline int thinned(const Case& one, const ByteImage& image, const ImageView& output, int threads) {
  if (one.operation == "midpoint_scan") {
    midpoint_scan(image.view(), output, {}, border_of(one), {.threads = threads});
    return 1;
  }
  if (const auto rule = rule_from_name(one.operation)) {
    return thin(*rule, image.view(), output, {.border = border_of(one)}, {.threads = threads});
  }
  const auto& operations = detail::study::thinning_operations();
  const auto found = std::find_if(operations.begin(), operations.end(), [&](const auto& operation) {
    return operation.name == one.operation;
  });
  if (found == operations.end()) throw std::invalid_argument("no operation " + one.operation);
  const auto parameters = detail::thinning_parameters(found->key, {.border = border_of(one)});
  const auto& variant =
      detail::choose_variant(found->variants, image.width(), image.height(), {.threads = threads});
  return make_state(variant, image.width(), image.height(), parameters, threads)
      ->run(image.view(), output);
}

inline Result run_thinning(const Case& one, const ByteImage& image, int threads) {
  ByteImage output = unwritten(image.width(), image.height());
  const int iterations = thinned(one, image, output.view(), threads);
  return hash_of(output) + '/' + std::to_string(iterations);
}

inline Result run_image_operation(const Case& one, const ByteImage& image, int threads) {
  ByteImage output = unwritten(image.width(), image.height());
  if (one.operation.starts_with("fill_holes")) {
    const auto objects = one.operation.ends_with("_4") ? Connectivity::four : Connectivity::eight;
    fill_holes(image.view(), output.view(), {objects}, {.threads = threads});
  } else {
    detect_edges(edge_operator_from_name(one.operation).value(), image.view(), output.view(), {},
                 {.threads = threads});
  }
  return hash_of(output);
}

inline std::vector<std::int64_t> lists_of(const Regions& found) {
  return numbers_of({found.objects, found.holes});
}

/// What a list holds and all labels.
inline std::vector<std::int64_t> labels_found(std::string_view operation, ConstImageView image,
                                              const Execution& execution) {
  std::vector<std::int32_t> labels(static_cast<std::size_t>(image.width * image.height), -1);
  const LabelView view = {labels.data(), image.width, image.height};
  const auto connectivity = operation.ends_with("_4") ? Connectivity::four : Connectivity::eight;
  std::vector<std::int64_t> numbers;
  if (operation == "label_regions") {
    numbers = lists_of(label_regions(image, view, execution));
  } else if (operation.starts_with("label_objects")) {
    numbers =
        lists_of({label_objects(image, view, connectivity, LabelOrder::pixels, execution), {}});
  } else {
    numbers = {label_image(image, view, connectivity, LabelOrder::pixels, execution)};
  }
  numbers.insert(numbers.end(), labels.begin(), labels.end());
  return numbers;
}

/// Throws std::invalid_argument for an unknown name.
inline std::vector<std::int64_t> numbers_found(std::string_view operation, ConstImageView image,
                                               int threads) {
  const Execution execution = {.threads = threads};
  if (operation == "holes") return lists_of(find_regions(image, execution));
  if (operation == "objects") return lists_of({find_objects(image, execution), {}});
  if (operation == "euler_number") return {euler_number(image, Connectivity::eight, execution)};
  if (operation == "euler_number_4") return {euler_number(image, Connectivity::four, execution)};
  if (operation.starts_with("label_")) return labels_found(operation, image, execution);
  if (operation == "localise_objects") return lists_of(localise_objects(image, {}, execution));
  throw std::invalid_argument("no operation is named " + std::string(operation));
}

/// By the technique that the library chooses.
inline Result run_case(const Case& one, const ByteImage& image, int threads) {
  const bool gives_image =
      one.operation.starts_with("edges_") || one.operation.starts_with("fill_holes");
  if (one.operation == kInput) return hash_of(image);
  if (one.border != "-") return run_thinning(one, image, threads);
  if (gives_image) return run_image_operation(one, image, threads);
  return hash_of(numbers_found(one.operation, image.view(), threads));
}

/// By the reference; only for thinning.
inline Result run_reference(const Case& one, const ByteImage& image) {
  Thinned result = {unwritten(image.width(), image.height()), 0};
  if (one.operation == "midpoint_scan") {
    result.iterations =
        reference::midpoint_scan({}, border_of(one), image.view(), result.image.view());
  } else {
    result.iterations =
        reference_named(one.operation)({border_of(one)}, image.view(), result.image.view());
  }
  return hash_of(result.image) + '/' + std::to_string(result.iterations);
}

}  // namespace thinbench::golden
