// Reading of regular files. Devices and pipes are rejected: reading them might never end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "support/file_error.hpp"

namespace thinbench {

/// The size of a regular file that can be read. Throws FileError for everything else.
[[nodiscard]] std::int64_t regular_file_bytes(const std::string& path);

/// The first bytes of a regular file, `count` at most. Throws FileError.
[[nodiscard]] std::string beginning_of(const std::string& path, std::size_t count);

/// All bytes of a regular file. Throws FileError, too, if it has more than `max_bytes`.
[[nodiscard]] std::string read_whole_file(const std::string& path, std::size_t max_bytes);

/// A hash of all bytes of a regular file (content_hash.hpp). Throws FileError.
[[nodiscard]] std::uint64_t hash_of_file(const std::string& path);

/// Standard input, copied to a file in memory at the first call. Valid as long as the program.
/// Throws FileError, also where it has more than 2^32 bytes.
[[nodiscard]] std::string path_of_standard_input();

}  // namespace thinbench
