// Files that appear whole or not at all.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "support/file_error.hpp"

namespace thinbench {

/// Where a path leads through symbolic links, whether or not there is a file. Throws FileError.
[[nodiscard]] std::string target_of(const std::string& path);

/// The same without links in directories and without dots: equal for all names of a file but hard
/// links. Throws FileError.
[[nodiscard]] std::string place_of(const std::string& path);

/// Rejects what writing would fail at after all the work: a directory that does not exist, one of
/// this name, a device, pipe or socket, an open file such as /dev/stdout, a file that the user
/// protected. Throws FileError.
void check_target(const std::string& path);

/// False, with errno, where not all could be written.
[[nodiscard]] bool write_all(int descriptor, std::string_view bytes);

/// Writes a hidden file beside the target, then gives it the target's place, or that of what the
/// target leads to through symbolic links. The mode, owner and group of a file that is replaced
/// remain. Where it has other names (hard links), or an owner that cannot be given to another file,
/// it is overwritten instead: room on the disk is taken first, and until all is written, the
/// finished file is also there as `path` + ".whole", which a kill or a failure leaves. Nothing is
/// left of the hidden file after a failure; after a kill, the next call for this target removes it.
/// Thread-safe. Throws FileError.
void write_whole_file(const std::string& path, std::string_view bytes);

/// The same with a function that writes the hidden file, whose extension is that of `path`.
void write_whole_file(const std::string& path,
                      const std::function<void(const std::string& name)>& write);

/// Removes the hidden files that killed programs left in a directory; those that another program is
/// writing remain.
void remove_abandoned_files(const std::string& directory);

}  // namespace thinbench
