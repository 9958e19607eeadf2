// The Euler number on vectors of packed words. Compiled per ISA.
//
// Cost per vector of 128, 256 or 512 pixels: 4 loads, 6 operations for west neighbours (2 with
// funnel shifts), 6 gates (4 with vpternlog) and two counts. Counts take 2 instructions with
// VPOPCNTDQ, else 9 for the difference of both, by a nibble table in byte shuffles. Below AVX2 a
// shuffle would count only 16 bytes; one popcnt per word is as fast, so the loop runs on 64-bit
// words.
#include <type_traits>

#include "core/exported.hpp"
#include "regions/euler.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

/// Counts a word, by popcnt where the ISA has it.
struct WordCounter {
  std::int64_t total = 0;
  [[gnu::always_inline]] void add(const EulerTerms<std::uint64_t>& terms) {
    total += __builtin_popcountll(terms.plus) - __builtin_popcountll(terms.minus);
  }
  [[nodiscard]] [[gnu::always_inline]] std::int64_t sum() const { return total; }
};

/// Counts each lane with one instruction.
template <class Word>
struct LaneCounter {
  Word total = Word(0);
  [[gnu::always_inline]] void add(const EulerTerms<Word>& terms) {
    total = total + popcounts(terms.plus) - popcounts(terms.minus);
  }
  [[nodiscard]] [[gnu::always_inline]] std::int64_t sum() const { return sum_of_lanes(total); }
};

constexpr std::uint8_t kNibbleCounts[] = {0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};

/// Sums nibble counts of `plus` and 4 minus those of `minus`, so that bytes do not become negative:
/// a byte is at most 16, and each lane is 64 too large.
template <class Word>
struct NibbleCounter {
  Word total = Word(0);
  std::int64_t lanes = 0;
  [[gnu::always_inline]] void add(const EulerTerms<Word>& terms) {
    const ByteBatch counts = byte_table(kNibbleCounts);
    const ByteBatch rest = ByteBatch(std::uint8_t{4}) - counts;
    const ByteBatch bytes =
        look_up_nibbles(counts, terms.plus) + look_up_nibbles(rest, terms.minus);
    total = total + byte_sums(bytes);
    lanes += static_cast<std::int64_t>(Word::size);
  }
  [[nodiscard]] [[gnu::always_inline]] std::int64_t sum() const {
    return sum_of_lanes(total) - lanes * kWordBits;
  }

 private:
  /// The sum of the entries of both nibbles of each byte.
  [[gnu::always_inline]] static ByteBatch look_up_nibbles(ByteBatch table, Word bits) {
    const ByteBatch low(std::uint8_t{15});
    return look_up(table, reinterpreted<ByteBatch>(bits) & low) +
           look_up(table, reinterpreted<ByteBatch>(bits >> 4) & low);
  }
};

using BatchCounter =
    std::conditional_t<kHasPopcount, LaneCounter<WordBatch>, NibbleCounter<WordBatch>>;
constexpr bool kCountsInBatches = kHasPopcount || kHasByteLookUp;
using CountedWord = std::conditional_t<kCountsInBatches, WordBatch, std::uint64_t>;
using Counter = std::conditional_t<kCountsInBatches, BatchCounter, WordCounter>;

template <class Connectivity>
std::int64_t count(const ConstBitPlaneView& image, Index first, Index last) {
  using Traits = WordTraits<CountedWord>;
  const Index words = image.width / kWordBits + 1;
  Counter counter;
  for (Index y = first; y < last; ++y) {
    const std::uint64_t* row = image.row(y);
    const std::uint64_t* above = image.row(y - 1);
    for (Index i = 0; i < words; i += Traits::kElements) {
      const CountedWord c = Traits::load(row + i);
      const CountedWord n = Traits::load(above + i);
      counter.add(Connectivity::terms(c, Traits::west(c, row + i), n, Traits::west(n, above + i)));
    }
  }
  return counter.sum();
}

}  // namespace

}  // namespace THINBENCH_ISA

template <>
constinit const EulerKernels Exported<EulerKernels, kThisIsa>::kKernels = {&count<EulerEight>,
                                                                           &count<EulerFour>};

}  // namespace thinbench::detail
