#include "paired/rounds.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <numeric>

#include "support/splitmix64.hpp"

namespace thinbench {
namespace {

/// Five digits: a hundredth of a thousandth, and samples stay small as text.
double five_digits(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.5g", value);
  return std::strtod(text.data(), nullptr);
}

}  // namespace

std::vector<std::size_t> shuffled(std::size_t n, std::uint64_t seed) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[splitmix64(seed, i) % i]);
  return order;
}

std::vector<std::size_t> order_of_round(const std::vector<Entry>& entries, std::uint64_t seed) {
  std::vector<std::size_t> short_calls;
  std::vector<std::size_t> order;
  std::vector<std::size_t> long_calls;
  for (const std::size_t entry : shuffled(entries.size(), seed)) {
    (entries[entry].long_call ? long_calls : short_calls).push_back(entry);
  }
  order = short_calls;
  order.insert(order.end(), long_calls.begin(), long_calls.end());
  order.insert(order.end(), short_calls.rbegin(), short_calls.rend());
  return order;
}

std::vector<EntryTimes> measure_rounds(const std::vector<Entry>& entries, int rounds,
                                       std::uint64_t seed, const Visit& visit) {
  std::vector<EntryTimes> result(entries.size());
  for (int round = 0; round < rounds; ++round) {
    std::vector<Times> sums(entries.size());
    const std::uint64_t round_seed = splitmix64(seed, static_cast<std::uint64_t>(round));
    for (const std::size_t entry : order_of_round(entries, round_seed)) {
      const Times times = visit(entry);
      sums[entry].thread_cpu += times.thread_cpu;
      sums[entry].wall += times.wall;
    }
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const int visits = entries[i].long_call ? 1 : 2;
      const auto counted = static_cast<double>(visits * entries[i].counted);
      result[i].thread_cpu.push_back(five_digits(sums[i].thread_cpu / counted));
      result[i].wall.push_back(five_digits(sums[i].wall / counted));
    }
  }
  return result;
}

}  // namespace thinbench
