#include "out_of_core/work_files.hpp"

#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include "support/whole_file.hpp"

namespace thinbench {
namespace {

/// The bytes on disk that a file takes already; 0 if there is none.
Index allocated_bytes(const std::string& path) {
  struct stat facts {};
  return stat(path.c_str(), &facts) == 0 ? static_cast<Index>(facts.st_blocks) * 512 : 0;
}

std::string directory_of(const std::string& path) {
  const std::string directory = std::filesystem::path(path).parent_path().string();
  return directory.empty() ? "." : directory;
}

std::string megabytes(Index bytes) {
  return fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

}  // namespace

WorkFiles::WorkFiles(const std::string& in, const std::string& out, const PackedFormat& format,
                     Conversion conversion, int files)
    : in_(in), out_(out), format_(format), conversion_(std::move(conversion)) {
  check_target(out);
  const std::string target = target_of(out);
  const std::string base = fmt::format("{}/.{}.thinbench-", directory_of(target),
                                       std::filesystem::path(target).filename().string());
  names_ = {base + "a", base + "b"};
  state_name_ = base + "state";
  check_space(files);
  lock_.emplace(names_[0], out);
  new_file_.emplace(base + "new");
}

WorkFiles::~WorkFiles() = default;

void WorkFiles::check_space(int files) const {
  struct statvfs facts {};
  const std::string directory = directory_of(names_[0]);
  if (statvfs(directory.c_str(), &facts) != 0) return;  // writing will fail or not
  const Index free = static_cast<Index>(facts.f_bavail) * static_cast<Index>(facts.f_frsize) +
                     allocated_bytes(names_[0]) + allocated_bytes(names_[1]);
  const Index needed = files * format_.file_bytes();
  if (needed <= free) return;
  throw FileError(fmt::format("cannot write '{}': the work files need {}, '{}' has {} free", out_,
                              megabytes(needed), directory, megabytes(free)));
}

std::optional<Checkpoint> WorkFiles::load(const std::string& identity,
                                          const CheckpointLimits& limits) const {
  return load_checkpoint(state_name_, identity, limits);
}

void WorkFiles::drop_checkpoint() {
  unlink(state_name_.c_str());
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (!unfinished_[i]) unfinished_[i].emplace(names_[i]);
  }
}

PackedFile WorkFiles::open_input() const {
  if (!conversion_.unpack) return PackedFile::open(in_, format_);
  PackedFile file = PackedFile::create(names_[1], format_);
  conversion_.unpack(file);
  return file;
}

void WorkFiles::open(int pass, bool new_target) {
  source_ = pass == 0
                ? open_input()
                : PackedFile::reopen(names_[static_cast<std::size_t>((pass - 1) % 2)], format_);
  const std::string& name = names_[static_cast<std::size_t>(pass % 2)];
  target_ = new_target ? PackedFile::create(name, format_) : PackedFile::reopen(name, format_);
}

void WorkFiles::save(const std::string& identity, const Checkpoint& checkpoint) {
  target_.synchronise();
  save_checkpoint(new_file_->name(), identity, checkpoint);
  replace_file(state_name_, new_file_->name());
  for (std::optional<UnfinishedFile>& file : unfinished_) {
    if (file) file->keep();
    file.reset();
  }
}

// A target that becomes the output is no longer there for a checkpoint, which is removed first: a
// run killed in between begins again, from an unchanged input.
void WorkFiles::finish() {
  if (conversion_.pack) {
    conversion_.pack(target_, new_file_->name());
    replace_file(out_, new_file_->name());
    drop_checkpoint();
  } else {
    drop_checkpoint();
    replace_file(out_, target_.path());
  }
}

}  // namespace thinbench
