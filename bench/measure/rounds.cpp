#include "measure/rounds.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "harness/splitmix64.hpp"

namespace thinbench {
namespace {

double five_digits(double value) {
  const double unit = std::pow(10, std::floor(std::log10(std::max(value, 1e-3))) - 4);
  return unit < 1 ? std::round(value / unit) / std::round(1 / unit)
                  : std::round(value / unit) * unit;
}

}  // namespace

std::vector<std::size_t> shuffled(std::size_t n, std::uint64_t seed) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[splitmix64(seed, i) % i]);
  return order;
}

std::vector<EntryTimes> measure_rounds(const std::vector<Entry>& entries, std::uint64_t seed,
                                       const Visit& visit) {
  std::vector<EntryTimes> times(entries.size());
  bool more = true;
  for (int round = 0; more; ++round) {
    more = false;
    for (const std::size_t i :
         shuffled(entries.size(), splitmix64(seed, static_cast<std::uint64_t>(round)))) {
      if (round >= entries[i].visits) continue;
      more = true;
      times[i].push_back(five_digits(visit(i) / static_cast<double>(entries[i].calls)));
    }
  }
  return times;
}

}  // namespace thinbench
