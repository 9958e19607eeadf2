#include <array>
#include <bitset>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "thinning/runtime_rule.hpp"

namespace thinbench::detail {
namespace {

using Order = std::array<int, kNeighbours>;  // variables from the root down
using Function = std::bitset<256>;           // by descriptor, variables permuted by the order

/// Moves variable order[i] to bit 7 - i, so that the halves of a range are its cofactors.
Function reordered(const std::uint8_t* keep, const Order& order) {
  Function function;
  for (std::size_t code = 0; code < 256; ++code) {
    std::size_t descriptor = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      descriptor |= (code >> (7 - i) & 1) << order[i];
    }
    function[code] = keep[descriptor] != 0;
  }
  return function;
}

/// Builds a diagram bottom-up and merges equal sub-functions.
class Builder {
 public:
  explicit Builder(const Order& order) : order_(order) {}

  MuxProgram build(const Function& function) {
    static_cast<void>(value_of(function, 0, 256, 0));
    return program_;
  }

 private:
  int value_of(const Function& function, std::size_t first, std::size_t size, std::size_t depth) {
    if (size == 1) return function[first] ? 1 : 0;
    const int low = value_of(function, first, size / 2, depth + 1);
    const int high = value_of(function, first + size / 2, size / 2, depth + 1);
    if (low == high) return low;
    const auto key = std::make_tuple(order_[depth], high, low);
    const auto found = values_.find(key);
    if (found != values_.end()) return found->second;
    program_.nodes[program_.count] = {static_cast<std::uint8_t>(order_[depth]),
                                      static_cast<std::uint8_t>(high),
                                      static_cast<std::uint8_t>(low)};
    return values_[key] = 2 + program_.count++;
  }

  Order order_;
  std::map<std::tuple<int, int, int>, int> values_;
  MuxProgram program_{};
};

MuxProgram built(const std::uint8_t* keep, const Order& order) {
  return Builder(order).build(reordered(keep, order));
}

/// Adds a node to the empty diagram of a constant function: it selects between equal values.
MuxProgram with_result(MuxProgram program, bool constant) {
  if (program.count == 0) {
    const std::uint8_t value = constant ? 1 : 0;
    program.nodes[program.count++] = {0, value, value};
  }
  return program;
}

}  // namespace

// Minimises the number of nodes by exchanging pairs of variables until no exchange helps.
MuxProgram make_mux_program(const std::uint8_t* keep) {
  Order order{};
  std::iota(order.begin(), order.end(), 0);
  MuxProgram best = built(keep, order);
  for (bool improved = true; improved;) {
    improved = false;
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t j = i + 1; j < order.size(); ++j) {
        std::swap(order[i], order[j]);
        const MuxProgram candidate = built(keep, order);
        if (candidate.count < best.count) {
          best = candidate;
          improved = true;
        } else {
          std::swap(order[i], order[j]);
        }
      }
    }
  }
  return with_result(best, keep[0] != 0);
}

}  // namespace thinbench::detail
