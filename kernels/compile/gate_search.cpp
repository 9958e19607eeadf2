// The search changes one gate at a time: it looks for three other values from which the gate can be
// computed wherever the output depends on it, and takes those that make the circuit cheaper, or as
// cheap but different. When that no longer helps, it replaces a part of the circuit by a Shannon
// expansion, which is larger, and shrinks it again.
//
// Three values suffice if no two windows on which they agree need different results. Most triples
// fail on one of a few pairs of such windows. Each value has a bit set of the pairs that it
// distinguishes; triples that distinguish all pairs are tested on all windows, and a pair that
// refutes one is added.
#include "compile/gate_search.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "compile/decompose.hpp"

namespace thinbench::detail {
namespace {

using Words = std::array<std::uint64_t, WindowTable::kWindows / 64>;

class Random {
 public:
  std::uint64_t next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return state_;
  }
  int below(int limit) {
    return static_cast<int>((next() >> 32) % static_cast<std::uint64_t>(limit));
  }

 private:
  std::uint64_t state_ = 0x9E3779B97F4A7C15;
};

/// The windows on which a gate must be 1 and those on which it must be 0.
struct Requirement {
  Words on;
  Words off;
};

bool is_empty(const Words& words) {
  std::uint64_t any = 0;
  for (const std::uint64_t word : words) any |= word;
  return any == 0;
}

int first_bit(const Words& words) {
  for (std::size_t w = 0; w < words.size(); ++w) {
    if (words[w] != 0) return static_cast<int>(w) * 64 + std::countr_zero(words[w]);
  }
  return -1;
}

bool bit_of(const WindowTable& table, int window) {
  return table[static_cast<std::size_t>(window)];
}

/// Up to 64 pairs of a window that needs 1 and one that needs 0, and which of them each candidate
/// distinguishes.
class Pairs {
 public:
  void reset(const std::vector<WindowTable>& tables, const std::vector<int>& candidates,
             const Requirement& requirement, Random& random);
  /// Replaces a pair other than those in `used`.
  void learn(int on, int off, std::uint64_t used);

  [[nodiscard]] std::uint64_t all() const { return valid_; }
  [[nodiscard]] std::uint64_t distinguished(int candidate) const {
    return masks_[static_cast<std::size_t>(candidate)];
  }
  /// The candidates that distinguish a pair.
  [[nodiscard]] std::span<const std::uint8_t> covering(int pair) const {
    const auto p = static_cast<std::size_t>(pair);
    return {covers_[p].data(), static_cast<std::size_t>(counts_[p])};
  }

 private:
  void list_covers();

  const std::vector<WindowTable>* tables_ = nullptr;
  const std::vector<int>* candidates_ = nullptr;
  std::uint64_t valid_ = 0;
  int next_ = 0;
  std::array<std::uint64_t, 256> masks_{};
  std::array<std::array<std::uint8_t, 256>, 64> covers_{};
  std::array<int, 64> counts_{};
};

/// Pair i is window i of one word and window i of another word, rotated, where one needs 1 and the
/// other 0: one exclusive or per candidate finds all 64.
void Pairs::reset(const std::vector<WindowTable>& tables, const std::vector<int>& candidates,
                  const Requirement& requirement, Random& random) {
  tables_ = &tables;
  candidates_ = &candidates;
  std::size_t first = 0;
  std::size_t second = 0;
  int turn = 0;
  valid_ = 0;
  for (int attempt = 0; attempt < 8 && std::popcount(valid_) < 24; ++attempt) {
    const auto a = static_cast<std::size_t>(random.below(8));
    const auto b = static_cast<std::size_t>(random.below(8));
    const int shift = random.below(64);
    const std::uint64_t pairs = (requirement.on[a] & std::rotr(requirement.off[b], shift)) |
                                (requirement.off[a] & std::rotr(requirement.on[b], shift));
    if (std::popcount(pairs) < std::popcount(valid_)) continue;
    std::tie(first, second, turn, valid_) = std::tuple(a, b, shift, pairs);
  }
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const Words& words = tables[static_cast<std::size_t>(candidates[k])].words;
    masks_[k] = (words[first] ^ std::rotr(words[second], turn)) & valid_;
  }
  next_ = 0;
  list_covers();
  if (valid_ == 0) learn(first_bit(requirement.on), first_bit(requirement.off), 0);
}

void Pairs::list_covers() {
  counts_.fill(0);
  for (std::size_t k = 0; k < candidates_->size(); ++k) {
    for (std::uint64_t rest = masks_[k]; rest != 0; rest &= rest - 1) {
      const auto pair = static_cast<std::size_t>(std::countr_zero(rest));
      covers_[pair][static_cast<std::size_t>(counts_[pair]++)] = static_cast<std::uint8_t>(k);
    }
  }
}

