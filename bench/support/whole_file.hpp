// Files that appear whole or not at all.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace thinbench {

/// Why a file could not be written: one line that names it.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Rejects what writing would fail at after all the work: a directory that does not exist, one of
/// this name, a file that the user protected. Throws FileError.
void check_target(const std::string& path);

/// Writes a hidden file beside `path`, then renames it; nothing is left of it after a failure.
/// Thread-safe. Throws FileError.
void write_whole_file(const std::string& path, std::string_view bytes);

/// The same with a function that writes the hidden file, whose extension is that of `path`.
void write_whole_file(const std::string& path,
                      const std::function<void(const std::string& name)>& write);

/// Removes the hidden files that killed programs left in a directory; those that another program is
/// writing remain.
void remove_abandoned_files(const std::string& directory);

}  // namespace thinbench
