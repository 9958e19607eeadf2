#include "paired/rounds.hpp"

#include <cmath>
#include <numeric>
#include <utility>

#include "paired/statistics.hpp"
#include "support/splitmix64.hpp"

namespace thinbench {
namespace {

/// A hundredth of a percent, so that samples stay small as text.
double four_decimals(double log) {
  return std::round(log * 1e4) / 1e4;
}

/// The rounds on one clock.
class Series {
 public:
  Series(const Group& group) : group_(group), logs_(group.entries.size()), ns_(logs_.size()) {}

  void add_anchor(double ns) {
    ns_[group_.anchor].push_back(ns);
    in_round_.push_back(std::log(ns));
  }

  /// An epoch between the latest two of the anchor.
  void add_between(std::size_t entry, double ns) {
    const double before = in_round_.at(in_round_.size() - 2);
    add(entry, ns, (before + in_round_.back()) / 2);
  }

  void add_long(std::size_t entry, double ns) { long_calls_.emplace_back(entry, ns); }

  void end_round() {
    for (const auto& [entry, ns] : long_calls_) add(entry, ns, median(in_round_));
    long_calls_.clear();
    in_round_.clear();
  }

  [[nodiscard]] ClockTimes of(std::size_t entry) const {
    if (entry == group_.anchor) return {{0}, median(ns_[entry])};
    return {logs_[entry], median(ns_[entry])};
  }

 private:
  void add(std::size_t entry, double ns, double anchor_log) {
    ns_[entry].push_back(ns);
    logs_[entry].push_back(four_decimals(std::log(ns) - anchor_log));
  }

  const Group& group_;
  std::vector<std::vector<double>> logs_;
  std::vector<std::vector<double>> ns_;
  std::vector<double> in_round_;  // logarithms of the anchor's epochs
  std::vector<std::pair<std::size_t, double>> long_calls_;
};

class Rounds {
 public:
  Rounds(const Group& group, const Visit& visit)
      : group_(group), visit_(visit), thread_cpu_(group), wall_(group) {
    for (std::size_t i = 0; i < group.entries.size(); ++i) {
      if (i != group.anchor) (group.entries[i].long_call ? long_calls_ : short_calls_).push_back(i);
    }
  }

  void measure(std::uint64_t seed) {
    const int half = group_.sweeps / 2;
    for (int sweep = 0; sweep < half; ++sweep) make_sweep(splitmix64(seed, draws_++));
    for (const std::size_t i : shuffled(long_calls_.size(), splitmix64(seed, draws_++))) {
      const Times times = counted(long_calls_[i]);
      thread_cpu_.add_long(long_calls_[i], times.thread_cpu);
      wall_.add_long(long_calls_[i], times.wall);
    }
    for (int sweep = half; sweep < group_.sweeps; ++sweep) make_sweep(splitmix64(seed, draws_++));
    thread_cpu_.end_round();
    wall_.end_round();
  }

  [[nodiscard]] EntryTimes of(std::size_t entry) const {
    return {thread_cpu_.of(entry), wall_.of(entry)};
  }

 private:
  Times counted(std::size_t entry) {
    const Times times = visit_(entry);
    const auto calls = static_cast<double>(group_.entries[entry].counted);
    return {times.thread_cpu / calls, times.wall / calls};
  }

  void visit_anchor() {
    const Times times = counted(group_.anchor);
    thread_cpu_.add_anchor(times.thread_cpu);
    wall_.add_anchor(times.wall);
  }

  void make_sweep(std::uint64_t seed) {
    visit_anchor();
    for (const std::size_t i : shuffled(short_calls_.size(), seed)) {
      const Times times = counted(short_calls_[i]);
      visit_anchor();
      thread_cpu_.add_between(short_calls_[i], times.thread_cpu);
      wall_.add_between(short_calls_[i], times.wall);
    }
  }

  const Group& group_;
  const Visit& visit_;
  std::vector<std::size_t> short_calls_;
  std::vector<std::size_t> long_calls_;
  std::uint64_t draws_ = 0;
  Series thread_cpu_;
  Series wall_;
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
