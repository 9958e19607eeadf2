#include "paired/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace thinbench {

double median(std::vector<double> values) {
  if (values.empty()) throw std::invalid_argument("no values, no median");
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

Ranks interval_ranks(std::size_t n) {
  constexpr double kWanted = 0.95;
  if (n == 0) throw std::invalid_argument("no values, no ranks");
  // The median lies outside ranks k and n + 1 - k if fewer than k values fell on one side of it.
  Ranks ranks{1, n, 1 - 2 * std::pow(0.5, n)};
  double binomial = 1;  // n over k
  double outside = 2 * std::pow(0.5, n);
  for (std::size_t k = 1; 2 * (k + 1) <= n; ++k) {
    binomial = binomial * static_cast<double>(n + 1 - k) / static_cast<double>(k);
    outside += 2 * binomial * std::pow(0.5, n);
    if (1 - outside < kWanted) break;
    ranks = {k + 1, n - k, 1 - outside};
  }
  return ranks;
}

Estimate estimate_of(std::vector<double> logs) {
  std::vector<double> ordered = logs;
  std::sort(ordered.begin(), ordered.end());
  const Ranks ranks = interval_ranks(logs.size());
  const double low = ordered[ranks.low - 1];
  const double high = ordered[ranks.high - 1];
  return {std::move(logs), std::exp(median(ordered)), std::exp(low), std::exp(high)};
}

}  // namespace thinbench
