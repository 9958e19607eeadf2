#include "measure/repetition.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "core/layout.hpp"
#include "measure/probe.hpp"
#include "measure/timed_call.hpp"

namespace thinbench {
namespace {

/// Seconds that a repetition of short calls lasts.
constexpr double kRepetition = 0.0003;
/// Calls longer than this are not warmed up: it would take as long as measuring. References are the
/// slow ones, whose time new memory changes least.
constexpr double kSlowCall = 0.05;
constexpr double kSlowReference = 0.005;
constexpr double kMaxRepetitions = 25;

/// Memory of random size before a job is made: large blocks would lie at the same place of a page
/// every time, and by chance at a good or a bad one.
detail::AlignedArray<std::uint8_t> random_gap() {
  static std::minstd_rand dice{std::random_device()()};
  constexpr unsigned kLines = 64;
  return detail::make_aligned<std::uint8_t>(detail::kAlignment * (1 + dice() % kLines));
}

/// Once: of large images, comparing takes longer than computing.
void check(Measured& measured, const TimedCall& call) {
  if (measured.is_checked) return;
  const std::string hash = hash_of(call.outcome());
  measured.is_checked = hash == measured.known.hash;
  if (measured.is_checked) return;
  throw std::runtime_error("it gave another result (" + hash + ") than was verified (" +
                           measured.known.hash + ")");
}

void measure(benchmark::State& state, const Measured& measured, TimedCall& call) {
  for (std::int64_t i = 0; i < measured.warm_up; ++i) call();
  const double cycle = std::min({cycle_ns(), cycle_ns(), cycle_ns()});  // one may be interrupted
  const double delay = measured.delay_ns / cycle * static_cast<double>(measured.calls);
  state.counters[kCycle] = cycle;
  state.counters[kProbeBefore] = probe_ns();
  while (state.KeepRunningBatch(measured.calls)) {
    for (std::int64_t i = 0; i < measured.calls; ++i) call();
    if (delay > 0) wait_cycles(delay);
  }
  state.counters[kProbeAfter] = probe_ns();
}

}  // namespace

Measured::Measured(const KnownRow& row, double seconds, int min_repetitions) : known(row) {
  calls = std::max<std::int64_t>(1, std::llround(kRepetition / row.seconds));
  // The job is new, and another row has left caches and branch predictor in its own state.
  const bool is_reference = row.row.variant == nullptr;
  if (row.seconds <= (is_reference ? kSlowReference : kSlowCall)) warm_up = 1 + calls / 3;
  const double each = static_cast<double>(calls + warm_up) * row.seconds;
  repetitions = static_cast<int>(
      std::clamp<double>(std::round(seconds / each), min_repetitions, kMaxRepetitions));
}

Workspace& Workspaces::of(const ConstImageView& input) {
  std::unique_ptr<Workspace>& found = workspaces_[input.data];
  if (!found) found = std::make_unique<Workspace>(input);
  return *found;
}

void repeat(benchmark::State& state, Measured& measured, Workspaces& workspaces) {
  try {
    const Workspace& workspace = workspaces.of(measured.known.row.view());
    const auto gap = random_gap();
    TimedCall call(measured.known.row, workspace.source(), workspace.destination());
    measure(state, measured, call);
    check(measured, call);
  } catch (const std::exception& error) {
    state.SkipWithError(error.what());
  }
}

}  // namespace thinbench
