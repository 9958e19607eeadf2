#include "batch/jobs.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <system_error>
#include <unordered_map>
#include <utility>

#include <sys/stat.h>

#include "images/codecs.hpp"
#include "support/text.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

/// What two names of one file have in common.
using FileId = std::pair<dev_t, ino_t>;

std::optional<FileId> id_of(const std::string& path) {
  struct stat facts {};
  if (stat(path.c_str(), &facts) != 0) return std::nullopt;
  return FileId(facts.st_dev, facts.st_ino);
}

BatchJob job_of(const BatchInput& input, const std::string& suffix,
                const ResultExtensions& extensions) {
  const std::string name = input.name + suffix;
  BatchJob job;
  job.path = input.path;
  job.output = name + extensions.output;
  if (!extensions.overlay.empty()) job.overlay = name + extensions.overlay;
  return job;
}

/// Only files whose name says that they are TIFF are looked at.
std::vector<int> pages_of(const std::string& path) {
  if (!is_tiff_extension(extension_of(path))) return {0};
  try {
    return pages_in(read_file(path));
  } catch (const FileError&) {
    return {0};  // reading it gives the reason
  }
}

std::vector<BatchJob> jobs_of_one(const BatchInput& input, const ResultExtensions& extensions,
                                  bool joins_pages) {
  const std::vector<int> pages = pages_of(input.path);
  std::vector<BatchJob> jobs;
  if (pages.size() == 1 || joins_pages) {
    jobs.push_back(job_of(input, "", extensions));
    jobs.back().pages = pages;
    return jobs;
  }
  for (const int page : pages) {
    jobs.push_back(job_of(input, "_page" + std::to_string(page + 1), extensions));
    jobs.back().pages = {page};
  }
  return jobs;
}

}  // namespace

std::vector<std::vector<BatchJob>> jobs_of(const std::vector<BatchInput>& inputs,
                                           const ResultExtensions& extensions, bool joins_pages) {
  std::vector<std::vector<BatchJob>> jobs;
  jobs.reserve(inputs.size());
  for (const BatchInput& input : inputs) {
    jobs.push_back(jobs_of_one(input, extensions, joins_pages));
  }
  return jobs;
}

namespace {

/// Why jobs cannot be done, in the order of the inputs.
class Rejections {
 public:
  Rejections(const std::vector<std::vector<BatchJob>>& jobs, const std::string& out)
      : out_(out), has_out_(std::filesystem::exists(out)) {
    for (const auto& of_input : jobs) paths_.push_back(of_input.front().path);
  }

  /// Empty where the job can be done; then its output is taken.
  std::string of(const BatchJob& job) {
    const auto [other, is_new] = input_of_.emplace(job.output, job.path);
    if (!is_new) {
      return "'" + job.path + "' would become '" + job.output + "', as does '" + other->second +
             "'; process it in another run with another --out";
    }
    for (const std::string& name : {job.output, job.overlay}) {
      if (!has_out_ || name.empty()) continue;
      const auto id = id_of(std::filesystem::path(out_) / name);
      if (!id || !inputs().contains(*id)) continue;
      return "the result of '" + job.path + "' would replace the input '" + inputs().at(*id) +
             "'; choose another --out";
    }
    return {};
  }

 private:
  /// Where there is an output, it may be one of them.
  const std::map<FileId, std::string>& inputs() {
    if (!inputs_.empty()) return inputs_;
    for (const std::string& path : paths_) {
      if (const auto id = id_of(path)) inputs_.emplace(*id, path);
    }
    return inputs_;
  }

  std::vector<std::string> paths_;
  std::string out_;
  bool has_out_;
  std::map<FileId, std::string> inputs_;
  std::unordered_map<std::string, std::string> input_of_;
};

std::string rejection_of(const std::string& path,
                         const std::function<void(const std::string& path)>& check) {
  try {
    check(path);
    return {};
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

}  // namespace

std::vector<std::string> remove_impossible(
    std::vector<std::vector<BatchJob>>& jobs, const std::string& out,
    const std::function<void(const std::string& path)>& check) {
  Rejections rejections(jobs, out);
  std::vector<std::string> failures;
  std::erase_if(jobs, [&](const std::vector<BatchJob>& of_input) {
    std::string why = rejection_of(of_input.front().path, check);
    for (const BatchJob& job : of_input) {
      if (why.empty()) why = rejections.of(job);
    }
    if (!why.empty()) failures.push_back(why);
    return !why.empty();
  });
  return failures;
}

std::vector<BatchJob> jobs_in(const std::vector<std::vector<BatchJob>>& jobs, const Shard& shard) {
  std::vector<BatchJob> chosen;
  for (std::size_t i = shard.number - 1; i < jobs.size(); i += shard.count) {
    chosen.insert(chosen.end(), jobs[i].begin(), jobs[i].end());
  }
  return chosen;
}

namespace {

std::set<std::filesystem::path> directories_of(const std::vector<BatchJob>& jobs,
                                               const std::string& out) {
  std::set<std::filesystem::path> directories;
  for (const BatchJob& job : jobs) {
    directories.insert((std::filesystem::path(out) / job.output).parent_path());
  }
  return directories;
}

}  // namespace

void make_directories(const std::vector<BatchJob>& jobs, const std::string& out) {
  const std::set<std::filesystem::path> directories = directories_of(jobs, out);
  std::error_code error;
  std::filesystem::create_directories(out, error);
  if (error) throw FileError("cannot create the directory '" + out + "': " + error.message());
  for (const std::filesystem::path& directory : directories) {
    std::filesystem::create_directories(directory, error);  // a failure shows again in writing
    remove_abandoned_files(directory);
  }
}

void remove_empty_directories(const std::vector<BatchJob>& jobs, const std::string& out) {
  std::error_code ignored;
  for (std::filesystem::path directory : directories_of(jobs, out)) {
    while (directory != out && std::filesystem::remove(directory, ignored)) {
      directory = directory.parent_path();
    }
  }
  std::filesystem::remove(out, ignored);
}

}  // namespace thinbench
