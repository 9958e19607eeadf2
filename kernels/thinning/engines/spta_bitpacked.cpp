// The original, sequential SPTA on words of 64 pixels, exact: rows come one after another, the 64
// pixels of a word at once.
//
// Within a row, the only neighbour that this scan has visited before is the western one. Left and
// right edge points: a left edge point has a light western neighbour, so its decision needs nothing
// of the row; a right edge point's western neighbour can only have been flagged as a left edge
// point, because its eastern neighbour is dark. Two steps, no chain.
// Top and bottom edge points: the western neighbour counts. The expressions grow with it, so a
// pixel is flagged whatever happened there, or not at all, or if and only if the western one was
// not. In g = flagged xor (x odd) the last kind copies g from the west: this is how carries run
// through an addition, and one addition decides the word. About 50 and 75 operations a word; words
// without dark pixels are passed over.
#include "simd/word.hpp"
#include "thinning/engines/spta.hpp"

namespace thinbench::detail {
namespace {

using Word = std::uint64_t;
using Traits = WordTraits<Word>;

constexpr Word kOddPixels = 0xAAAAAAAAAAAAAAAA;

/// The eight neighbours of 64 pixels; n[4] as it was before the scan.
struct Around {
  Word n[8];
};

Around around(const Word* at, Index stride) {
  const Word* above = at - stride;
  const Word* below = at + stride;
  return {{Traits::east(*at, at), Traits::east(*above, above), *above, Traits::west(*above, above),
           Traits::west(*at, at), Traits::west(*below, below), *below,
           Traits::east(*below, below)}};
}

/// Edge points of the side that is `turn` neighbours from the left, where their expression is TRUE.
template <int turn>
Word edge(Word dark, const Around& before, const Around& now) {
  const auto b = [&](int i) { return before.n[(i + turn) % 8]; };
  const auto n = [&](int i) { return now.n[(i + turn) % 8]; };
  return dark & ~b(4) & n(0) & (n(1) | n(2) | n(6) | n(7)) & (n(2) | ~b(3)) & (~b(5) | n(6));
}

Word left_right(Word dark, const Word* at, const Around& before, Around now) {
  const Word left = edge<0>(dark, before, now);
  now.n[4] = Traits::west(dark & ~left, at);  // the word before is done
  return left | edge<4>(dark, before, now);
}

/// `flagged_before`: whether the last pixel of the word before was flagged in this scan.
Word top_bottom(Word dark, const Around& before, Around now, bool flagged_before) {
  const Word west_dark = now.n[4];
  now.n[4] = 0;
  const Word anyway = edge<6>(dark, before, now) | edge<2>(dark, before, now);
  now.n[4] = west_dark;
  const Word at_most = edge<6>(dark, before, now) | edge<2>(dark, before, now);
  const Word copies = at_most & ~anyway;
  const Word sets = ~copies & (anyway ^ kOddPixels);
  const Word both = copies | sets;
  const Word sum = both + sets + (flagged_before ? 0 : 1);  // the pixel before is odd
  const Word from_west = both ^ sets ^ sum;
  return (sets | (copies & from_west)) ^ kOddPixels;
}

struct Rows {
  Word* before;  // word 0 of row 0, between zero words and rows
  Index before_stride;
  BitPlaneView now;
  Index words;
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
  // The western word is still needed as it was, to know whose last pixel this scan flagged.
  Word west = 0;
  for (Index i = 0; i < rows.words; ++i) {
    const Word dark = now[i];
    const bool flagged_before = (flagged >> 63) != 0;
    flagged = 0;
    if (dark != 0) {
      const Around was = around(before + i, rows.before_stride);
      Around is = around(now + i, rows.now.stride);
      if constexpr (scan == SptaScan::left_right) {
        flagged = left_right(dark, now + i, was, is);
      } else {
        is.n[4] = dark << 1 | west >> 63;
        flagged = top_bottom(dark, was, is, flagged_before);
      }
      now[i] = dark & ~flagged;
      any |= flagged;
    }
    west = dark;
  }
  return any;
}

void copy(const Word* from, Word* to, Index words) {
  for (Index i = 0; i < words; ++i) to[i] = from[i];
}

/// True where a pixel was flagged.
bool run_pass(const Rows& rows) {
  const Index height = rows.now.height;
  for (Index y = 0; y < height; ++y) {
    copy(rows.now.row(y), rows.before + y * rows.before_stride, rows.words);
  }
  Word flagged = 0;
  for (Index y = 0; y < height; ++y) flagged |= run_row<SptaScan::left_right>(rows, y);
  for (Index y = 0; y < height; ++y) flagged |= run_row<SptaScan::top_bottom>(rows, y);
  return flagged != 0;
}

Index scratch_words(Index width, Index height) {
  return (height + 2) * (words_of(width) + 2);
}

int thin(Directions, const ConstBitPlaneView& source, const BitPlaneView& target, Word* scratch) {
  const Index count = scratch_words(source.width, source.height);
  for (Index i = 0; i < count; ++i) scratch[i] = 0;
  const Index stride = words_of(source.width) + 2;
  const Rows rows = {scratch + stride + 1, stride, target, words_of(source.width)};
  for (Index y = 0; y < source.height; ++y) copy(source.row(y), target.row(y), rows.words);
  int passes = 1;
  while (run_pass(rows)) ++passes;
  return passes;
}

}  // namespace

constinit const ImageKernel<std::uint64_t> SptaKernels::kBitpacked = {&thin, &scratch_words};

}  // namespace thinbench::detail