void Pairs::learn(int on, int off, std::uint64_t used) {
  const std::uint64_t free = ~(valid_ | used) != 0 ? ~(valid_ | used) : ~used;
  while ((free >> next_ & 1) == 0) next_ = (next_ + 1) % 64;
  const auto pair = static_cast<std::size_t>(next_);
  const std::uint64_t bit = std::uint64_t{1} << next_;
  next_ = (next_ + 1) % 64;
  valid_ |= bit;
  counts_[pair] = 0;
  for (std::size_t k = 0; k < candidates_->size(); ++k) {
    const WindowTable& table = (*tables_)[static_cast<std::size_t>((*candidates_)[k])];
    masks_[k] &= ~bit;
    if (bit_of(table, on) == bit_of(table, off)) continue;
    masks_[k] |= bit;
    covers_[pair][static_cast<std::size_t>(counts_[pair]++)] = static_cast<std::uint8_t>(k);
  }
}

/// The circuit during a search.
class WorkingNetwork {
 public:
  WorkingNetwork(GateNetwork network, const GateCosts& costs)
      : network_(std::move(network)), costs_(&costs), counter_(costs) {
    tidy();
  }

  [[nodiscard]] const GateNetwork& network() const { return network_; }
  [[nodiscard]] int cost() const { return cost_; }
  [[nodiscard]] int gates() const { return static_cast<int>(network_.gates.size()); }

  /// Tries to replace gate `index`. Returns the work that this took.
  std::int64_t improve(int index, Pairs& pairs, Random& random);

  /// Replaces gate `index` by a Shannon expansion. False if nothing changed.
  bool expand(int index, const PixelOrder& order);

 private:
  struct Choice {
    Gate gate{};
    int gain = -1;
    int ties = 0;
  };

  void tidy();
  /// The values that do not depend on the gate, and what it must be.
  Requirement requirement_of(int value);
  void add_reference(int value, int& cost);
  void drop_reference(int value, int& cost);
  bool test(const Requirement& requirement, const std::array<int, 3>& candidates,
            std::uint64_t used, Pairs& pairs, Gate& gate);
  void offer(const Gate& gate, int freed, Choice& best, Random& random);
  void replace(int value, SignedValue by);
  std::int64_t search_triples(const Requirement& requirement, int freed, Pairs& pairs, Choice& best,
                              Random& random);

  GateNetwork network_;
  const GateCosts* costs_;
  CostCounter counter_;
  int cost_ = 0;
  std::vector<WindowTable> tables_;
  std::vector<int> references_;  // how many gates, or the output, read each value
  std::vector<char> depends_;    // on the gate in question
  std::vector<WindowTable> flipped_;
  std::vector<int> candidates_;
};

void WorkingNetwork::tidy() {
  sort_gates(network_);
  tables_ = tables_of(network_);
  counter_ = CostCounter(*costs_);
  cost_ = 0;
  for (const Gate& gate : network_.gates) cost_ += counter_.add(gate);
  references_.assign(tables_.size(), 0);
  for (const Gate& gate : network_.gates) {
    for (const std::uint16_t input : gate.inputs) ++references_[input];
  }
  ++references_[static_cast<std::size_t>(network_.output)];
}

Requirement WorkingNetwork::requirement_of(int value) {
  const auto v = static_cast<std::size_t>(value);
  depends_.assign(tables_.size(), 0);
  flipped_.resize(tables_.size());
  depends_[v] = 1;
  for (std::size_t w = 0; w < 8; ++w) flipped_[v].words[w] = ~tables_[v].words[w];
  const auto now = [&](std::uint16_t input) -> const WindowTable& {
    return depends_[input] != 0 ? flipped_[input] : tables_[input];
  };
  for (std::size_t i = v + 1; i < tables_.size(); ++i) {
    const Gate& gate = network_.gates[i - kWindowPixels];
    const auto& [a, b, c] = gate.inputs;
    if ((depends_[a] | depends_[b] | depends_[c]) == 0) continue;
    depends_[i] = 1;
    flipped_[i] = gate_table(gate.function, now(a), now(b), now(c));
  }
  const auto output = static_cast<std::size_t>(network_.output);
  Requirement requirement;
  for (std::size_t w = 0; w < 8; ++w) {
    const std::uint64_t matters = flipped_[output].words[w] ^ tables_[output].words[w];
    requirement.on[w] = matters & tables_[v].words[w];
    requirement.off[w] = matters & ~tables_[v].words[w];
  }
  candidates_.clear();
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    if (depends_[i] == 0) candidates_.push_back(static_cast<int>(i));
  }
  return requirement;
}

