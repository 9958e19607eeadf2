// thinbench-study circuits: the circuits of rules as a C++ header, found by the library's search.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/names.hpp"
#include "compile/gate_search.hpp"
#include "compile/two_input.hpp"
#include "rules/parallel_rules.hpp"
#include "rules/window.hpp"
#include "study/study.hpp"

namespace thinbench {
namespace {

using detail::Gate;
using detail::Neighbourhood;

constexpr std::int64_t kMillion = 1'000'000;
constexpr int kFirstEffort = 1000;  // of a rule without circuits

struct CircuitsOptions {
  std::vector<std::string> rules;
  int effort = 0;  // as in Circuit; 0: that of each circuit
};

/// The rule's published arithmetic or, without one, its expression on all windows.
template <class Type, int sub>
WindowTable definition_of() {
  return make_window_table([](std::size_t window) {
    const auto at = [window](int pixel) { return static_cast<std::uint8_t>(window >> pixel & 1); };
    const Neighbourhood<std::uint8_t> n = {at(4), at(5), at(2), at(1), at(0),
                                           at(3), at(6), at(7), at(8)};
    if constexpr (requires { Type::template published<sub>(n); }) {
      return Type::template published<sub>(n) != 0;
    } else {
      return (Type::template next<sub>(n) & 1) != 0;
    }
  });
}

bool is_rotation_of(WindowTable table, const WindowTable& other) {
  for (int quarter = 0; quarter < 4; ++quarter) {
    if (table == other) return true;
    table = make_window_table([turned = table](std::size_t window) {
      return turned[detail::permuted(window, detail::kRotateBy90)];
    });
  }
  return false;
}

/// A circuit to print, or the one in the library.
struct KnownCircuit {
  int search_effort;
  std::vector<Gate> gates;
};

template <std::size_t count>
KnownCircuit known(const detail::Circuit<count>& circuit) {
  return {circuit.search_effort, {circuit.gates.begin(), circuit.gates.end()}};
}

KnownCircuit search(const WindowTable& table, bool ternary, int effort) {
  constexpr bool kRowsOnce = false;
  const detail::GateCosts costs =
      ternary ? detail::ternary_costs(kRowsOnce) : detail::two_input_costs(kRowsOnce);
  detail::GateNetwork network = detail::minimised_network(table, costs, {effort * kMillion});
  if (!ternary) network = detail::in_two_input_gates(network);
  return {effort, std::move(network.gates)};
}

/// The circuit that a new search finds. The one in the library stays if it was found by hand, or if
/// a search with another effort finds no smaller one.
KnownCircuit renewed(KnownCircuit in_library, const WindowTable& table, bool ternary,
                     const CircuitsOptions& options) {
  const bool is_new = in_library.gates.empty();
  const bool is_repeated = options.effort == 0 && !is_new;
  if (is_repeated && in_library.search_effort == detail::kByHand) return in_library;
  if (is_repeated) return search(table, ternary, in_library.search_effort);
  KnownCircuit found = search(table, ternary, options.effort != 0 ? options.effort : kFirstEffort);
  return is_new || found.gates.size() < in_library.gates.size() ? found : in_library;
}

std::string text_of(const KnownCircuit& circuit, std::string_view variable) {
  constexpr std::size_t kPerLine = 4;
  const std::string effort =
      circuit.search_effort == detail::kByHand ? "kByHand" : std::to_string(circuit.search_effort);
  std::string text = fmt::format("template <>\ninline constexpr Circuit<{}> {} = {{{}, {{{{",
                                 circuit.gates.size(), variable, effort);
  for (std::size_t i = 0; i < circuit.gates.size(); ++i) {
    const auto& [function, inputs] = circuit.gates[i];
    text += fmt::format("{}{{0x{:02X}, {{{}, {}, {}}}}},", i % kPerLine == 0 ? "\n    " : " ",
                        function, inputs[0], inputs[1], inputs[2]);
  }
  return text + "\n}}};\n\n";
}

/// Prints the circuits of the sub-iterations of rules.
class Printer {
 public:
  Printer(const CircuitsOptions& options, std::ostream& out) : options_(options), out_(out) {}

  template <class Type, BuiltInRule rule>
  void print_rule() {
    if (!is_wanted(rule_name(rule), !detail::kThreeInputCircuit<rule, 0>.gates.empty())) return;
    tables_.clear();
    [&]<int... subs>(std::integer_sequence<int, subs...>) {
      (print_sub_iteration<Type, rule, subs>(), ...);
    }
    (std::make_integer_sequence<int, Type::kSubIterations>{});
  }

 private:
  [[nodiscard]] bool is_wanted(std::string_view rule, bool has_circuits) const {
    const auto& names = options_.rules;
    if (names.empty()) return has_circuits;
    return std::find(names.begin(), names.end(), rule) != names.end();
  }

  /// Unless it is an earlier one rotated.
  template <class Type, BuiltInRule rule, int sub>
  void print_sub_iteration() {
    const WindowTable table = definition_of<Type, sub>();
    if (std::any_of(tables_.begin(), tables_.end(),
                    [&](const WindowTable& other) { return is_rotation_of(table, other); }))
      return;
    tables_.push_back(table);
    const std::string key = fmt::format("<BuiltInRule::{}, {}>", rule_name(rule), sub);
    const auto print = [&](const char* variable, KnownCircuit in_library, bool ternary) {
      out_ << text_of(renewed(std::move(in_library), table, ternary, options_), variable + key)
           << std::flush;
    };
    print("kThreeInputCircuit", known(detail::kThreeInputCircuit<rule, sub>), true);
    print("kTwoInputCircuit", known(detail::kTwoInputCircuit<rule, sub>), false);
  }

  const CircuitsOptions& options_;
  std::ostream& out_;
  std::vector<WindowTable> tables_;
};

/// The rules that the search can serve.
template <class Body>
void for_each_rule_of_windows(const Body& body) {
  detail::for_each_parallel_rule([&]<class Type>(auto rule) {
    if constexpr (!detail::TwoStageRule<Type>) body.template operator()<Type>(rule);
  });
}

void check_names(const std::vector<std::string>& names) {
  std::vector<std::string_view> known;
  for_each_rule_of_windows([&]<class Type>(BuiltInRule rule) { known.push_back(rule_name(rule)); });
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      reject_name("rule", name, known);
    }
  }
}

int run(const CircuitsOptions& options, const Console& console) {
  check_names(options.rules);
  console.out << R"(// The circuits of rules. Written by `thinbench-study circuits`.
#pragma once

#include "rules/built_in/circuit.hpp"

namespace thinbench::detail {

// clang-format off

)";
  Printer printer(options, console.out);
  for_each_rule_of_windows(
      [&]<class Type>(auto rule) { printer.print_rule<Type, decltype(rule)::value>(); });
  console.out << "// clang-format on\n\n}  // namespace thinbench::detail\n";
  return kSuccess;
}

}  // namespace

Command add_circuits_command(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("circuits", "Search for the circuits of rules and print their header");
  const auto options = std::make_shared<CircuitsOptions>();
  app->add_option("RULE", options->rules, "Rules, default: all that have circuits")->type_name("");
  add_value(*app, "--effort", options->effort,
            "Work of each search, a millisecond or so each; default: as recorded",
            whole_number(1, 1'000'000'000), "N");
  app->footer(R"(Examples:
  thinbench-study circuits > kernels/rules/built_in/circuits.hpp
  thinbench-study circuits spta_directional
  thinbench-study circuits lu_wang --effort 10000

Equal efforts find equal circuits on every machine. With --effort, a circuit of the library stays where
the search finds none with fewer gates.)");
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
