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
#include "core/byte_image.hpp"
#include "engines/plane_state.hpp"
#include "engines/variants.hpp"
#include "rules/built_in/neighbourhood.hpp"
#include "simd/word.hpp"

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

struct Rows {
  Word* before;  // the image before the iteration, surrounded by zero words and rows
  Index before_stride;
  BitPlaneView now;
  Index words;
  const Word* changing;  // the mask of pixels of a row that may change
  Index first;           // rows [first, last) may change
  Index last;
};

Index words_of(Index width) {
  return (width + kWordBits - 1) / kWordBits;
}

template <SptaScan scan>
Word run_row(const Rows& rows, Index y) {
  const Word* before = rows.before + y * rows.before_stride;
  Word* now = rows.now.row(y);
  Word any = 0;
  Word flagged = 0;
  Word west = 0;  // the previous word before this scan
  for (Index i = 0; i < rows.words; ++i) {
    const Word pixels = now[i];
    const bool flagged_before = (flagged >> 63) != 0;
    flagged = 0;
    if (pixels != 0) {
      const Word candidates = pixels & rows.changing[i];
      const Neighbours old = neighbours_of(before + i, rows.before_stride);
      Neighbours current = neighbours_of(now + i, rows.now.stride);
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

void copy(const Word* from, Word* to, Index words) {
  for (Index i = 0; i < words; ++i) to[i] = from[i];
}

/// True if a pixel was flagged.
bool iterate_once(const Rows& rows) {
  const Index height = rows.now.height;
  for (Index y = 0; y < height; ++y) {
    copy(rows.now.row(y), rows.before + y * rows.before_stride, rows.words);
  }
  Word flagged = 0;
  for (Index y = rows.first; y < rows.last; ++y) flagged |= run_row<SptaScan::left_right>(rows, y);
  for (Index y = rows.first; y < rows.last; ++y) flagged |= run_row<SptaScan::top_bottom>(rows, y);
  return flagged != 0;
}

/// Lays out `scratch`: the image before the iteration with its margin, then the mask `changing`.
Index scratch_words(Index width, Index height) {
  return (height + 3) * (words_of(width) + 2);
}

Rows rows_of(Border border, const BitPlaneView& image, Word* scratch) {
  const Index count = scratch_words(image.width, image.height);
  for (Index i = 0; i < count; ++i) scratch[i] = 0;
  const Index words = words_of(image.width);
  const Index stride = words + 2;
  Word* changing = scratch + (image.height + 2) * stride;
  for (Index i = 0; i < words; ++i) changing[i] = ~Word{0};
  const bool keep = border == Border::keep;
  if (keep && words > 0) {
    changing[0] &= ~Word{1};
    changing[words - 1] &= ~(Word{1} << ((image.width - 1) % kWordBits));
  }
  const Index margin = keep ? 1 : 0;
  return {scratch + stride + 1, stride, image, words, changing, margin, image.height - margin};
}

/// Returns the number of iterations, including the last.
int thin_spta(Border border, int max_iterations, const ConstBitPlaneView& source,
              const BitPlaneView& target, Word* scratch) {
  const Rows rows = rows_of(border, target, scratch);
  for (Index y = 0; y < source.height; ++y) copy(source.row(y), target.row(y), rows.words);
  int iterations = 1;
  while (iterate_once(rows) && iterations < max_iterations) ++iterations;
  return iterations;
}

class SptaState final : public PlaneState<Word> {
 public:
  explicit SptaState(const ThinningSetting& setting)
      : PlaneState(setting),
        border_(setting.border),
        max_iterations_(setting.max_iterations),
        scratch_(make_aligned<Word>(
            static_cast<std::size_t>(scratch_words(setting.width, setting.height)))) {}

  int compute() override {
    return thin_spta(border_, max_iterations_, source(), planes.result.view(), scratch_.get());
  }

 private:
  Border border_;
  int max_iterations_;
  AlignedArray<Word> scratch_;
};

}  // namespace

std::unique_ptr<ThinningState> make_spta(const ThinningSetting& setting) {
  return std::make_unique<SptaState>(setting);
}

}  // namespace thinbench::detail
