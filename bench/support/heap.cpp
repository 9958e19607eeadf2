#include "support/heap.hpp"

#include <malloc.h>

namespace thinbench {

std::optional<std::int64_t> heap_bytes_in_use() {
  const struct mallinfo2 heap = mallinfo2();
  const auto bytes = static_cast<std::int64_t>(heap.uordblks + heap.hblkhd);
  if (bytes == 0) return std::nullopt;
  return bytes;
}

}  // namespace thinbench
