#include "batch/manifest.hpp"

#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <tuple>
#include <unordered_map>

#include <fcntl.h>
#include <unistd.h>

#include "support/file_bytes.hpp"
#include "support/whole_file.hpp"

namespace thinbench {

Manifest::Manifest(std::string path, bool resumes)
    : path_(std::move(path)), format_(table_format("--manifest", path_)), resumes_(resumes) {
  check_target(path_);
  const bool is_new = access(path_.c_str(), F_OK) != 0;
  file_.emplace(path_, path_, O_APPEND);
  try {
    read_lines();
    if (!resumes_) size_ = 0;
    if (!resumes_) lines_.clear();
    if (ftruncate(file_->descriptor(), static_cast<off_t>(size_)) != 0)
      cannot_write_by_errno(path_);
    if (size_ == 0) write_text(manifest_head(format_));
  } catch (...) {
    if (is_new) unlink(path_.c_str());
    throw;
  }
}

void Manifest::read_lines() {
  constexpr std::size_t max_bytes = 10'000'000'000;
  const FileBytes file = read_file(path_, max_bytes);
  try {
    ManifestText manifest = parse_manifest(file.text(), format_);
    size_ = manifest.size;
    for (ManifestLine& line : manifest.lines) {
      const Key key(line.output, line.page);
      lines_[key] = std::move(line);
    }
  } catch (const std::runtime_error& error) {
    cannot_write(path_, error.what());
  }
}

void Manifest::write_text(const std::string& text) {
  if (!write_all(file_->descriptor(), text)) {
    const int error = errno;
    static_cast<void>(!ftruncate(file_->descriptor(), static_cast<off_t>(size_)));
    errno = error;
    cannot_write_by_errno(path_);
  }
  size_ += text.size();
}

bool Manifest::says_done(const BatchJob& job, const std::string& operation) const {
  for (const int page : job.pages) {
    const auto found = lines_.find({job.output, page + 1});
    if (found == lines_.end()) return false;
    const ManifestLine& line = found->second;
    if (line.failed || line.file != job.path || line.operation != operation) return false;
  }
  return true;
}

void Manifest::append(const BatchRecord& record) {
  const std::string text = manifest_line(record, format_);
  write_text(text);
  lines_[{record.output, record.page}] = {resumes_ ? text : "", record.file,
                                          record.output,        record.page,
                                          record.operation,     !record.error.empty()};
}

void Manifest::put_in_order(const std::vector<BatchJob>& jobs) {
  if (!resumes_) return;
  std::unordered_map<std::string, std::size_t> position_of;
  for (const BatchJob& job : jobs) position_of.emplace(job.output, position_of.size() + 1);
  std::map<std::tuple<std::size_t, std::string, int>, const std::string*> ordered;
  for (const auto& [key, line] : lines_) {
    const auto found = position_of.find(key.first);
    const std::size_t position = found == position_of.end() ? 0 : found->second;
    ordered[{position, key.first, key.second}] = &line.text;
  }
  std::string text = manifest_head(format_);
  for (const auto& [position, line] : ordered) text += *line;
  write_whole_file(path_, text);
}

}  // namespace thinbench
