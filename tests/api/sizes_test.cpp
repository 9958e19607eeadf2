// Images at the limits of sizes. Their memory takes pages only where it is written; the bit planes
// of one row take 4 GB.
#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>

#include <gtest/gtest.h>
#ifdef _WIN32
#include <windows.h>
#else
#include <sys/mman.h>
#endif

#include "support/variant_of.hpp"
#include "thinbench/packed.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

constexpr Index k2To31 = Index{1} << 31;

/// Zeros that the system provides when they are touched.
void* sparse_memory(std::size_t bytes) {
#ifdef _WIN32
  void* const memory = VirtualAlloc(nullptr, bytes, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE);
  if (memory == nullptr) throw std::runtime_error("no address space");
#else
  void* const memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                            MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) throw std::runtime_error("no address space");
#endif
  return memory;
}

void free_sparse_memory(void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef _WIN32
  VirtualFree(memory, 0, MEM_RELEASE);
#else
  munmap(memory, bytes);
#endif
}

class SparseMemory {
 public:
  explicit SparseMemory(Index bytes)
      : bytes_(static_cast<std::size_t>(bytes)), data_(sparse_memory(bytes_)) {}
  ~SparseMemory() { free_sparse_memory(data_, bytes_); }
  SparseMemory(const SparseMemory&) = delete;
  SparseMemory& operator=(const SparseMemory&) = delete;

  [[nodiscard]] std::uint8_t* data() const { return static_cast<std::uint8_t*>(data_); }

 private:
  std::size_t bytes_;
  void* data_;
};

constexpr Index kBlockBytes = 2;  // across
constexpr Index kBlock = 8 * kBlockBytes;

/// Fills the lowest 16 rows at most in the first and in the last 16 columns.
void draw_blocks(const PackedView& image) {
  for (Index y = std::max<Index>(0, image.height - kBlock); y < image.height; ++y) {
    for (Index i = 0; i < kBlockBytes; ++i) {
      image.row(y)[i] = 0xFF;
      image.row(y)[image.width / 8 - 1 - i] = 0xFF;
    }
  }
}

/// Thins in place, and compares both lower corners with those of a small image that is thinned
/// alone.
void expect_right(Index width, Index height, std::string_view technique, int threads) {
  const Index small_width = 4 * kBlock;
  const Index rows = std::min<Index>(height, 2 * kBlock);
  std::array<std::uint8_t, std::size_t{8 * kBlockBytes * kBlock}> small{};
  const PackedView expected(small.data(), small_width, rows, BitOrder::msb_first);
  draw_blocks(expected);
  thin_packed(Rule::guo_hall, expected, expected);

  const SparseMemory memory(packed_row_bytes(width) * height);
  const PackedView image(memory.data(), width, height, BitOrder::msb_first);
  draw_blocks(image);
  const detail::ThinningParameters parameters = detail::thinning_parameters(Rule::guo_hall, {});
  const auto variant = variant_of(variants_of(parameters), technique, {.threads = threads});
  make_state(variant, width, height, parameters, threads)->run(ConstPackedView(image), image);
  for (Index y = 0; y < rows; ++y) {
    const std::uint8_t* found = image.row(height - rows + y);
    for (Index i = 0; i < 2 * kBlockBytes; ++i) {
      EXPECT_EQ(found[i], expected.row(y)[i]) << i << ", " << y;
      EXPECT_EQ(found[width / 8 - 1 - i], expected.row(y)[small_width / 8 - 1 - i])
          << i << ", " << y;
    }
  }
}

TEST(Sizes, thin_is_right_on_more_than_2_to_31_pixels) {
  static_assert(Index{65600} * 32800 > k2To31);
  expect_right(65600, 32800, "simd_bitpacked", 1);
  expect_right(65600, 32800, "simd_bitpacked_tiles", 2);
}

TEST(Sizes, thin_is_right_on_one_row_of_nearly_2_to_31_pixels) {
  expect_right(k2To31 - 8, 1, "simd_bitpacked", 1);
}

TEST(Sizes, thin_is_right_on_one_column_of_millions_of_pixels) {
  const SparseMemory memory(Index{1} << 23);
  const ImageView image(memory.data(), 1, Index{1} << 23);
  for (Index y = 5; y < image.height - 5; ++y) image.row(y)[0] = 255;
  thin(Rule::zhang_suen, image, image);
  EXPECT_EQ(image.row(4)[0], 0);
  EXPECT_EQ(image.row(image.height / 2)[0], 255);
}

}  // namespace
}  // namespace thinbench
