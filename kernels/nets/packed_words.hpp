// Rows of packed words decided one word at a time: what the nets on packed bits share.
#pragma once

#include "core/word.hpp"
#include "nets/weights.hpp"

namespace thinbench {

/// The neighbours of 64 packed pixels, in the order of the descriptor.
struct PackedNeighbours {
  std::uint64_t n[kNetInputs];
};

[[gnu::always_inline]] inline PackedNeighbours packed_neighbours(const std::uint64_t* here,
                                                                 Index stride) {
  using Traits = WordTraits<std::uint64_t>;
  const std::uint64_t* above = here - stride;
  const std::uint64_t* below = here + stride;
  return {{Traits::east(*here, here), Traits::east(*above, above), *above,
           Traits::west(*above, above), Traits::west(*here, here), Traits::west(*below, below),
           *below, Traits::east(*below, below)}};
}

/// New words [from, to) of a row: `decide(dark, here)` gives the pixels that stay, garbage where no
/// pixel is dark. True where one changed.
template <class Decide>
[[gnu::always_inline]] inline bool decide_words(const std::uint64_t* source, std::uint64_t* target,
                                                Index from, Index to, const Decide& decide) {
  std::uint64_t changed = 0;
  for (Index x = from; x < to; ++x) {
    const std::uint64_t dark = source[x];
    const std::uint64_t next = dark == 0 ? 0 : dark & decide(dark, source + x);
    changed |= dark ^ next;
    target[x] = next;
  }
  return changed != 0;
}

}  // namespace thinbench
