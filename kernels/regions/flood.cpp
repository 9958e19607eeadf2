// Filling holes by flooding the background of a packed image from its border, row by row. Compiled
// per ISA.
//
// Runs of a row fill at once: an addition carries a seed to the end of its run, towards high bits;
// the other way it takes a reversal of the row, or gathering and scattering the ends of runs. What
// is flooded is 0 in the result, as are the margin and the padding of a plane: the outside.
//
// Cost: per visit of 64 pixels 12 instructions to spread towards high bits and 10 to 35 back, or
// per 512 pixels about 40 where a register holds them; images of parts take two to three visits of
// a row, most of which only test whether there is anything to spread: 4 instructions.
#include <algorithm>

#include "core/exported.hpp"
#include "regions/fill_kernels.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

/// Seeds and what follows them in their runs of open bits, given the sum of both.
template <class Word>
[[gnu::always_inline]] inline Word with_followers(Word open, Word seeds, Word sum) {
  return ((sum ^ open) | seeds) & open;
}

/// Spreads seeds along the runs of a word.
struct WordFlood {
  using Word = std::uint64_t;

  /// Towards high bits; the carry enters at the lowest bit and is 1 if the highest one is reached.
  [[gnu::always_inline]] static Word up(Word open, Word seeds, std::uint64_t& carry) {
    unsigned long long sum = 0;
    const bool first = __builtin_uaddll_overflow(open, seeds, &sum);
    const bool second = __builtin_uaddll_overflow(sum, carry, &sum);
    const Word reached = with_followers<Word>(open, seeds, sum);
    carry = first || second ? 1 : 0;
    return reached;
  }

  /// Towards low bits, after up(): a run with a reached pixel becomes reached from end to end.
  [[gnu::always_inline]] static Word down(Word open, Word reached, std::uint64_t& carry) {
    Word all = runs_with(open, reached);
    if (__builtin_expect((carry & (open & ~all) >> 63) != 0, 0)) all |= highest_run(open);
    carry = all & 1;
    return all;
  }

 private:
  [[gnu::always_inline]] static Word runs_with(Word open, Word reached) {
    if constexpr (kHasBitGather) {
      const Word starts = open & ~(open << 1);
      const Word ends = open & ~(open >> 1);
      // Rank by rank, from ends to starts; the difference of powers of two is a run.
      const Word selected = reached & ends;
      return (selected << 1) - scatter_bits(gather_bits(selected, ends), starts);
    } else {
      Word passing = open;
      for (int distance = 1; distance < kWordBits; distance *= 2) {
        reached |= passing & reached >> distance;
        passing &= passing >> distance;
      }
      return reached;
    }
  }

  /// The run of open bits at the highest bit, which is open.
  [[gnu::always_inline]] static Word highest_run(Word open) {
    if (~open == 0) return open;
    return ~(~Word{0} >> __builtin_clzll(~open));
  }
};

/// The same for eight words. A template, as other ISAs lack what it calls.
template <class Block>
struct BlockFlood {
  using Word = Block;

  [[gnu::always_inline]] static Word up(Word open, Word seeds, std::uint64_t& carry) {
    return with_followers(open, seeds, sum_with_carry(open, seeds, carry));
  }
  [[gnu::always_inline]] static Word down(Word open, Word reached, std::uint64_t& carry) {
    return reversed(up(reversed(open), reversed(reached), carry));
  }
};

template <class Spread, bool with_corners>
class Flood {
 public:
  Flood(const ConstBitPlaneView& image, const BitPlaneView& filled)
      : image_(image), filled_(filled), words_(whole_words(image.width)) {}

  /// False if it takes too many visits.
  bool operator()() {
    const Index middle = (image_.height + 1) / 2;
    for (Index y = 0; y < middle; ++y) {
      const Index mirrored = image_.height - 1 - y;
      spread<true>(y, y - 1);
      if (mirrored > y) spread<true>(mirrored, mirrored + 1);
    }
    Rows from_above = {middle, image_.height - 1};
    Rows from_below = {0, middle - 1};
    Index left = (kMaxFloodVisits - 1) * image_.height;
    while (left > 0 && !(from_above.empty() && from_below.empty())) {
      const Rows lowered = scan<1>(from_above, left);
      from_below.add(lowered.first - 1, lowered.last - 1);
      from_above = {};
      const Rows raised = scan<-1>(from_below, left);
      from_above.add(raised.first + 1, raised.last + 1);
      from_below = {};
    }
    return from_above.empty();
  }

