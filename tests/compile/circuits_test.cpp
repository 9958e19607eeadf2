// Circuits that the search finds are right, small, and always the same; those that need many values
// at once, more than any table for which the search was tried, are interpreted.
#include <algorithm>
#include <array>
#include <cstdint>

#include <gtest/gtest.h>

#include "compile/compiled_rule.hpp"
#include "compile/gate_search.hpp"
#include "compile/interpreters.hpp"
#include "compile/machine_code.hpp"
#include "compile/slots.hpp"
#include "compile/two_input.hpp"
#include "core/byte_image.hpp"
#include "core/exported.hpp"
#include "harness/splitmix64.hpp"
#include "thinbench/named_rules.hpp"

namespace thinbench::detail {
namespace {

constexpr SearchEffort kShort = {1'000'000};

WindowTable random_table(std::uint64_t seed) {
  WindowTable table;
  for (std::size_t w = 0; w < table.words.size(); ++w) table.words[w] = splitmix64(seed, w);
  return table;
}

/// The table that a network computes.
WindowTable output_table(const GateNetwork& network) {
  return tables_of(network)[static_cast<std::size_t>(network.output)];
}

/// The same in gates with two inputs.
WindowTable two_input_table(const GateNetwork& network) {
  const GateNetwork converted = in_two_input_gates(network);
  for (const Gate& gate : converted.gates) EXPECT_TRUE(is_native<std::uint64_t>(gate.function));
  return output_table(converted);
}

int gates_of(const WindowTable& table) {
  const GateNetwork network = minimised_network(table, ternary_costs(), kThoroughSearch);
  EXPECT_EQ(output_table(network), table);
  return static_cast<int>(network.gates.size());
}

TEST(GateTable, has_the_gates_function_of_its_inputs) {
  for (int function = 0; function < 256; ++function) {
    const auto code = static_cast<std::uint8_t>(function);
    const WindowTable table = gate_table(code, pixel_table(2), pixel_table(7), pixel_table(8));
    for (std::size_t window = 0; window < WindowTable::kWindows; ++window) {
      const std::size_t row = (window >> 2 & 1) << 2 | (window >> 7 & 1) << 1 | window >> 8;
      ASSERT_EQ(table[window], (code >> row & 1) != 0) << function << " at window " << window;
    }
  }
}

TEST(TwoInputSteps, compute_every_gate_in_at_most_five_steps) {
  for (int function = 0; function < 256; ++function) {
    const auto code = static_cast<std::uint8_t>(function);
    const GateNetwork network = {{{code, {1, 3, 5}}}, kWindowPixels};
    EXPECT_EQ(two_input_table(network),
              gate_table(code, pixel_table(1), pixel_table(3), pixel_table(5)))
        << function;
    EXPECT_LE(two_input_steps(code), 5) << function;
  }
}

TEST(GateSearch, circuits_compute_their_tables) {
  for (int i = 0; i < 40; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    WindowTable table = random_table(seed);
    // Sparse, dense, only removing and only adding tables, too.
    const WindowTable other = random_table(seed + 1000);
    for (std::size_t w = 0; w < table.words.size(); ++w) {
      const std::uint64_t centre = pixel_table(4).words[w];
      const std::uint64_t choices[] = {table.words[w], table.words[w] & other.words[w],
                                       table.words[w] | other.words[w], table.words[w] & centre,
                                       table.words[w] | centre};
      table.words[w] = choices[i % 5];
    }
    for (const GateCosts& costs : {ternary_costs(), two_input_costs()}) {
      const GateNetwork network = minimised_network(table, costs, kShort);
      EXPECT_EQ(output_table(network), table) << i;
      EXPECT_EQ(two_input_table(network), table) << i;
    }
  }
}

TEST(GateSearch, needs_no_gate_for_pixels_and_one_for_complements_and_constants) {
  EXPECT_EQ(minimised_network(pixel_table(4), ternary_costs(), kShort).gates.size(), 0U);
  WindowTable background = pixel_table(4);
  for (std::uint64_t& word : background.words) word = ~word;
  const GateNetwork inverse = minimised_network(background, ternary_costs(), kShort);
  EXPECT_EQ(inverse.gates.size(), 1U);
  EXPECT_EQ(output_table(inverse), background);
  EXPECT_EQ(minimised_network(WindowTable{}, ternary_costs(), kShort).gates.size(), 1U);
}

TEST(GateSearch, finds_equal_circuits_for_equal_tables) {
  const WindowTable table = random_table(7);
  const GateNetwork first = minimised_network(table, ternary_costs(), kShort);
  const GateNetwork second = minimised_network(table, ternary_costs(), kShort);
  ASSERT_EQ(first.gates.size(), second.gates.size());
  for (std::size_t i = 0; i < first.gates.size(); ++i) {
    EXPECT_EQ(first.gates[i].function, second.gates[i].function);
    EXPECT_EQ(first.gates[i].inputs, second.gates[i].inputs);
  }
}

std::uint64_t hash_of(const GateNetwork& network) {
  std::uint64_t hash = splitmix64(0, static_cast<std::uint64_t>(network.output));
  for (const Gate& gate : network.gates) {
    hash = splitmix64(hash, gate.function);
    for (const auto input : gate.inputs) hash = splitmix64(hash, static_cast<std::uint64_t>(input));
  }
  return hash;
}

/// Recorded: a change of the search that finds other circuits changes the numbers, too.
TEST(GateSearch, finds_the_same_circuits_on_every_machine) {
  constexpr SearchEffort effort = {20'000'000};
  const WindowTable life = find_named_rule("life")->sub_iterations[0];
  EXPECT_EQ(hash_of(minimised_network(random_table(7), two_input_costs(), effort)),
            894251636121709219U);
  EXPECT_EQ(hash_of(minimised_network(life, ternary_costs(), effort)), 3295186732975140956U);
  EXPECT_EQ(
      hash_of(minimised_network(Rule(Rule::guo_hall).sub_iterations()[0], ternary_costs(), effort)),
      595876885539656480U);
}

WindowTable table_of(BuiltInRule rule, std::size_t sub_iteration) {
  return Rule(rule).sub_iterations()[sub_iteration];
}

/// For both sub-iterations.
void expect_gates(BuiltInRule rule, int first, int second) {
  const CompiledRule compiled({table_of(rule, 0), table_of(rule, 1)}, kThoroughSearch);
  EXPECT_LE(cost_of(compiled.circuit(0), ternary_costs()), first) << rule_name(rule);
  EXPECT_LE(cost_of(compiled.circuit(1), ternary_costs()), second) << rule_name(rule);
}

/// Built-in rules have circuits of 11, 10 and 19 gates, found in hours. A short script of
/// berkeley-abc (strash; dch; if -K 3 -a; lutpack) finds 15 for the first of Zhang and Suen, 17 for
/// the second of scikit-image, 28 for Life and 135 for the random table.
TEST(ThoroughSearch, finds_small_circuits) {
  expect_gates(Rule::zhang_suen, 13, 13);
  expect_gates(Rule::guo_hall, 11, 11);
  expect_gates(Rule::zhang_suen_skimage, 23, 17);
  EXPECT_LE(gates_of(random_table(7)), 75);
}

TEST(ThoroughSearch, computes_functions_of_rows_once) {
  const WindowTable life = find_named_rule("life")->sub_iterations[0];
  const GateNetwork network = minimised_network(life, ternary_costs(), kThoroughSearch);
  EXPECT_LE(cost_of(network, ternary_costs()), 9);
  EXPECT_GT(network.gates.size(), 9U);
}

/// Gates of every pair of pixels, all of which are needed before the last of them is read.
GateNetwork wide_circuit() {
  GateNetwork network;
  for (std::uint16_t a = 0; a < kWindowPixels; ++a) {
    for (std::uint16_t b = 0; b < kWindowPixels; ++b) {
      if (a == b) continue;
      network.gates.push_back({a < b ? kOr : kAndNot, {a, b, b}});
      network.gates.push_back({a < b ? kXor : kAnd, {a, b, b}});
    }
  }
  const auto first = static_cast<std::uint16_t>(kWindowPixels);
  const auto wide = static_cast<std::uint16_t>(first + network.gates.size());
  std::uint16_t sum = first;
  for (auto value = static_cast<std::uint16_t>(first + 1); value < wide; ++value) {
    const std::uint8_t function = value % 3 == 0 ? kOr : kXor;
    network.gates.push_back({function, {sum, value, value}});
    sum = static_cast<std::uint16_t>(first + network.gates.size() - 1);
  }
  network.output = sum;
  return network;
}

/// Lanes of 64 columns, one image in each; rows 0 and kRows + 1 are around it.
constexpr Index kRows = 21;

struct LanesImage {
  Index elements;
  AlignedArray<std::uint64_t> words =
      make_aligned<std::uint64_t>(static_cast<std::size_t>(elements * (kRows + 2)));

