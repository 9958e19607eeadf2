// Conversions between byte images and planes, compiled once for every instruction-set level.
//
// Packing compares 64 bytes with zero and keeps one bit of each: 1 (AVX-512), 2 (AVX2) or 4 (SSE2)
// comparisons and mask moves for a word. Unpacking spreads the bits again: a mask move on AVX-512,
// else each byte of the word is broadcast to the lanes of its bits and tested there. Both are bound
// by the bytes moved, 1 byte a pixel. Prefetching the rows kBytesAhead further on took an eighth
// off packing 21 MB that no cache held; past the caches (prefetchnta) it took twice as long. Moving
// whole cache lines instead of 64 bytes that cross two, the bits of each put together from two
// words, took the same time.
#include "image/packing.hpp"

#include "simd/batch.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

constexpr Index kLanes = static_cast<Index>(ByteBatch::size);

constexpr Index kBytesAhead = 4096;

/// Bit i is set where byte i is not zero, for the first kLanes bytes.
[[gnu::always_inline]] inline std::uint64_t dark_mask(const std::uint8_t* bytes) {
#if defined(__AVX512BW__)
  const __m512i lanes = _mm512_loadu_si512(bytes);
  return _mm512_test_epi8_mask(lanes, lanes);
#elif defined(__AVX2__)
  const __m256i lanes = ByteBatch::load_unaligned(bytes);
  const auto light = _mm256_movemask_epi8(_mm256_cmpeq_epi8(lanes, _mm256_setzero_si256()));
  return ~static_cast<std::uint32_t>(light);
#else
  const __m128i lanes = ByteBatch::load_unaligned(bytes);
  const auto light = _mm_movemask_epi8(_mm_cmpeq_epi8(lanes, _mm_setzero_si128()));
  return static_cast<std::uint16_t>(~light);
#endif
}

[[gnu::always_inline]] inline std::uint64_t pack_word(const std::uint8_t* bytes) {
  std::uint64_t word = 0;
  for (Index lane = 0; lane < kWordBits; lane += kLanes) word |= dark_mask(bytes + lane) << lane;
  return word;
}

[[gnu::always_inline]] inline void unpack_word(std::uint64_t word, std::uint8_t* bytes) {
  for (Index lane = 0; lane < kWordBits; lane += kLanes) {
    spread_bits(word >> lane).store_unaligned(bytes + lane);
  }
}

// The last word of a row covers bytes that belong to somebody else. Rows of at least 64 pixels take
// the 64 bytes that end with the row and shift (going through a buffer made the conversions of
// rows of 510 pixels about half as slow again: 64 bytes loaded just after they were stored in
// pieces); narrow rows use the buffer.

std::uint64_t pack_tail(const std::uint8_t* row, Index width, Index tail) {
  if (width >= kWordBits) return pack_word(row + width - kWordBits) >> (kWordBits - tail);
  std::uint8_t buffer[kWordBits] = {};
  for (Index i = 0; i < tail; ++i) buffer[i] = row[i];
  return pack_word(buffer);
}

/// A store past the caches; `bytes` is aligned to the lanes.
[[gnu::always_inline]] inline void stream(ByteBatch lanes, std::uint8_t* bytes) {
#if defined(__AVX512BW__)
  _mm512_stream_si512(reinterpret_cast<__m512i*>(bytes), lanes);
#elif defined(__AVX2__)
  _mm256_stream_si256(reinterpret_cast<__m256i*>(bytes), lanes);
#else
  _mm_stream_si128(reinterpret_cast<__m128i*>(bytes), lanes);
#endif
}

bool can_be_streamed(const ImageView& target) {
  const auto misaligned =
      reinterpret_cast<std::uintptr_t>(target.data) | static_cast<std::uintptr_t>(target.stride);
  return misaligned % kLanes == 0;
}

void unpack_some(std::uint64_t word, std::uint8_t* bytes, Index count) {
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

// Sizes are copied to locals: a store of bytes could otherwise be taken to change them.
void read_bits(const ConstImageView& source, const BitPlaneView& target) {
  const Index height = source.height;
  const Index words = source.width / kWordBits;
  const Index tail = source.width % kWordBits;
  // In whole rows: what lies between the rows of a part of a wider image is not wanted. It may lie
  // past the image, where a prefetch does nothing.
  const Index ahead = source.width == 0 ? 0 : (kBytesAhead / source.width + 1) * source.stride;
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

void write_bits(const ConstBitPlaneView& source, const ImageView& target, bool streamed) {
  const Index height = source.height;
  const Index words = source.width / kWordBits;
  const Index tail = source.width % kWordBits;
  for (Index y = 0; y < height; ++y) {
    const std::uint64_t* row = source.row(y);
    std::uint8_t* bytes = target.row(y);
    if (streamed) {
      for (Index x = 0; x < words * kWordBits; x += kLanes) {
        stream(spread_bits(row[x / kWordBits] >> (x % kWordBits)), bytes + x);
      }
      // Nothing that was streamed is touched again.
      if (tail > 0) unpack_some(row[words], bytes + words * kWordBits, tail);
    } else {
      for (Index word = 0; word < words; ++word) unpack_word(row[word], bytes + word * kWordBits);
      if (tail > 0) unpack_tail(row + words, bytes, source.width, tail);
    }
  }
  if (streamed) _mm_sfence();
}

void write_streamed_bits(const ConstBitPlaneView& source, const ImageView& target) {
  write_bits(source, target, can_be_streamed(target));
}

void write_bits_by_size(const ConstBitPlaneView& source, const ImageView& target) {
  const bool large = target.width * target.height >= kStreamedBytes;
  write_bits(source, target, large && can_be_streamed(target));
}

void read_bytes(const ConstImageView& source, const BytePlaneView& target) {
  const Index width = source.width;
  const Index height = source.height;
  for (Index y = 0; y < height; ++y) {
    const std::uint8_t* __restrict from = source.row(y);
    std::uint8_t* __restrict to = target.row(y);
    for (Index x = 0; x < width; ++x) to[x] = from[x] != 0 ? 1 : 0;
  }
}

void write_bytes(const ConstBytePlaneView& source, const ImageView& target) {
  const Index width = source.width;
  const Index height = source.height;
  for (Index y = 0; y < height; ++y) {
    const std::uint8_t* __restrict from = source.row(y);
    std::uint8_t* __restrict to = target.row(y);
    for (Index x = 0; x < width; ++x) to[x] = static_cast<std::uint8_t>(-from[x]);
  }
}

}  // namespace

}  // namespace THINBENCH_ISA

template <>
constinit const PlaneConversions Exported<PlaneConversions, kThisIsa>::kKernels = {
    {&read_bytes, &write_bytes, &write_bytes},
    {&read_bits, &write_bits_by_size, &write_streamed_bits}};

}  // namespace thinbench::detail