 private:
  using Word = typename Spread::Word;
  using Traits = WordTraits<Word>;

  struct Rows {
    Index first = kNone;
    Index last = -kNone;

    static constexpr Index kNone = Index{1} << 40;
    [[nodiscard]] bool empty() const { return first > last; }
    void add(Index other_first, Index other_last) {
      first = std::min(first, other_first);
      last = std::max(last, other_last);
    }
  };

  [[nodiscard]] static Index whole_words(Index width) {
    const Index words = (width + kWordBits - 1) / kWordBits;
    return (words + Traits::kElements - 1) / Traits::kElements * Traits::kElements;
  }

  /// Visits `rows`, and those after them as long as rows change, each after the row `step` before
  /// it. Returns the rows that changed.
  template <Index step>
  [[gnu::always_inline]] Rows scan(const Rows& rows, Index& left) {
    Rows changed;
    const Index end = step > 0 ? image_.height : -1;
    const Index last = step > 0 ? rows.last : rows.first;
    if (rows.empty()) return changed;
    Index y = std::clamp<Index>(step > 0 ? rows.first : rows.last, 0, image_.height - 1);
    for (bool spreads = false; y != end && (spreads || (last - y) * step >= 0); y += step) {
      --left;
      spreads = has_entries(y, y - step);
      if (!spreads) continue;
      spread<false>(y, y - step);
      changed.add(y, y);
    }
    return changed;
  }

  /// Where the row beside is not flooded.
  [[gnu::always_inline]] static Word dry(const std::uint64_t* beside) {
    const Word here = Traits::load(beside);
    if constexpr (!with_corners) return here;
    return here & Traits::west(here, beside) & Traits::east(here, beside);
  }

  /// Whether the flood enters row y from the row beside.
  [[gnu::always_inline]] bool has_entries(Index y, Index beside) const {
    const std::uint64_t* const row = image_.row(y);
    const std::uint64_t* const from = filled_.row(beside);
    const std::uint64_t* const own = filled_.row(y);
    Word entries = Traits::zero();
    for (Index word = 0; word < words_; word += Traits::kElements) {
      entries =
          entries | (Traits::load(own + word) & ~(Traits::load(row + word) | dry(from + word)));
    }
    return Traits::any(entries);
  }

  /// Floods row y from the row beside, and from where it is flooded unless this is the first time.
  template <bool first>
  [[gnu::always_inline]] void spread(Index y, Index beside) {
    const std::uint64_t* const row = image_.row(y);
    const std::uint64_t* const from = filled_.row(beside);
    std::uint64_t* const own = filled_.row(y);
    std::uint64_t carry = 1;  // from the outside
    for (Index word = 0; word < words_; word += Traits::kElements) {
      const Word open = ~Traits::load(row + word);
      Word closed_or_dry = dry(from + word);
      if constexpr (!first) closed_or_dry = closed_or_dry & Traits::load(own + word);
      Traits::store(own + word, Spread::up(open, open & ~closed_or_dry, carry));
    }
    carry = 1;
    for (Index word = words_ - Traits::kElements; word >= 0; word -= Traits::kElements) {
      const Word open = ~Traits::load(row + word);
      Traits::store(own + word, ~Spread::down(open, Traits::load(own + word), carry));
    }
  }

  ConstBitPlaneView image_;
  BitPlaneView filled_;
  Index words_;
};

/// For so many pixels words take less time than a register of 512.
constexpr Index kMaxWidthOfWords = 256;

template <bool with_corners>
bool flood(const ConstBitPlaneView& image, const BitPlaneView& filled) {
  if constexpr (kRegisterHoldsRow) {
    if (image.width > kMaxWidthOfWords) {
      return Flood<BlockFlood<WordBatch>, with_corners>(image, filled)();
    }
  }
  return Flood<WordFlood, with_corners>(image, filled)();
}

}  // namespace

}  // namespace THINBENCH_ISA

template <>
constinit const FloodKernels Exported<FloodKernels, kThisIsa>::kKernels = {
    &THINBENCH_ISA::flood<false>, &THINBENCH_ISA::flood<true>};

}  // namespace thinbench::detail
