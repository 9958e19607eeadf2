// Runs a fuzz target on random inputs from several threads at once for a given time, and watches
// the memory of the process. A wrong pixel ends it as it ends the target.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <random>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "drawn_image.hpp"

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kSecondsForMemory = 60;  // before, caches of rules and arenas of threads still grow

struct Soak {
  std::atomic<bool> ended = false;
  std::atomic<std::uint64_t> inputs = 0;
};

void feed(Soak& soak, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint8_t> bytes;
  while (!soak.ended) {
    bytes.resize(random() % 4096);
    std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<std::uint8_t>(random()); });
    thinbench::ByteSource input(bytes.data(), bytes.size());
    thinbench::try_input(input);
    ++soak.inputs;
  }
}

double resident_mib() {
  std::ifstream file("/proc/self/statm");
  double all = 0;
  double resident = 0;
  file >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

/// The resident memory at each of `count` moments, evenly spread over the time.
std::vector<double> watch(const Soak& soak, std::chrono::seconds time, int count) {
  const auto start = Clock::now();
  std::vector<double> memory;
  for (int i = 1; i <= count; ++i) {
    std::this_thread::sleep_until(start + i * time / count);
    memory.push_back(resident_mib());
    std::printf("%5lld s: %llu sequences of calls, %.1f MiB\n",
                static_cast<long long>((i * time / count).count()),
                static_cast<unsigned long long>(soak.inputs), memory.back());
    std::fflush(stdout);
  }
  return memory;
}

/// Whether more memory is in use in the last quarter than in the second one, beyond a few pages of
/// the allocator.
bool has_grown(const std::vector<double>& memory) {
  const auto quarter = static_cast<std::ptrdiff_t>(memory.size() / 4);
  const double before = *std::max_element(memory.begin() + quarter, memory.begin() + 2 * quarter);
  const double after = *std::max_element(memory.end() - quarter, memory.end());
  std::printf("memory: %.1f MiB in the second quarter, %.1f MiB in the last one\n", before, after);
  return after > 1.05 * before + 4;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Mixed operations on random images from several threads; ends at the first wrong pixel.");
  int seconds = 60;
  int threads = 8;
  std::uint64_t seed = 1;
  app.add_option("--seconds", seconds, "how long")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  app.add_option("--threads", threads, "how many")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--seed", seed, "of the inputs")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  thinbench::size_factor = 3;
  Soak soak;
  std::vector<std::thread> team;
  for (int i = 0; i < threads; ++i)
    team.emplace_back(feed, std::ref(soak), seed * 1000 + static_cast<std::uint64_t>(i));
  const std::vector<double> memory =
      watch(soak, std::chrono::seconds(seconds), std::clamp(seconds / 60, 8, 60));
  soak.ended = true;
  for (std::thread& thread : team) thread.join();
  if (soak.inputs == 0) {
    std::fputs("soak: no input was tried\n", stderr);
    return 1;
  }
  if (seconds < kSecondsForMemory || !has_grown(memory)) return 0;
  std::fputs("soak: memory has grown\n", stderr);
  return 1;
}
