// Conversions between byte images and planes. Compiled per ISA.
//
// Packing compares 64 bytes with zero and keeps one bit of each: 1 (AVX-512), 2 (AVX2) or 4 (SSE2)
// comparisons and mask moves per word. Unpacking is a mask move on AVX-512; elsewhere each byte of
// the word is broadcast to the lanes of its bits and tested there. Both are limited by memory
// traffic of 1 byte per pixel. Rows are prefetched kPrefetchBytes ahead.
// What was tried: docs/experiments.md#packing.
#include "core/packing.hpp"

#include "simd/vector.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

constexpr Index kPrefetchBytes = 4096;

/// Bit i is set where byte i is not zero, for the first kBatchBytes bytes.
[[gnu::always_inline]] inline std::uint64_t foreground_bits(const std::uint8_t* bytes) {
  return nonzero_bits(ByteBatch::load_unaligned(bytes));
}

[[gnu::always_inline]] inline std::uint64_t pack_word(const std::uint8_t* bytes) {
  std::uint64_t word = 0;
  for (Index lane = 0; lane < kWordBits; lane += kBatchBytes) {
    word |= foreground_bits(bytes + lane) << lane;
  }
  return word;
}

[[gnu::always_inline]] inline void unpack_word(std::uint64_t word, std::uint8_t* bytes) {
  for (Index lane = 0; lane < kWordBits; lane += kBatchBytes) {
    spread_bits(word >> lane).store_unaligned(bytes + lane);
  }
}

// The last word of a row covers bytes past the row, which must not be accessed. Where there are no
// masked loads and stores, rows of at least 64 pixels use the last 64 bytes of the row and shift;
// only narrower rows go through a buffer, which made rows of 510 pixels about 1.5 times as slow, as
// 64 bytes stored in pieces are loaded at once.

std::uint64_t pack_tail(const std::uint8_t* row, Index width, Index tail) {
  if constexpr (kHasMaskedBytes) {
    return load_nonzero_bits(row + width - tail, (std::uint64_t{1} << tail) - 1);
  }
  if (width >= kWordBits) return pack_word(row + width - kWordBits) >> (kWordBits - tail);
  std::uint8_t buffer[kWordBits] = {};
  for (Index i = 0; i < tail; ++i) buffer[i] = row[i];
  return pack_word(buffer);
}

bool allows_non_temporal_stores(const ImageView& target) {
  const auto misaligned =
      reinterpret_cast<std::uintptr_t>(target.data) | static_cast<std::uintptr_t>(target.stride);
  return misaligned % kBatchBytes == 0;
}

void unpack_some(std::uint64_t word, std::uint8_t* bytes, Index count) {
  if constexpr (kHasMaskedBytes) {
    store_spread_bits(bytes, word, (std::uint64_t{1} << count) - 1);
    return;
  }
  std::uint8_t buffer[kWordBits];
  unpack_word(word, buffer);
  for (Index i = 0; i < count; ++i) bytes[i] = buffer[i];
}

/// `word` points to the last word, which holds `tail` pixels.
void unpack_tail(const std::uint64_t* word, std::uint8_t* row, Index width, Index tail) {
  if (width >= kWordBits) {
    unpack_word(word[-1] >> tail | word[0] << (kWordBits - tail), row + width - kWordBits);
    return;
  }
  unpack_some(*word, row, tail);
}

// Sizes are copied to locals because byte stores could alias them.
void read_bits(const ConstImageView& source, const BitPlaneView& target) {
  if (source.width == 0) return;  // such rows need no memory
  const Index height = source.height;
  const Index words = source.width / kWordBits;
  const Index tail = source.width % kWordBits;
  // Whole rows ahead, to skip the bytes between the rows of a view of a wider image; none where the
  // image has fewer, whose stride may be so large that the product overflows. Prefetching past the
  // image is harmless.
  const Index rows_ahead = kPrefetchBytes / source.width + 1;
  const Index ahead = rows_ahead < height ? rows_ahead * source.stride : 0;
  for (Index y = 0; y < height; ++y) {
    const std::uint8_t* bytes = source.row(y);
    std::uint64_t* row = target.row(y);
    for (Index word = 0; word < words; ++word) {
      __builtin_prefetch(bytes + word * kWordBits + ahead);
      row[word] = pack_word(bytes + word * kWordBits);
    }
    if (tail > 0) row[words] = pack_tail(bytes, source.width, tail);
  }
}

void write_bits(const ConstBitPlaneView& source, const ImageView& target, bool non_temporal) {
  if (source.width == 0) return;  // such rows need no memory
  const Index height = source.height;
  const Index words = source.width / kWordBits;
  const Index tail = source.width % kWordBits;
  for (Index y = 0; y < height; ++y) {
    const std::uint64_t* row = source.row(y);
    std::uint8_t* bytes = target.row(y);
    if (non_temporal) {
      for (Index x = 0; x < words * kWordBits; x += kBatchBytes) {
        store_non_temporal(bytes + x, spread_bits(row[x / kWordBits] >> (x % kWordBits)));
      }
      // Not unpack_tail, which would write again to lines already stored non-temporally.
      if (tail > 0) unpack_some(row[words], bytes + words * kWordBits, tail);
    } else {
      for (Index word = 0; word < words; ++word) unpack_word(row[word], bytes + word * kWordBits);
      if (tail > 0) unpack_tail(row + words, bytes, source.width, tail);
    }
  }
  if (non_temporal) finish_non_temporal_stores();
}

void write_non_temporal_bits(const ConstBitPlaneView& source, const ImageView& target) {
  write_bits(source, target, allows_non_temporal_stores(target));
}

void write_bits_by_size(const ConstBitPlaneView& source, const ImageView& target) {
  const bool large = target.width * target.height >= kNonTemporalBytes;
  write_bits(source, target, large && allows_non_temporal_stores(target));
}

}  // namespace

}  // namespace THINBENCH_ISA

template <>
constinit const PlaneConversion<std::uint64_t>
    Exported<PlaneConversion<std::uint64_t>, kThisIsa>::kKernels = {&read_bits, &write_bits_by_size,
                                                                    &write_non_temporal_bits};

}  // namespace thinbench::detail
