#include "batch/inputs.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <tuple>
#include <unordered_map>

#include <glob.h>

#include "support/text.hpp"

namespace thinbench {
namespace {

namespace fs = std::filesystem;

bool is_hidden(const fs::path& path) {
  return path.filename().string().starts_with('.');
}

bool has_image_extension(const fs::path& path) {
  constexpr std::array<std::string_view, 11> kKnown = {
      ".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".pbm", ".pgm", ".ppm", ".pnm", ".pam"};
  return std::find(kKnown.begin(), kKnown.end(), extension_of(path)) != kKnown.end();
}

class Search {
 public:
  explicit Search(const InputRequest& request) : request_(request) {}

  void add_path(const std::string& path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
      if (fs::equivalent(path, request_.out, ignored)) {
        found_.skipped_out = true;
        return;
      }
      add_directory(path, {});
    } else {
      add_file(path, {});
    }
  }

  /// A path if there is one of this name, else a pattern.
  void add_argument(const std::string& text) {
    std::error_code ignored;
    const bool is_pattern = text.find_first_of("*?[") != std::string::npos;
    if (!is_pattern || fs::exists(text, ignored)) return add_path(text);
    glob_t found{};
    const int failed = glob(text.c_str(), GLOB_NOSORT, nullptr, &found);
    for (std::size_t i = 0; failed == 0 && i < found.gl_pathc; ++i) add_path(found.gl_pathv[i]);
    globfree(&found);
    if (failed != 0) throw std::runtime_error("no file matches '" + text + "'");
  }

  void add_list(std::istream& list) {
    std::string path;
    while (std::getline(list, path, request_.null_separated ? '\0' : '\n')) {
      if (path.find('\0') != std::string::npos) {
        throw std::runtime_error(
            "the list has NUL characters; expected a path on each line, or --null");
      }
      if (!path.empty()) add_path(path);
    }
  }

  FoundInputs take() {
    std::vector<BatchInput>& inputs = found_.inputs;
    if (found_.skipped_out && inputs.empty()) {
      throw std::runtime_error("--out: '" + request_.out +
                               "' is a directory of inputs, too; choose another");
    }
    std::sort(inputs.begin(), inputs.end(), [](const BatchInput& a, const BatchInput& b) {
      return std::tie(a.path, a.name) < std::tie(b.path, b.name);
    });
    inputs.erase(std::unique(inputs.begin(), inputs.end()), inputs.end());
    keep_different_extensions(inputs);
    return std::move(found_);
  }

 private:
  /// Results of a.bmp and a.png get different names.
  static void keep_different_extensions(std::vector<BatchInput>& inputs) {
    const auto extension = [](const BatchInput& input) {
      return fs::path(input.path).extension().string();
    };
    std::unordered_map<std::string, std::set<std::string>> extensions;
    for (const BatchInput& input : inputs) extensions[input.name].insert(extension(input));
    for (BatchInput& input : inputs) {
      if (extensions[input.name].size() > 1) input.name += extension(input);
    }
  }

  /// `inside`: the directory of the file, relative to the one that was named.
  void add_file(const fs::path& path, const fs::path& inside) {
    found_.inputs.push_back({path.string(), (inside / path.stem()).string()});
  }

  void add_directory(const fs::path& directory, const fs::path& inside) {
    std::error_code error;
    fs::directory_iterator entry(directory, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
      add_entry(*entry, inside);
    }
    if (error) {
      found_.failures.push_back("cannot list '" + directory.string() + "': " + error.message());
    }
  }

  void add_entry(const fs::directory_entry& entry, const fs::path& inside) {
    std::error_code ignored;
    if (entry.is_directory(ignored)) {
      const bool is_searched = request_.recursive && !entry.is_symlink(ignored) &&
                               !fs::equivalent(entry.path(), request_.out, ignored);
      if (is_searched) return add_directory(entry.path(), inside / entry.path().filename());
      ++found_.skipped_directories;
    } else if (has_image_extension(entry.path()) && !is_hidden(entry.path())) {
      add_file(entry.path(), inside);
    } else {
      ++found_.skipped_files;
    }
  }

  const InputRequest& request_;
  FoundInputs found_;
};

}  // namespace

FoundInputs find_inputs(const InputRequest& request, std::istream& list) {
  Search search(request);
  for (const std::string& text : request.in) {
    if (text == "-") {
      search.add_list(list);
    } else {
      search.add_argument(text);
    }
  }
  return search.take();
}

}  // namespace thinbench
