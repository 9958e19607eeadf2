// Thinning by the reference of a rule.
#pragma once

#include "harness/families.hpp"
#include "support/filled_image.hpp"

namespace thinbench {

struct Thinned {
  ByteImage image;
  int iterations;
};

/// By the reference of the rule's name; by tables for others and with foreground outside.
inline int thin_by_reference(const Rule& rule, const reference::Repetition& repetition,
                             const ConstImageView& image, const ImageView& skeleton) {
  const auto function = reference_named(rule.name());
  if (function == nullptr || repetition.border == Border::foreground) {
    return reference::apply_tables(rule.sub_iterations(), repetition, image, skeleton);
  }
  return function(repetition, image, skeleton);
}

/// What is not given is the rule's own.
inline int thin_by_reference(const Rule& rule, const Thinning& thinning,
                             const ConstImageView& image, const ImageView& skeleton) {
  const reference::Repetition repetition = {
      thinning.border.value_or(rule.border()),
      thinning.max_iterations.value_or(rule.max_iterations())};
  return thin_by_reference(rule, repetition, image, skeleton);
}

/// The destination is filled beforehand with a value that no reference writes.
inline Thinned thinned_by_reference(const Rule& rule, const ByteImage& image,
                                    const reference::Repetition& repetition = {}) {
  Thinned result = {filled_image(image.width(), image.height(), 77), 0};
  result.iterations = thin_by_reference(rule, repetition, image.view(), result.image.view());
  return result;
}

}  // namespace thinbench
