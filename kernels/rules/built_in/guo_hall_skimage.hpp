// Guo and Hall's rule as in scikit-image and MATLAB. Preserves topology.
#pragma once

#include "rules/built_in/guo_hall.hpp"

namespace thinbench::detail {

/// Guo and Hall's rule with its two sub-iterations exchanged: scikit-image's `thin`, and "thin" of
/// MATLAB's and Octave's `bwmorph`. Its skeletons are those of GuoHall of the image rotated by 180
/// degrees, and so are its invariants.
struct GuoHallSkimage {
  static constexpr int kSubIterations = 2;

  template <int sub, class Word>
  [[gnu::always_inline]] static constexpr Word next(const Neighbourhood<Word>& n) {
    return GuoHall::next<1 - sub>(n);
  }

  template <int sub, class Lane>
  [[gnu::always_inline]] static constexpr Lane published(const Neighbourhood<Lane>& n) {
    return GuoHall::published<1 - sub>(n);
  }
};

template <>
struct RuleType<BuiltInRule::guo_hall_skimage> {
  using Type = GuoHallSkimage;
};

}  // namespace thinbench::detail
