// Runs and contacts as in run_bits.hpp, eight words at a time. For ISA files only.
#pragma once

#include "core/byte_image.hpp"
#include "regions/run_numbers.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

/// Whether the ISA has what this header uses.
inline constexpr bool kHasRunBlocks = kRegisterHoldsRow && kHasPopcount;

/// Follow for blocks. A template, as are all functions here: other ISAs lack what they call.
template <class Block>
class FollowInBlocks {
 public:
  [[gnu::always_inline]] Block operator()(Block seeds, Block stops) {
    const Block open = ~stops;
    const Block entries = west_neighbour<1>(seeds, previous_word(seeds, before_)) & open;
    before_ = seeds;
    const std::uint64_t carry = carry_;
    const Block sum = sum_with_carry(open, entries, carry_);
    return ((sum ^ open) | entries | lowest_word<Block>(carry)) & open;
  }

 private:
  Block before_ = Block(0);
  std::uint64_t carry_ = 0;
};

/// Where the runs of a band begin.
template <BandKind band, class Block>
[[gnu::always_inline]] inline Block starts_of_block(const std::uint64_t* top, Index stride) {
  const auto merged = [&](Index offset) {
    const Block bits = Block::load_unaligned(top + offset);
    return band == BandKind::pair ? bits | Block::load_unaligned(top + stride + offset) : bits;
  };
  const Block bits = merged(0);
  return bits & ~west_neighbour<1>(bits, merged(-1));
}

template <BandKind band, class Block>
[[gnu::always_inline]] inline Block contacts_of_block(const std::uint64_t* upper,
                                                      const std::uint64_t* lower) {
  const Block above = Block::load_unaligned(upper);
  const Block here = Block::load_unaligned(lower);
  if constexpr (band == BandKind::row) return above & here;
  return (above & (here | WordTraits<Block>::west(here, lower))) |
         (here & WordTraits<Block>::west(above, upper));
}

/// A block in memory, for the words that have contacts.
struct BlockWords {
  alignas(kAlignment) std::uint64_t words[kBlockWords];

  template <class Block>
  [[gnu::always_inline]] void operator=(Block block) {
    block.store_aligned(words);
  }
};

/// As unite_band().
template <BandKind band, class Block>
[[gnu::always_inline]] inline void unite_band_in_blocks(const ConstBitPlaneView& image,
                                                        Index number, const RunForest& runs) {
  const Index height = rows_of(band);
  FollowInBlocks<Block> in_both, in_lower;
  BlockWords upper_words, lower_words, first_words, later_words, before_upper, before_lower;
  Label before_above = runs.first[number - 1] - 1;
  Label before_here = runs.first[number] - 1;
  for (Index word = 0; word < words_of(image); word += kBlockWords) {
    const std::uint64_t* const above = image.row((number - 1) * height) + word;
    const std::uint64_t* const here = image.row(number * height) + word;
    const Block upper = starts_of_block<band, Block>(above, image.stride);
    const Block lower = starts_of_block<band, Block>(here, image.stride);
    const Block all = contacts_of_block<band, Block>(here - image.stride, here);
    const Block distinct = all & ~in_both(all, upper | lower);
    const Block later = distinct & in_lower(distinct, lower);
    const Block upper_counts = popcounts(upper), lower_counts = popcounts(lower);
    upper_words = upper;
    lower_words = lower;
    first_words = distinct & ~later;
    later_words = later;
    before_upper = sums_before(upper_counts);
    before_lower = sums_before(lower_counts);
    for (std::uint32_t left = nonzero_lanes(distinct); left != 0; left &= left - 1) {
      const auto i = static_cast<unsigned>(__builtin_ctz(left));
      join_runs(runs.parents,
                {upper_words.words[i], lower_words.words[i],
                 before_above + static_cast<Label>(before_upper.words[i]),
                 before_here + static_cast<Label>(before_lower.words[i])},
                first_words.words[i], later_words.words[i]);
    }
    before_above += static_cast<Label>(before_upper.words[7]) + count_bits(upper_words.words[7]);
    before_here += static_cast<Label>(before_lower.words[7]) + count_bits(lower_words.words[7]);
  }
}

/// As mark_first_row(), where the ISA can compress: in the order of their last bits, which is that
/// of runs.
template <class Batch>
[[gnu::always_inline]] inline Label mark_first_row_in_lanes(const ConstBitPlaneView& image,
                                                            Index number, const RunForest& runs) {
  constexpr Index lanes = static_cast<Index>(Batch::size);
  const Batch mark(kInFirstRow);
  BandBits<BandKind::pair> here(image, number);
  Follow in_run;
  Label* ids = runs.ids + runs.first[number];
  Label marked = 0;
  for (Index word = 0; word < words_of(image); ++word) {
    const std::uint64_t merged = here.merged(word);
    const std::uint64_t ends = merged & ~(merged >> 1 | here.merged(word + 1) << 63);
    const std::uint64_t top = here.top(word);
    const std::uint64_t first = ends & (top | in_run(top, here.starts(word)));
    for (Index x = 0; x < kWordBits; x += lanes) {
      const auto selected =
          static_cast<std::uint32_t>(ends >> x & ((std::uint64_t{1} << lanes) - 1));
      store_compressed(ids, permuted_where(mark, Batch(0), static_cast<std::uint32_t>(first >> x)),
                       selected);
      ids += count_bits(selected);
    }
    marked += count_bits(first);
  }
  return marked;
}

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
