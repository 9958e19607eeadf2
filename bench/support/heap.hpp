// How much memory the program has asked for.
#pragma once

#include <cstdint>
#include <optional>

namespace thinbench {

/// Bytes of the C library's heap that are in use; nothing where another allocator stands in for it,
/// as under sanitizers.
[[nodiscard]] std::optional<std::int64_t> heap_bytes_in_use();

}  // namespace thinbench
