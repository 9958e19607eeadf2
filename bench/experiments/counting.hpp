// Numbers, truth values and words that count what is done with them: operation counts come from
// running the references' equations, not from reading them.
#pragma once

#include <cmath>
#include <cstdint>

#include "decisions.hpp"
#include "simd/word.hpp"
#include "thinbench/nets.hpp"

namespace thinbench {

/// The paper calls logical what works on truth values and arithmetic the rest.
struct Operations {
  int logical = 0;
  int additions = 0;  // negations and subtractions too
  int multiplications = 0;
  int divisions = 0;
  int powers = 0;  // powers of two and of e
  int comparisons = 0;

  [[nodiscard]] int arithmetic() const { return additions + multiplications + divisions + powers; }
};

/// What has been counted: activation functions apart from sums and decisions.
struct Tally {
  Operations sums;
  Operations activations;
  bool in_activation = false;

  Operations& current() { return in_activation ? activations : sums; }
};

inline thread_local Tally tally;

/// Runs `work` and returns what it counted.
template <class Work>
Tally count_operations(const Work& work) {
  tally = Tally{};
  work();
  return tally;
}

/// A float that counts.
class CountedFloat {
 public:
  CountedFloat() : CountedFloat(0.0F) {}
  explicit CountedFloat(float value) : value_(value) {}

  friend CountedFloat operator+(CountedFloat a, CountedFloat b) {
    ++tally.current().additions;
    return CountedFloat(a.value_ + b.value_);
  }
  friend CountedFloat operator-(CountedFloat a) {
    ++tally.current().additions;
    return CountedFloat(-a.value_);
  }
  friend CountedFloat operator*(CountedFloat a, CountedFloat b) {
    ++tally.current().multiplications;
    return CountedFloat(a.value_ * b.value_);
  }
  friend CountedFloat operator/(CountedFloat a, CountedFloat b) {
    ++tally.current().divisions;
    return CountedFloat(a.value_ / b.value_);
  }
  friend bool operator>(CountedFloat a, CountedFloat b) { return compared(a.value_ > b.value_); }
  friend bool operator<(CountedFloat a, CountedFloat b) { return compared(a.value_ < b.value_); }
  friend bool operator>=(CountedFloat a, CountedFloat b) { return compared(a.value_ >= b.value_); }
  friend bool operator!=(CountedFloat a, CountedFloat b) { return compared(a.value_ != b.value_); }
  friend CountedFloat exp(CountedFloat x) {
    ++tally.current().powers;
    return CountedFloat(std::exp(x.value_));
  }
  /// Taken for a power of two: x is 1 wherever the equations have it.
  friend CountedFloat ldexp(CountedFloat x, int exponent) {
    ++tally.current().powers;
    return CountedFloat(std::ldexp(x.value_, exponent));
  }
  [[nodiscard]] float value() const { return value_; }

 private:
  static bool compared(bool result) {
    ++tally.current().comparisons;
    return result;
  }

  float value_;
};

/// The activation function, counted apart: the reference's equations find this one for counted
/// numbers.
template <Activation activation>
CountedFloat activated(CountedFloat x) {
  tally.in_activation = true;
  const CountedFloat y = reference::activated<activation, CountedFloat>(x);
  tally.in_activation = false;
  return y;
}

/// A truth value that counts. Both sides of `and` and `or` are evaluated, as the paper counts them.
class CountedTruth {
 public:
  explicit CountedTruth(bool value) : value_(value) {}

  friend CountedTruth operator&&(CountedTruth a, CountedTruth b) {
    return logical(a.value_ && b.value_);
  }
  friend CountedTruth operator||(CountedTruth a, CountedTruth b) {
    return logical(a.value_ || b.value_);
  }
  friend CountedTruth operator!(CountedTruth a) { return logical(!a.value_); }
  explicit operator bool() const { return value_; }

 private:
  static CountedTruth logical(bool value) {
    ++tally.current().logical;
    return CountedTruth(value);
  }

  bool value_;
};

/// Gates of a circuit with at most `inputs` (2 or 3) inputs each. Inverters are counted apart: most
/// instruction sets have and-not, and three-input gates take them in.
struct Gates {
  int gates = 0;
  int inverters = 0;
};

/// A word that counts gates.
template <int inputs>
class CountedWord {
 public:
  explicit CountedWord(std::uint64_t value) : value_(value) {}

  friend CountedWord operator&(CountedWord a, CountedWord b) { return gate(a.value_ & b.value_); }
  friend CountedWord operator|(CountedWord a, CountedWord b) { return gate(a.value_ | b.value_); }
  friend CountedWord operator^(CountedWord a, CountedWord b) { return gate(a.value_ ^ b.value_); }
  friend CountedWord operator~(CountedWord a) {
    ++counted.inverters;
    return CountedWord(~a.value_);
  }
  static CountedWord gate(std::uint64_t value) {
    ++counted.gates;
    return CountedWord(value);
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

  static inline thread_local Gates counted;

 private:
  std::uint64_t value_;
};

}  // namespace thinbench

namespace thinbench::detail {

/// With three inputs `ternary` is one gate; with two it is its expression, the general way.
template <>
struct TernaryGate<CountedWord<3>> {
  static constexpr bool kOneInstruction = true;

  template <class Gate>
  static CountedWord<3> apply(CountedWord<3> a, CountedWord<3> b, CountedWord<3> c, Gate gate) {
    return CountedWord<3>::gate(gate(a.value(), b.value(), c.value()));
  }
};

}  // namespace thinbench::detail
