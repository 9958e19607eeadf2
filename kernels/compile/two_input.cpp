#include "compile/two_input.hpp"

#include <map>
#include <tuple>
#include <utility>

namespace thinbench::detail {
namespace {

constexpr std::uint8_t complement(std::uint8_t function) {
  return static_cast<std::uint8_t>(~function);
}

/// How the last step of a function, or of its complement, combines two others.
struct Combination {
  std::uint8_t steps = kUnknown;
  bool exclusive = false;  // else a conjunction
  bool inverted = false;   // the function is the complement of the combination
  std::uint8_t left = 0;   // functions
  std::uint8_t right = 0;

  static constexpr std::uint8_t kUnknown = 255;
};

constexpr std::uint8_t kInputs[] = {0xF0, 0xCC, 0xAA};

/// The best combinations of all functions, found in the order of their steps.
class Combinations {
 public:
  Combinations() {
    for (const std::uint8_t input : kInputs) {
      of_[input].steps = of_[complement(input)].steps = 0;
    }
    // Zero is the difference of equal values.
    offer(0, {1, true, false, kInputs[0], kInputs[0]});
    for (std::uint8_t steps = 1; unknown_ > 0; ++steps) combine_all(steps);
  }

  const Combination& operator[](std::uint8_t function) const { return of_[function]; }

 private:
  void combine_all(std::uint8_t steps) {
    for (int left = 0; left < 256; ++left) {
      for (int right = 0; right < left; ++right) {
        const auto g = static_cast<std::uint8_t>(left);
        const auto h = static_cast<std::uint8_t>(right);
        if (of_[g].steps == Combination::kUnknown || of_[h].steps == Combination::kUnknown)
          continue;
        if (of_[g].steps + of_[h].steps + 1 != steps) continue;
        offer(g & h, {steps, false, false, g, h});
        offer(g ^ h, {steps, true, false, g, h});
      }
    }
  }

  void offer(int value, Combination combination) {
    const auto function = static_cast<std::uint8_t>(value);
    if (of_[function].steps != Combination::kUnknown) return;
    of_[function] = combination;
    combination.inverted = true;
    of_[complement(function)] = combination;
    unknown_ -= 2;
  }

  std::array<Combination, 256> of_{};
  int unknown_ = 250;
};

const Combinations& combinations() {
  static const Combinations all;
  return all;
}

/// A value or its complement.
struct Literal {
  std::uint16_t value;
  bool inverted;
};

class Converter {
 public:
  GateNetwork convert(const GateNetwork& network) {
    std::vector<Literal> values;
    for (std::uint16_t i = 0; i < kWindowPixels; ++i) values.push_back({i, false});
    for (const Gate& gate : network.gates) {
      const Literal inputs[] = {values[gate.inputs[0]], values[gate.inputs[1]],
                                values[gate.inputs[2]]};
      values.push_back(literal_of(gate.function, inputs));
    }
    Literal output = values[static_cast<std::size_t>(network.output)];
    if (output.inverted) output.value = add(kNot, output, output);
    result_.output = output.value;
    return std::move(result_);
  }

 private:
  Literal literal_of(std::uint8_t function, const Literal (&inputs)[3]) {
    for (int i = 0; i < 3; ++i) {
      if (function == kInputs[i]) return inputs[i];
      if (function == complement(kInputs[i])) return {inputs[i].value, !inputs[i].inverted};
    }
    const Combination& combination = combinations()[function];
    const Literal left = literal_of(combination.left, inputs);
    const Literal right = literal_of(combination.right, inputs);
    Literal result = combination.exclusive ? exclusive(left, right) : conjunction(left, right);
    result.inverted = result.inverted != combination.inverted;
    return result;
  }

  Literal exclusive(Literal left, Literal right) {
    return {add(kXor, left, right), left.inverted != right.inverted};
  }

  Literal conjunction(Literal left, Literal right) {
    if (left.inverted && right.inverted) return {add(kOr, left, right), true};
    if (left.inverted) return {add(kAndNot, left, right), false};
    if (right.inverted) return {add(kAndNot, right, left), false};
    return {add(kAnd, left, right), false};
  }

  std::uint16_t add(std::uint8_t function, Literal left, Literal right) {
    std::uint16_t first = left.value;
    std::uint16_t second = right.value;
    if (function != kAndNot && first > second) std::swap(first, second);
    const auto number = static_cast<std::uint16_t>(kWindowPixels + result_.gates.size());
    const auto [found, is_new] = numbers_.emplace(std::tuple(function, first, second), number);
    if (is_new) result_.gates.push_back({function, {first, second, second}});
    return found->second;
  }

  GateNetwork result_;
  std::map<std::tuple<std::uint8_t, std::uint16_t, std::uint16_t>, std::uint16_t> numbers_;
};

}  // namespace

std::uint8_t two_input_steps(std::uint8_t function) {
  return combinations()[function].steps;
}

GateNetwork in_two_input_gates(const GateNetwork& network) {
  return Converter().convert(network);
}

}  // namespace thinbench::detail