void WorkingNetwork::add_reference(int value, int& cost) {
  if (references_[static_cast<std::size_t>(value)]++ > 0 || value < kWindowPixels) return;
  const Gate& gate = network_.gates[static_cast<std::size_t>(value - kWindowPixels)];
  cost += counter_.add(gate);
  for (const std::uint16_t input : gate.inputs) add_reference(input, cost);
}

void WorkingNetwork::drop_reference(int value, int& cost) {
  if (--references_[static_cast<std::size_t>(value)] > 0 || value < kWindowPixels) return;
  const Gate& gate = network_.gates[static_cast<std::size_t>(value - kWindowPixels)];
  cost += counter_.remove(gate);
  for (const std::uint16_t input : gate.inputs) drop_reference(input, cost);
}

/// Whether three candidates suffice; if so, sets the gate, else learns a pair that shows why not.
bool WorkingNetwork::test(const Requirement& requirement, const std::array<int, 3>& candidates,
                          std::uint64_t used, Pairs& pairs, Gate& gate) {
  gate.function = 0;
  const Words* tables[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const int value = candidates_[static_cast<std::size_t>(candidates[i])];
    gate.inputs[i] = static_cast<std::uint16_t>(value);
    tables[i] = &tables_[static_cast<std::size_t>(value)].words;
  }
  for (unsigned row = 0; row < 8; ++row) {
    const auto mask = [row](int bit) { return (row >> bit & 1) - std::uint64_t{1}; };
    Words on;
    Words off;
    for (std::size_t w = 0; w < on.size(); ++w) {
      const std::uint64_t here =
          ((*tables[0])[w] ^ mask(2)) & ((*tables[1])[w] ^ mask(1)) & ((*tables[2])[w] ^ mask(0));
      on[w] = here & requirement.on[w];
      off[w] = here & requirement.off[w];
    }
    if (is_empty(on)) continue;
    if (!is_empty(off)) {
      pairs.learn(first_bit(on), first_bit(off), used);
      return false;
    }
    gate.function = static_cast<std::uint8_t>(gate.function | 1U << row);
  }
  return true;
}

/// `freed`: the cost of the gate and of what only it needs.
void WorkingNetwork::offer(const Gate& gate, int freed, Choice& best, Random& random) {
  int added = counter_.add(gate);
  int dropped = 0;
  for (const std::uint16_t input : gate.inputs) add_reference(input, added);
  for (const std::uint16_t input : gate.inputs) drop_reference(input, dropped);
  static_cast<void>(counter_.remove(gate));
  const int gain = freed - added;
  if (gain < 0 || gain < best.gain) return;
  if (gain > best.gain) best.ties = 0;
  best.gain = gain;
  if (random.below(++best.ties) == 0) best.gate = gate;
}

/// Triples that distinguish all pairs: the first candidate distinguishes some pair, the second the
/// next pair that the first does not, the third the next that neither does.
std::int64_t WorkingNetwork::search_triples(const Requirement& requirement, int freed, Pairs& pairs,
                                            Choice& best, Random& random) {
  constexpr int kMaxTests = 200;
  constexpr int kTestWork = 120;
  std::int64_t work = 0;
  int tests = 0;
  const int turn = random.below(64);
  const auto any_of = [turn](std::uint64_t set) {
    return (std::countr_zero(std::rotr(set, turn)) + turn) % 64;
  };
  const auto try_triple = [&](int a, int b, int c, std::uint64_t used) {
    Gate gate;
    ++tests;
    work += kTestWork;
    if (test(requirement, {a, b, c}, used, pairs, gate)) offer(gate, freed, best, random);
  };
  const auto bit = [](int pair) { return std::uint64_t{1} << pair; };
  const int first = any_of(pairs.all());
  for (const std::uint8_t a : pairs.covering(first)) {
    const std::uint64_t after_a = pairs.all() & ~pairs.distinguished(a);
    if (after_a == 0) {
      try_triple(a, a, a, bit(first));
      continue;
    }
    const int second = any_of(after_a);
    for (const std::uint8_t b : pairs.covering(second)) {
      if (tests > kMaxTests) return work;
      const std::uint64_t after_b = after_a & ~pairs.distinguished(b);
      if (after_b == 0) {
        try_triple(a, b, b, bit(first) | bit(second));
        continue;
      }
      const int third = any_of(after_b);
      const auto last = pairs.covering(third);
      work += static_cast<std::int64_t>(last.size());
      for (const std::uint8_t c : last) {
        if ((after_b & ~pairs.distinguished(c)) != 0) continue;
        try_triple(a, b, c, bit(first) | bit(second) | bit(third));
      }
    }
  }
  return work;
}

