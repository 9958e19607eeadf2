#include "counts/executed_code.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace thinbench {
namespace {

constexpr std::size_t kLongestInstruction = 15;

/// The process's memory as a file: reading ends where memory does, without a fault.
class OwnMemory {
 public:
  OwnMemory() : file_(open("/proc/self/mem", O_RDONLY | O_CLOEXEC)) {}
  ~OwnMemory() { close(file_); }
  OwnMemory(const OwnMemory&) = delete;
  OwnMemory& operator=(const OwnMemory&) = delete;
  OwnMemory(OwnMemory&&) = delete;
  OwnMemory& operator=(OwnMemory&&) = delete;

  [[nodiscard]] std::string hexadecimal(std::uint64_t address) const {
    std::array<std::uint8_t, kLongestInstruction> bytes{};
    const ssize_t read = pread(file_, bytes.data(), bytes.size(), static_cast<off_t>(address));
    if (read <= 0) throw std::runtime_error("/proc/self/mem cannot be read");
    return fmt::format("{:02x}", fmt::join(bytes.begin(), bytes.begin() + read, ""));
  }

 private:
  int file_;
};

/// Instructions that follow each other in memory, as numbers.
struct Run {
  std::size_t first;
  std::size_t last;
  bool operator==(const Run&) const = default;
};

std::vector<Run> runs_of(const std::vector<std::size_t>& numbers) {
  std::vector<Run> runs;
  for (const std::size_t number : numbers) {
    if (!runs.empty() && number == runs.back().last + 1) {
      runs.back().last = number;
    } else {
      runs.push_back({number, number});
    }
  }
  return runs;
}

std::string to_text(const std::vector<Run>& runs) {
  std::string text;
  for (auto run = runs.begin(); run != runs.end();) {
    const auto end = std::find_if(run, runs.end(), [&](const Run& other) { return other != *run; });
    const char* space = text.empty() ? "" : " ";
    text += fmt::format("{}{}-{}*{}", space, run->first, run->last, end - run);
    run = end;
  }
  return text;
}

}  // namespace

ExecutedCode executed_code(const std::vector<std::uint64_t>& addresses) {
  std::vector<std::uint64_t> sorted = addresses;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  std::vector<std::size_t> numbers;
  numbers.reserve(addresses.size());
  for (const std::uint64_t address : addresses) {
    const auto place = std::lower_bound(sorted.begin(), sorted.end(), address);
    numbers.push_back(static_cast<std::size_t>(place - sorted.begin()));
  }
  const OwnMemory memory;
  std::vector<std::string> instructions;
  std::transform(sorted.begin(), sorted.end(), std::back_inserter(instructions),
                 [&](std::uint64_t address) { return memory.hexadecimal(address); });
  return {fmt::format("{}", fmt::join(instructions, " ")), to_text(runs_of(numbers))};
}

}  // namespace thinbench