  [[nodiscard]] std::uint64_t* row(Index y) const { return words.get() + (y + 1) * elements; }
  [[nodiscard]] std::size_t pixel(Index lane, Index x, Index y) const {
    return x < 0 || x > 63 ? 0 : row(y)[lane] >> x & 1;
  }
  [[nodiscard]] std::size_t window(Index lane, Index x, Index y) const {
    std::size_t bits = 0;
    for (Index i = 0; i < 9; ++i) bits |= pixel(lane, x + i % 3 - 1, y + i / 3 - 1) << i;
    return bits;
  }
};

TEST(WideCircuits, are_interpreted_with_slots_on_the_heap) {
  const SlotNetwork circuit = with_slots(wide_circuit());
  ASSERT_GT(circuit.slots, kMaxSlotsOnStack);
  const WindowTable expected =
      tables_of(wide_circuit())[static_cast<std::size_t>(wide_circuit().output)];
  for (const Isa isa : all_isas()) {
    if (!isa_available(isa)) continue;
    const Interpreters& interpreters = kernels_of<Interpreters>(isa);
    const LanesImage before = {interpreters.register_elements};
    const LanesImage after = {interpreters.register_elements};
    for (Index y = 0; y < kRows; ++y) {
      for (Index lane = 0; lane < before.elements; ++lane) {
        before.row(y)[lane] =
            splitmix64(static_cast<std::uint64_t>(y), static_cast<unsigned>(lane));
      }
      std::copy_n(before.row(y), before.elements, after.row(y));
    }
    const Index stride = 8 * before.elements;
    interpreters.by_layout[static_cast<std::size_t>(Layout::lanes_64)](
        &circuit, {after.row(0), stride, after.row(0), stride, kRows, kRows, nullptr});
    for (Index y = 0; y < kRows; ++y) {
      for (Index lane = 0; lane < before.elements; ++lane) {
        for (Index x = 0; x < 64; ++x) {
          ASSERT_EQ(after.pixel(lane, x, y) != 0, expected[before.window(lane, x, y)])
              << isa_name(isa) << ": lane " << lane << ", " << x << ", " << y;
        }
      }
    }
  }
}

TEST(WideCircuits, have_no_machine_code_as_its_frame_is_not_probed) {
  if (!MachineCode::is_available(Isa::avx2)) GTEST_SKIP() << "no machine code here";
  EXPECT_EQ(MachineCode::make(wide_circuit(), Isa::avx2, Layout::words, false), nullptr);
}

TEST(MachineCode, begins_with_the_instruction_that_marks_targets_of_indirect_calls) {
  if (!MachineCode::is_available(Isa::avx2)) GTEST_SKIP() << "no machine code here";
  const GateNetwork identity = {.gates = {}, .output = WindowTable::kCentre};
  const auto code = MachineCode::make(identity, Isa::avx2, Layout::words, false);
  const auto* const bytes = static_cast<const std::uint8_t*>(code->scan().program);
  constexpr std::array<std::uint8_t, 4> endbr64 = {0xF3, 0x0F, 0x1E, 0xFA};
  EXPECT_TRUE(std::equal(endbr64.begin(), endbr64.end(), bytes));
}

}  // namespace
}  // namespace thinbench::detail
