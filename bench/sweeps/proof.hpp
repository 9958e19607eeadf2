// The proof that comes before the clock starts.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "sweeps/plan.hpp"

namespace thinbench {

/// What a row gave on its input, after it was found right.
struct Proof {
  std::string against;  // "reference", or the row that stood in for it
  std::string hash;     // of the result
  double seconds = 0;   // of a call
};

/// Compares rows with their references. Where a reference would visit more than kMostVisits pixels,
/// counted once per iteration, the best scalar row stands in for it; for that row the library's
/// choice.
class Prover {
 public:
  static constexpr std::int64_t kMostVisits = std::int64_t{1} << 26;

  explicit Prover(InputStore& inputs, std::int64_t most_visits = kMostVisits)
      : inputs_(inputs), most_visits_(most_visits) {}

  /// Nothing where the row is not equal; `mismatch` then says what is wrong.
  [[nodiscard]] std::optional<Proof> prove(const Point& point, std::string& mismatch);

 private:
  struct Expected {
    std::string source;
    Outcome outcome;
  };

  const Expected& expected_of_point(const Point& point, const ConstImageView& input);
  [[nodiscard]] Expected made_by_reference_or(const Variant* stand_in, const Point& point,
                                              const ConstImageView& input) const;

  InputStore& inputs_;
  std::int64_t most_visits_;
  /// Of the latest operation and input, by the row that stands in; nullptr where none does.
  std::pair<const Operation*, SweepInput> latest_;
  std::map<const Variant*, Expected> expected_;
};

}  // namespace thinbench
