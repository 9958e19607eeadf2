#include "counts/executed_code.hpp"

#include <array>

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

namespace thinbench {
namespace {

TEST(ExecutedCode, names_each_instruction_once_and_loops_by_their_repetitions) {
  alignas(64) static const std::array<std::uint8_t, 64> code{1, 2, 3, 4, 5, 6};
  const auto start = reinterpret_cast<std::uint64_t>(code.data());
  const ExecutedCode executed =
      executed_code({start, start + 2, start, start + 2, start + 2, start + 5, start});
  EXPECT_EQ(executed.order, "0-1*2 1-2*1 0-0*1");
  EXPECT_EQ(executed.instructions,
            "010203040506000000000000000000 030405060000000000000000000000 "
            "060000000000000000000000000000");
}

TEST(ExecutedCode, bytes_end_where_memory_does) {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  void* pages = mmap(nullptr, 2 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(pages, MAP_FAILED);
  ASSERT_EQ(munmap(static_cast<char*>(pages) + page, page), 0);
  EXPECT_EQ(executed_code({reinterpret_cast<std::uint64_t>(pages) + page - 3}).instructions,
            "000000");
  munmap(pages, page);
}

}  // namespace
}  // namespace thinbench
