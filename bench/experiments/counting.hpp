// Numbers and truth values that count what is done with them: operation counts come from
// running the references' equations, not from reading them.
#pragma once

#include <cmath>

#include "decisions.hpp"
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

}  // namespace thinbench
