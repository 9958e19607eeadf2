// Thinning by the reference of a rule.
#pragma once

#include "reference.hpp"
#include "support/filled_image.hpp"

namespace thinbench {

struct Thinned {
  ByteImage image;
  int iterations;
};

/// By the reference of a built-in rule; by tables for others and with foreground outside.
inline int thin_by_reference(const Rule& rule, const reference::Repetition& repetition,
                             const ConstImageView& image, const ImageView& skeleton) {
  const auto built_in = rule_from_name(rule.name());
  if (built_in && repetition.border != Border::foreground) {
    return reference::thinning(*built_in)(repetition, image, skeleton);
  }
  return reference::apply_tables(rule.sub_iterations(), repetition, image, skeleton);
}

/// The destination is filled beforehand with a value that no reference writes.
inline Thinned thinned_by_reference(const Rule& rule, const ByteImage& image,
                                    const reference::Repetition& repetition = {}) {
  Thinned result = {filled_image(image.width(), image.height(), 77), 0};
  result.iterations = thin_by_reference(rule, repetition, image.view(), result.image.view());
  return result;
}

}  // namespace thinbench
