// The original, sequential SPTA, computed exactly on words of 64 pixels. Within a row, a pixel
// depends on flags of this scan only through its western neighbour.
//
// Left and right edge points: a left edge point has a background western neighbour, so it does not
// depend on flags of its row. The western neighbour of a right edge point has a foreground eastern
// neighbour, so it can be flagged only as a left edge point. Hence two steps and no dependency
// chain.
//
// Top and bottom edge points: the expressions are monotonic in the western neighbour, so a pixel is
// flagged always, never, or if and only if its western neighbour was not. Let g = flagged xor (x is
// odd). In the third case g is copied from the west, as carries propagate through an addition: one
// addition decides the word.
//
// About 50 and 75 operations per word. Words without foreground are skipped.
//
// Invariants: topology (8-connected objects, 4-connected background), idempotent, subset.
#include "engines/iterate.hpp"
#include "engines/plane_state.hpp"
#include "rules/built_in/neighbourhood.hpp"
#include "simd/word.hpp"
#include "techniques/thinning.hpp"

namespace thinbench::detail {
namespace {

/// The two scans of an iteration, named after the edge points that they flag.
enum class SptaScan : int { left_right, top_bottom };

using Word = std::uint64_t;
using Traits = WordTraits<Word>;

constexpr Word kOddPixels = 0xAAAAAAAAAAAAAAAA;

using Neighbours = Neighbourhood<Word>;

Neighbours neighbours_of(const Word* at, Index stride) {
  const Word* above = at - stride;
  const Word* below = at + stride;
  return {*at,
          Traits::east(*at, at),
          Traits::east(*above, above),
          *above,
          Traits::west(*above, above),
          Traits::west(*at, at),
          Traits::west(*below, below),
          *below,
          Traits::east(*below, below)};
}

/// The candidates that are edge points of one side and whose expression is TRUE. The rotation maps
/// the side to the left side.
template <int eighths>
Word edge_points(Word candidates, const Neighbours& before, const Neighbours& now) {
  const Neighbours n = rotated<eighths>(now);
  const Neighbours b = rotated<eighths>(before);
  const Neighbours c = {~b.p, ~b.n0, ~b.n1, ~b.n2, ~b.n3, ~b.n4, ~b.n5, ~b.n6, ~b.n7};
  return candidates & c.n4 & edge_expression(n, c);
}

/// The flagged candidates. `centre` is the foreground that is not flagged yet.
Word left_right(Word candidates, Word centre, const Word* at, const Neighbours& before,
                Neighbours now) {
  const Word left = edge_points<0>(candidates, before, now);
  now.n4 = Traits::west(centre & ~left, at);  // at[-1] has its final value
  return left | edge_points<4>(candidates, before, now);
}

/// The flagged candidates. `flagged_before`: whether this scan flagged the last pixel of the
/// previous word.
Word top_bottom(Word candidates, const Neighbours& before, Neighbours now, bool flagged_before) {
  const Word western = now.n4;
  now.n4 = 0;
  const Word always =
      edge_points<6>(candidates, before, now) | edge_points<2>(candidates, before, now);
  now.n4 = western;
  const Word possibly =
      edge_points<6>(candidates, before, now) | edge_points<2>(candidates, before, now);
  const Word copies = possibly & ~always;
  const Word sets = ~copies & (always ^ kOddPixels);
  const Word both = copies | sets;
  const Word sum = both + sets + (flagged_before ? 0 : 1);  // the x of that pixel is odd
  const Word from_west = both ^ sets ^ sum;
  return (sets | (copies & from_west)) ^ kOddPixels;
}

class SptaState final : public PlaneState<Word> {
 public:
  explicit SptaState(const ThinningSetting& setting)
      : PlaneState(setting),
        rows_(changing_rows(setting.height, setting.border)),
        max_iterations_(setting.max_iterations),
        fixed_(fixed_pixels<Word>(setting.width, setting.border, false)),
        before_(setting.width, setting.height) {}

  int compute() override {
    const BitPlaneView now = planes.result.view();
    copy_rows(source(), now, {0, now.height});
    int iterations = 1;
    while (iterate_once(now) && iterations < max_iterations_) ++iterations;
    return iterations;
  }

 private:
  /// True if a pixel was flagged.
  bool iterate_once(const BitPlaneView& now) {
    copy_rows<Word>(now, before_.view(), {0, now.height});
    Word flagged = 0;
    for (Index y = rows_.first; y < rows_.last; ++y) {
      flagged |= run_row<SptaScan::left_right>(now, y);
    }
    for (Index y = rows_.first; y < rows_.last; ++y) {
      flagged |= run_row<SptaScan::top_bottom>(now, y);
    }
    return flagged != 0;
  }

  template <SptaScan scan>
  Word run_row(const BitPlaneView& image, Index y) {
    const BitPlaneView before = before_.view();
    const Word* const fixed = fixed_.view().data;
    Word* const now = image.row(y);
    Word any = 0;
    Word flagged = 0;
    Word west = 0;  // the previous word before this scan
    for (Index i = 0; i < image.row_elements; ++i) {
      const Word pixels = now[i];
      const bool flagged_before = (flagged >> 63) != 0;
      flagged = 0;
      if (pixels != 0) {
        const Word candidates = fixed == nullptr ? pixels : pixels & ~fixed[i];
        const Neighbours old = neighbours_of(before.row(y) + i, before.stride);
        Neighbours current = neighbours_of(now + i, image.stride);
        if constexpr (scan == SptaScan::left_right) {
          flagged = left_right(candidates, pixels, now + i, old, current);
        } else {
          current.n4 = pixels << 1 | west >> 63;
          flagged = top_bottom(candidates, old, current, flagged_before);
        }
        now[i] = pixels & ~flagged;
        any |= flagged;
      }
      west = pixels;
    }
    return any;
  }

  RowRange rows_;  // that may change
  int max_iterations_;
  BitPlane fixed_;
  BitPlane before_;  // the image before the iteration
};

}  // namespace

std::unique_ptr<ThinningState> make_spta(const ThinningSetting& setting) {
  return std::make_unique<SptaState>(setting);
}

}  // namespace thinbench::detail