void WorkingNetwork::replace(int value, SignedValue by) {
  for (Gate& gate : network_.gates) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (gate.inputs[i] != value) continue;
      gate.inputs[i] = static_cast<std::uint16_t>(by.value);
      if (by.inverted) gate.function = with_inverted_input(gate.function, static_cast<int>(i));
    }
  }
  if (network_.output != value) return;
  network_.output = by.value;
  if (!by.inverted) return;
  const auto input = static_cast<std::uint16_t>(by.value);
  network_.gates.push_back({kNot, {input, input, input}});
  network_.output = kWindowPixels + gates() - 1;
}

/// The single input that a gate passes on, if it does.
std::optional<SignedValue> passed_on(const Gate& gate) {
  const auto& [a, b, c] = gate.inputs;
  if (a != b || b != c) return std::nullopt;
  const bool at_0 = (gate.function & 1) != 0;
  const bool at_1 = (gate.function & 0x80) != 0;
  if (at_0 == at_1) return std::nullopt;
  return SignedValue{a, at_0};
}

std::int64_t WorkingNetwork::improve(int index, Pairs& pairs, Random& random) {
  const int value = kWindowPixels + index;
  const Requirement requirement = requirement_of(value);
  const auto size = static_cast<std::int64_t>(tables_.size());
  std::int64_t work = 60 * (size - value) + 40 * size + 500;
  Gate& gate = network_.gates[static_cast<std::size_t>(index)];
  if (is_empty(requirement.on) || is_empty(requirement.off)) {
    const std::uint8_t constant = is_empty(requirement.on) ? 0 : 255;
    if (gate.function == constant) return work;
    gate = {constant, {0, 0, 0}};
    tidy();
    return work;
  }
  pairs.reset(tables_, candidates_, requirement, random);
  int freed = counter_.remove(gate);
  for (const std::uint16_t input : gate.inputs) drop_reference(input, freed);
  Choice best;
  work += search_triples(requirement, freed, pairs, best, random);
  int restored = counter_.add(gate);
  for (const std::uint16_t input : gate.inputs) add_reference(input, restored);
  if (best.ties == 0) return work;
  gate = best.gate;
  const auto passed = passed_on(gate);
  if (passed && !(passed->inverted && network_.output == value)) replace(value, *passed);
  tidy();
  return work;
}

bool WorkingNetwork::expand(int index, const PixelOrder& order) {
  const int value = kWindowPixels + index;
  static_cast<void>(requirement_of(value));
  Decomposer decomposer(order);
  decomposer.set_network(network_);
  for (const int candidate : candidates_) {
    decomposer.know(tables_[static_cast<std::size_t>(candidate)], candidate);
  }
  const auto expansion = decomposer.add(tables_[static_cast<std::size_t>(value)]);
  if (!expansion) return false;
  network_ = decomposer.take();
  replace(value, *expansion);
  if (gates() > kMaxGates) return false;
  tidy();
  return true;
}

PixelOrder random_order(Random& random) {
  PixelOrder order;
  for (int i = 0; i < kWindowPixels; ++i) order[static_cast<std::size_t>(i)] = i;
  for (int i = kWindowPixels - 1; i > 0; --i) {
    std::swap(order[static_cast<std::size_t>(i)],
              order[static_cast<std::size_t>(random.below(i + 1))]);
  }
  return order;
}

GateNetwork expansion(const WindowTable& table, const PixelOrder& order) {
  Decomposer decomposer(order);
  for (int i = 0; i < kWindowPixels; ++i) decomposer.know(pixel_table(i), i);
  const SignedValue output = *decomposer.add(table);  // at most 127 gates
  GateNetwork network = decomposer.take();
  network.output = output.value;
  if (output.inverted) {
    const auto input = static_cast<std::uint16_t>(output.value);
    network.gates.push_back({kNot, {input, input, input}});
    network.output = kWindowPixels + static_cast<int>(network.gates.size()) - 1;
  }
  return network;
}

/// For rules that depend on the sums of rows and on the pixel itself, as Life does: the table by
/// seven inputs, bits 2 r and 2 r + 1 of the sum of row r, and the pixel.
std::optional<WindowTable> table_by_row_sums(const WindowTable& table) {
  WindowTable by_sums;
  WindowTable is_set;
  for (std::size_t window = 0; window < WindowTable::kWindows; ++window) {
    std::size_t index = (window >> WindowTable::kCentre & 1) << 6;
    for (int row = 0; row < 3; ++row) {
      const auto sum = static_cast<std::size_t>(std::popcount(window >> (3 * row) & 7));
      index |= sum << (2 * row);
    }
    if (is_set[index] && by_sums[index] != table[window]) return std::nullopt;
    is_set.set(index, true);
    // Inputs 7 and 8 do not matter.
    for (std::size_t rest = 0; rest < 4; ++rest) by_sums.set(index | rest << 7, table[window]);
  }
  return by_sums;
}

