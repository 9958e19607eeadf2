// The original, sequential SPTA on words of 64 pixels, exact: row by row, the 64 pixels of a word
// at once.
//
// Within a row, the western neighbour is the only one that the scan has visited before. Left and
// right edge points: a left edge point has a background western neighbour, so its decision does not
// depend on the row; the western neighbour of a right edge point can only have been flagged as a
// left edge point, because its eastern neighbour is foreground. Two steps, no dependency chain. Top
// and bottom edge points: the expressions are monotonic in the western neighbour, so a pixel is
// flagged always, never, or if and only if its western neighbour was not. In g = flagged xor (x
// odd) the last kind copies g from the west, as carries propagate through an addition: one addition
// decides the word. About 50 and 75 operations per word; words without foreground are skipped.
#include "simd/word.hpp"
#include "thinning/engines/spta.hpp"
#include "thinning/rules/neighbourhood.hpp"

namespace thinbench::detail {
namespace {

/// The two scans of an iteration.
enum class SptaScan : int { left_right, top_bottom };

using Word = std::uint64_t;
using Traits = WordTraits<Word>;

constexpr Word kOddPixels = 0xAAAAAAAAAAAAAAAA;

using Around = Neighbourhood<Word>;

/// The neighbours of 64 pixels.
Around around(const Word* at, Index stride) {
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

/// The candidates that are edge points of a side with a TRUE expression; the rotation makes the
/// side the left one.
template <int eighths>
Word edge(Word candidates, const Around& before, const Around& now) {
  const Around n = rotated<eighths>(now);
  const Around b = rotated<eighths>(before);
  const Around c = {~b.p, ~b.n0, ~b.n1, ~b.n2, ~b.n3, ~b.n4, ~b.n5, ~b.n6, ~b.n7};
  return candidates & c.n4 & edge_expression(n, c);
}

/// Candidates may be flagged; `centre` is foreground that is not flagged.
Word left_right(Word candidates, Word centre, const Word* at, const Around& before, Around now) {
  const Word left = edge<0>(candidates, before, now);
  now.n4 = Traits::west(centre & ~left, at);  // the previous word is done
  return left | edge<4>(candidates, before, now);
}

/// `flagged_before`: whether the last pixel of the previous word was flagged in this scan.
Word top_bottom(Word candidates, const Around& before, Around now, bool flagged_before) {
  const Word western = now.n4;
  now.n4 = 0;
  const Word always = edge<6>(candidates, before, now) | edge<2>(candidates, before, now);
  now.n4 = western;
  const Word possibly = edge<6>(candidates, before, now) | edge<2>(candidates, before, now);
  const Word copies = possibly & ~always;
  const Word sets = ~copies & (always ^ kOddPixels);
  const Word both = copies | sets;
  const Word sum = both + sets + (flagged_before ? 0 : 1);  // that pixel is odd
  const Word from_west = both ^ sets ^ sum;
  return (sets | (copies & from_west)) ^ kOddPixels;
}

struct Rows {
  Word* before;  // word 0 of row 0, between zero words and rows
  Index before_stride;
  BitPlaneView now;
  Index words;
  const Word* changing;  // a 1 for every pixel of a row that may be flagged
  Index first;           // of the rows that may change
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
  // The previous word before this scan, to know whether its last pixel was flagged.
  Word west = 0;
  for (Index i = 0; i < rows.words; ++i) {
    const Word pixels = now[i];
    const bool flagged_before = (flagged >> 63) != 0;
    flagged = 0;
    if (pixels != 0) {
      const Word candidates = pixels & rows.changing[i];
      const Around was = around(before + i, rows.before_stride);
      Around is = around(now + i, rows.now.stride);
      if constexpr (scan == SptaScan::left_right) {
        flagged = left_right(candidates, pixels, now + i, was, is);
      } else {
        is.n4 = pixels << 1 | west >> 63;
        flagged = top_bottom(candidates, was, is, flagged_before);
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

/// True where a pixel was flagged.
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

/// `scratch` holds the image before an iteration, in a margin, then the pixels that may change.
Rows make_rows(Border border, const BitPlaneView& image, Word* scratch) {
  const Index count = spta_scratch_words(image.width, image.height);
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

}  // namespace

Index spta_scratch_words(Index width, Index height) {
  return (height + 3) * (words_of(width) + 2);
}

int thin_spta(Border border, int max_iterations, const ConstBitPlaneView& source,
              const BitPlaneView& target, Word* scratch) {
  const Rows rows = make_rows(border, target, scratch);
  for (Index y = 0; y < source.height; ++y) copy(source.row(y), target.row(y), rows.words);
  int iterations = 1;
  while (iterate_once(rows) && iterations < max_iterations) ++iterations;
  return iterations;
}

}  // namespace thinbench::detail
