#include "sweeps/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>
#include <stdexcept>

#include "paired/measuring.hpp"
#include "paired/rounds.hpp"
#include "paired/workspace.hpp"
#include "support/splitmix64.hpp"
#include "timing/timed_call.hpp"

namespace thinbench {
namespace {

std::int64_t calls_of(const Proof& proof) {
  return std::max<std::int64_t>(1, std::llround(kSampleSeconds / std::max(proof.seconds, 1e-8)));
}

/// One call touches every page; a third of the sample's calls more warm caches and branches.
std::int64_t warm_up_of(std::int64_t calls) {
  return 1 + calls / 3;
}

std::int64_t nanoseconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return 1'000'000'000 * static_cast<std::int64_t>(now.tv_sec) + now.tv_nsec;
}

void check(const Point& point, const Proof& proof, const TimedCall& call) {
  const std::string hash = hash_of(call.outcome());
  if (hash == proof.hash) return;
  throw std::runtime_error(point.name() + " gave another result (" + hash + ") than was proved (" +
                           proof.hash + ")");
}

}  // namespace

double expected_seconds(const Point& point, const Proof& proof) {
  constexpr double kReadyPerPixel = 2e-9;  // copies and fresh pages
  const std::int64_t calls = calls_of(proof);
  return kReadyPerPixel * static_cast<double>(point.input.pixels()) +
         proof.seconds * static_cast<double>(calls + warm_up_of(calls));
}

std::vector<const Point*> order_of_round(const std::vector<const Point*>& points,
                                         std::uint64_t seed) {
  std::vector<std::vector<const Point*>> groups;
  std::map<SweepInput, std::size_t> places;
  for (const Point* point : points) {
    const auto place = places.emplace(point->input, groups.size());
    if (place.second) groups.emplace_back();
    groups[place.first->second].push_back(point);
  }
  std::vector<const Point*> order;
  for (const std::size_t group : shuffled(groups.size(), seed)) {
    for (const std::size_t i : shuffled(groups[group].size(), splitmix64(seed, group))) {
      order.push_back(groups[group][i]);
    }
  }
  return order;
}

Sample Sampler::take(const Point& point, const Proof& proof, int round) {
  const Workspace workspace(inputs_.get(point.input, point.operation->takes).view());
  const TimedRow row{
      point.row(), point.operation, point.variant, point.threads, Scope::end_to_end, nullptr, {}};
  TimedCall call(row, workspace.source(), workspace.destination());
  const std::int64_t calls = calls_of(proof);
  for (std::int64_t i = warm_up_of(calls); i > 0; --i) call();
  if (checked_.insert(&point).second) {
    check(point, proof, call);
    call();
  }
  const clockid_t clock = point.clock() == "wall" ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID;
  const std::int64_t start = nanoseconds(clock);
  for (std::int64_t i = 0; i < calls; ++i) call();
  return {round, std::max<std::int64_t>(1, nanoseconds(clock) - start), calls};
}

}  // namespace thinbench
