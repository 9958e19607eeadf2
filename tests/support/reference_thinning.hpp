// Thinning by the reference of a rule.
#pragma once

#include "compile/rule_body.hpp"
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
  if (!built_in || repetition.border == Border::foreground) {
    return reference::apply_tables(rule.sub_iterations(), repetition, image, skeleton);
  }
  if (*built_in == BuiltInRule::midpoint_scan) {
    return reference::midpoint_scan(rule.body()->directions, repetition.border, image, skeleton);
  }
  return reference::thinning(*built_in)(repetition, image, skeleton);
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