/// The network of a table_by_row_sums as one of pixels.
GateNetwork with_row_sums(const GateNetwork& by_sums) {
  constexpr std::uint8_t kSumBits[] = {0x96, 0xE8};  // parity and majority
  constexpr int kInputs = 6;
  GateNetwork network;
  for (int input = 0; input < kInputs; ++input) {
    const auto first = static_cast<std::uint16_t>(input / 2 * 3);
    network.gates.push_back(
        {kSumBits[input % 2],
         {first, static_cast<std::uint16_t>(first + 1), static_cast<std::uint16_t>(first + 2)}});
  }
  const auto moved = [](int value) {
    if (value < kInputs) return value + kWindowPixels;
    if (value == kInputs) return static_cast<int>(WindowTable::kCentre);
    return value < kWindowPixels ? 0 : value + kInputs;  // no table depends on inputs 7 and 8
  };
  for (Gate gate : by_sums.gates) {
    for (std::uint16_t& input : gate.inputs) input = static_cast<std::uint16_t>(moved(input));
    network.gates.push_back(gate);
  }
  network.output = moved(by_sums.output);
  return network;
}

class Search {
 public:
  Search(const WindowTable& table, const GateCosts& costs, SearchEffort effort)
      : table_(table),
        by_sums_(table_by_row_sums(table)),
        costs_(costs),
        work_left_(effort.work),
        best_(start()) {}

  GateNetwork run() {
    while (work_left_ > 0) descend();
    return best_.network();
  }

 private:
  WorkingNetwork random_expansion() {
    const PixelOrder order = random_order(random_);
    if (by_sums_) return {with_row_sums(expansion(*by_sums_, order)), costs_};
    return {expansion(table_, order), costs_};
  }

  /// The smallest of a few expansions.
  WorkingNetwork start() {
    constexpr int kStarts = 5;
    constexpr int kGateWork = 10'000;
    WorkingNetwork smallest = random_expansion();
    for (int i = 1; i < kStarts; ++i) {
      WorkingNetwork circuit = random_expansion();
      work_left_ -= kGateWork * circuit.gates();
      if (circuit.cost() < smallest.cost()) smallest = std::move(circuit);
    }
    return smallest;
  }

  /// Improves random gates until that stops helping.
  void shrink(WorkingNetwork& circuit) {
    constexpr int kPatience = 30;  // attempts per gate
    for (int idle = 0; work_left_ > 0 && idle < kPatience * circuit.gates(); ++idle) {
      const int before = circuit.cost();
      work_left_ -= circuit.improve(random_.below(circuit.gates()), pairs_, random_);
      if (circuit.cost() < before) idle = 0;
    }
    if (circuit.cost() < best_.cost()) best_ = circuit;
  }

  /// One run from a new start: shrinks, expands and shrinks, until that stops helping.
  void descend() {
    constexpr int kMaxFailures = 150;
    constexpr int kExpansionWork = 100'000;
    WorkingNetwork circuit = start();
    shrink(circuit);
    int lowest = circuit.cost();
    for (int failures = 0; work_left_ > 0 && failures < kMaxFailures; ++failures) {
      if (circuit.gates() == 0) {
        work_left_ = 0;  // the output is a pixel
        return;
      }
      WorkingNetwork next = circuit;
      work_left_ -= kExpansionWork;
      const PixelOrder order = random_order(random_);
      if (!next.expand(random_.below(next.gates()), order)) continue;
      shrink(next);
      const int rise = next.cost() - circuit.cost();
      if (rise > 1 || (rise == 1 && random_.below(10) > 0)) continue;
      circuit = std::move(next);
      if (circuit.cost() >= lowest) continue;
      lowest = circuit.cost();
      failures = 0;
    }
  }

  const WindowTable& table_;
  const std::optional<WindowTable> by_sums_;
  const GateCosts& costs_;
  Random random_;
  Pairs pairs_;
  std::int64_t work_left_;
  WorkingNetwork best_;
};

}  // namespace

GateNetwork minimised_network(const WindowTable& table, const GateCosts& costs,
                              SearchEffort effort) {
  return Search(table, costs, effort).run();
}

}  // namespace thinbench::detail
