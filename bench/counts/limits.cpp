#include "counts/limits.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <utility>

#include "measure/measuring.hpp"
#include "measure/plan.hpp"
#include "measure/timed_call.hpp"
#include "support/progress.hpp"

namespace thinbench {
namespace {

constexpr Index kAcross = 5;
constexpr Index kDown = 16;

ByteImage small_copy_of(const ByteImage& image) {
  ByteImage few((image.width() + kAcross - 1) / kAcross, (image.height() + kDown - 1) / kDown);
  for (Index y = 0; y < few.height(); ++y) {
    for (Index x = 0; x < few.width(); ++x) few.at(x, y) = image.at(x * kAcross, y * kDown);
  }
  return few;
}

ByteImage rows_of(const ByteImage& image, Index first, Index count) {
  ConstImageView rows = image.view();
  rows.data += first * rows.stride;
  rows.height = count;
  return copy_of(rows);
}

}  // namespace

TimedInput small_copy(const TimedInput& input) {
  return {input.name + "_small", small_copy_of(input.binary), small_copy_of(input.grey)};
}

TimedInput middle_rows(const TimedInput& input, Index rows) {
  const Index count = std::min(rows, input.height());
  const Index first = (input.height() - count) / 2;
  return {input.name + "_" + std::to_string(count) + "_rows", rows_of(input.binary, first, count),
          rows_of(input.grey, first, count)};
}

namespace {

/// What fast rows reach; slow ones reach less and are skipped anyway.
constexpr double kExpectedInstructionsPerCycle = 3;

bool is_too_long(double cycles, std::uint64_t max_steps) {
  return kExpectedInstructionsPerCycle * cycles > static_cast<double>(max_steps);
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The least of a few epochs, in memory of its own.
double time_of(const TimedRow& row) {
  constexpr int kEpochs = 10;
  TimedCall call(row);
  call();
  double start = now();
  call();
  const double one = now() - start;
  const int calls = std::max(1, static_cast<int>(kEpoch / std::max(one, 1e-8)));
  double least = one;
  for (int epoch = 0; epoch < kEpochs; ++epoch) {
    start = now();
    for (int i = 0; i < calls; ++i) call();
    least = std::min(least, (now() - start) / calls);
  }
  return least;
}

/// Rounds through all rows: what disturbs one for a while leaves its other rounds.
Limits timed(const std::vector<TimedRow>& rows) {
  constexpr int kRounds = 5;
  Limits limits;
  limits.seconds_per_cycle = 1;
  for (const TimedRow& row : rows) limits.rows.push_back({{{&row, 0}, {}}, 1e9});
  Progress progress("timing", static_cast<double>(kRounds * rows.size()));
  for (int round = 0; round < kRounds; ++round) {
    for (RowLimit& limit : limits.rows) {
      limit.seconds = std::min(limit.seconds, time_of(*limit.code.count.row));
      limits.seconds_per_cycle = std::min(limits.seconds_per_cycle, shortest_cycle_ns() * 1e-9);
      progress.advance(1);
    }
  }
  return limits;
}

}  // namespace

std::vector<TimedRow> fastest_rows(const std::vector<TimedRow>& rows) {
  struct Best {
    double seconds;
    const TimedRow* row;
  };
  std::map<const Operation*, Best> best;
  for (const TimedRow& row : rows) {
    if (row.scope != Scope::end_to_end) continue;
    const Best one = {calibrate(row).seconds, &row};
    const auto [place, is_first] = best.try_emplace(row.operation, one);
    if (!is_first && one.seconds < place->second.seconds) place->second = one;
  }
  std::vector<TimedRow> fastest;
  for (const TimedRow& row : rows) {
    const auto found = best.find(row.operation);
    if (found != best.end() && found->second.row == &row) fastest.push_back(row);
  }
  return fastest;
}

Limits limits_of(const std::vector<TimedRow>& rows, std::uint64_t max_steps) {
  Limits limits = timed(rows);
  Progress progress("counting", static_cast<double>(rows.size()));
  std::erase_if(limits.rows, [&](RowLimit& limit) {
    const TimedRow& row = *limit.code.count.row;
    std::optional<RowCode> code;
    if (!is_too_long(limits.cycles(limit), max_steps)) code = code_of(row, max_steps);
    progress.advance(1);
    if (!code) {
      limits.skipped.push_back({row.name, kTooManySteps});
    } else {
      limit.code = std::move(*code);
    }
    return !code;
  });
  return limits;
}

}  // namespace thinbench
