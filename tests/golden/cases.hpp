// The cases of the golden file: an operation, its options and an image.
#pragma once

#include <array>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "harness/job.hpp"
#include "techniques/variants.hpp"

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

inline constexpr std::array kOtherBinary = {
    "holes",          "components",  "fill_holes",    "fill_holes_4",     "euler_number",
    "euler_number_4", "label_image", "label_image_4", "label_components", "label_components_4",
    "label_regions"};
inline constexpr std::array kGrey = {"edges_roberts4",       "edges_roberts9", "edges_mero_vassy",
                                     "edges_mero_vassy_5x5", "edges_sobel",    "edges_prewitt",
                                     "localise_objects"};

inline std::vector<Case> thinning_cases_on(const std::string& image) {
  std::vector<Case> cases;
  for (const char* border : {"background", "keep"}) {
    for (const auto& operation : detail::study::thinning_operations()) {
      cases.push_back({std::string(operation.name), border, image});
    }
    cases.push_back({"skeleton_scan", border, image});
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

}  // namespace thinbench::golden
