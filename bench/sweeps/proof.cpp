#include "sweeps/proof.hpp"

#include <algorithm>
#include <chrono>

#include "harness/crosscheck.hpp"
#include "paired/measuring.hpp"
#include "sweeps/variants.hpp"

namespace thinbench {
namespace {

/// The best scalar row; where that is the point's own, or there is none, the library's choice.
const Variant& stand_in_of(const Point& point) {
  const Variant* scalar = scalar_variant(*point.operation, point.input.width);
  if (scalar != nullptr && scalar != point.variant) return *scalar;
  return *chosen_variant(*point.operation, point.input.width, false);
}

std::string short_name(const Variant& variant) {
  return std::string(variant.technique) + "/" + std::string(variant.isa_label());
}

/// How many pixels a reference would look at.
std::int64_t visits_of(const Point& point, const Outcome& outcome) {
  const bool iterates = point.operation->counter == "iterations";
  return point.input.pixels() * (iterates ? outcome.numbers.front() : 1);
}

/// The better of two calls: the first one touches every page.
double seconds_of_call(Job& job, const ConstImageView& input) {
  ByteImage output(input.width, input.height);
  double best = 1e9;
  for (int i = 0; i < 2; ++i) {
    const auto start = std::chrono::steady_clock::now();
    job.run(input, output.view());
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    best = std::min(best, took.count());
  }
  return best;
}

}  // namespace

std::optional<Proof> Prover::prove(const Point& point, std::string& mismatch) {
  const ConstImageView input = inputs_.get(point.input, point.operation->takes).view();
  const Expected& expected = expected_of_point(point, input);
  const auto job = point.variant->make_job(input.width, input.height, point.threads);
  if (const auto found = find_mismatch(*job, input, expected.outcome)) {
    mismatch = point.name() + " against " + expected.source + ": " + *found;
    return std::nullopt;
  }
  return Proof{expected.source, hash_of(expected.outcome), seconds_of_call(*job, input)};
}

const Prover::Expected& Prover::expected_of_point(const Point& point, const ConstImageView& input) {
  const std::pair<const Operation*, SweepInput> here(point.operation, point.input);
  if (here != latest_) expected_.clear();
  latest_ = here;
  const Variant& stand_in = stand_in_of(point);
  // No row is compared with itself.
  const Variant* key = &stand_in == point.variant ? nullptr : &stand_in;
  const auto found = expected_.find(key);
  if (found != expected_.end()) return found->second;
  return expected_.emplace(key, made_by_reference_or(key, point, input)).first->second;
}

Prover::Expected Prover::made_by_reference_or(const Variant* stand_in, const Point& point,
                                              const ConstImageView& input) const {
  if (stand_in != nullptr) {
    Outcome outcome = outcome_of(*stand_in->make_job(input.width, input.height, 1), input);
    if (visits_of(point, outcome) > most_visits_) {
      return {short_name(*stand_in), std::move(outcome)};
    }
  }
  return {"reference", expected_of(*point.operation, *point.variant, input)};
}

}  // namespace thinbench
