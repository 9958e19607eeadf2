// Thinning by the reference of a rule.
#pragma once

#include "harness/families.hpp"
#include "support/made_image.hpp"

namespace thinbench {

struct Thinned {
  ByteImage image;
  int iterations;
};

/// The destination is filled beforehand with a value that no reference writes.
inline Thinned thinned_by_reference(const Rule& rule, const ByteImage& image,
                                    const reference::Repetition& repetition = {}) {
  Thinned result = {filled_image(image.width(), image.height(), 77), 0};
  result.iterations = thin_by_reference(rule, repetition, image.view(), result.image.view());
  return result;
}

}  // namespace thinbench
