#include "measure/rounds.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "harness/splitmix64.hpp"

namespace thinbench {
namespace {

double quantile(std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  const auto place =
      static_cast<std::ptrdiff_t>(std::llround(share * static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

int rounded(double log) {
  return static_cast<int>(std::lround(1e4 * log));
}

Times operator/(const Times& times, double divisor) {
  return {times.thread_cpu / divisor, times.wall / divisor};
}

Times logarithms(const Times& times) {
  return {std::log(times.thread_cpu), std::log(times.wall)};
}

class Rounds {
 public:
  Rounds(const Group& group, const Visit& visit)
      : group_(group),
        visit_(visit),
        logs_(group.entries.size()),
        anchors_(logs_.size()),
        ns_(logs_.size()) {
    for (std::size_t i = 0; i < group.entries.size(); ++i) {
      if (i != group.anchor) (group.entries[i].long_call ? long_calls_ : short_calls_).push_back(i);
    }
  }

  void measure(std::uint64_t seed) {
    const int half = group_.sweeps / 2;
    for (int sweep = 0; sweep < half; ++sweep) make_sweep(splitmix64(seed, draws_++));
    std::vector<std::pair<std::size_t, Times>> long_times;
    for (const std::size_t i : shuffled(long_calls_.size(), splitmix64(seed, draws_++))) {
      long_times.emplace_back(long_calls_[i], counted(long_calls_[i]));
    }
    for (int sweep = half; sweep < group_.sweeps; ++sweep) make_sweep(splitmix64(seed, draws_++));
    const Times anchor = anchor_median();
    for (const auto& [entry, times] : long_times) add(entry, times, anchor);
    anchor_logs_.clear();
  }

  [[nodiscard]] EntryTimes of(std::size_t entry) {
    constexpr std::array kShares = {0.0, 0.1, 0.25, 0.5, 0.75, 1.0};
    EntryTimes times{logs_[entry], anchors_[entry]};
    for (std::size_t i = 0; i < kShares.size(); ++i) times.ns[i] = quantile(ns_[entry], kShares[i]);
    return times;
  }

 private:
  Times counted(std::size_t entry) {
    return visit_(entry) / static_cast<double>(group_.entries[entry].counted);
  }

  void visit_anchor() {
    const Times times = counted(group_.anchor);
    ns_[group_.anchor].push_back(times.thread_cpu);
    anchor_logs_.push_back(logarithms(times));
  }

  void make_sweep(std::uint64_t seed) {
    visit_anchor();
    for (const std::size_t i : shuffled(short_calls_.size(), seed)) {
      const Times times = counted(short_calls_[i]);
      const Times before = anchor_logs_.back();
      visit_anchor();
      const Times after = anchor_logs_.back();
      add(short_calls_[i], times,
          {(before.thread_cpu + after.thread_cpu) / 2, (before.wall + after.wall) / 2});
    }
  }

  [[nodiscard]] Times anchor_median() const {
    std::vector<double> thread_cpu;
    std::vector<double> wall;
    for (const Times& logs : anchor_logs_) {
      thread_cpu.push_back(logs.thread_cpu);
      wall.push_back(logs.wall);
    }
    return {quantile(thread_cpu, 0.5), quantile(wall, 0.5)};
  }

  void add(std::size_t entry, const Times& times, const Times& anchor_logs) {
    const bool threaded = group_.entries[entry].threaded;
    const double ns = threaded ? times.wall : times.thread_cpu;
    const double anchor = threaded ? anchor_logs.wall : anchor_logs.thread_cpu;
    ns_[entry].push_back(ns);
    logs_[entry].push_back(rounded(std::log(ns) - anchor));
    anchors_[entry].push_back(rounded(anchor));
  }

  const Group& group_;
  const Visit& visit_;
  std::vector<std::size_t> short_calls_;
  std::vector<std::size_t> long_calls_;
  std::uint64_t draws_ = 0;
  std::vector<std::vector<int>> logs_;
  std::vector<std::vector<int>> anchors_;
  std::vector<std::vector<double>> ns_;
  std::vector<Times> anchor_logs_;  // of this round
};

}  // namespace

std::vector<std::size_t> shuffled(std::size_t n, std::uint64_t seed) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[splitmix64(seed, i) % i]);
  return order;
}

std::vector<EntryTimes> measure_rounds(const Group& group, std::uint64_t seed, const Visit& visit) {
  Rounds rounds(group, visit);
  for (int round = 0; round < group.rounds; ++round) rounds.measure(seed);
  std::vector<EntryTimes> times;
  for (std::size_t i = 0; i < group.entries.size(); ++i) times.push_back(rounds.of(i));
  return times;
}

}  // namespace thinbench
