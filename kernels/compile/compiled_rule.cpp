#include "compile/compiled_rule.hpp"

#include <algorithm>
#include <list>

#include "compile/gate_search.hpp"
#include "compile/interpreters.hpp"
#include "compile/two_input.hpp"
#include "core/exported.hpp"
#include "rules/window.hpp"

namespace thinbench::detail {
namespace {

/// One of the eight symmetries of the square.
Permutation symmetry_of(int number) {
  Permutation result = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  const auto then = [&](const Permutation& next) {
    Permutation both;
    for (std::size_t k = 0; k < both.size(); ++k) both[k] = result[next[k]];
    result = both;
  };
  for (int i = 0; i < number % 4; ++i) then(kRotateBy90);
  if (number >= 4) then(kMirror);
  return result;
}

WindowTable transformed(const WindowTable& table, const Permutation& symmetry) {
  return make_window_table([&](std::size_t window) { return table[permuted(window, symmetry)]; });
}

/// The network on transformed windows.
GateNetwork transformed(GateNetwork network, const Permutation& symmetry) {
  const auto moved = [&](int value) {
    return value < kWindowPixels ? static_cast<int>(symmetry[static_cast<std::size_t>(value)])
                                 : value;
  };
  for (Gate& gate : network.gates) {
    for (std::uint16_t& input : gate.inputs) input = static_cast<std::uint16_t>(moved(input));
  }
  network.output = moved(network.output);
  return network;
}

/// Whether a table gives `value` where the pixel itself has the other value.
bool changes_to(const WindowTable& table, bool value) {
  for (std::size_t window = 0; window < WindowTable::kWindows; ++window) {
    const bool before = (window >> WindowTable::kCentre & 1) != 0;
    if (before != value && table[window] == value) return true;
  }
  return false;
}

}  // namespace

CompiledRule::CompiledRule(std::vector<WindowTable> tables, SearchEffort effort)
    : tables_(std::move(tables)), effort_(effort) {
  const auto any = [this](bool value) {
    return std::any_of(tables_.begin(), tables_.end(),
                       [=](const WindowTable& table) { return changes_to(table, value); });
  };
  adds_pixels_ = any(true);
  removes_pixels_ = any(false);
}

/// Sub-iterations are often the same table rotated or mirrored: each gets the best circuit of all.
/// Functions of rows become functions of columns when rotated by 90 degrees, which costs more.
std::vector<GateNetwork> CompiledRule::find_networks(const GateCosts& costs) const {
  std::vector<GateNetwork> found;
  for (const WindowTable& table : tables_) {
    found.push_back(minimised_network(table, costs, effort_));
  }
  std::vector<GateNetwork> best = found;
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    for (std::size_t j = 0; j < tables_.size(); ++j) {
      for (int number = 0; number < 8; ++number) {
        const Permutation symmetry = symmetry_of(number);
        if (i == j || transformed(tables_[j], symmetry) != tables_[i]) continue;
        GateNetwork network = transformed(found[j], symmetry);
        if (cost_of(network, costs) < cost_of(best[i], costs)) best[i] = std::move(network);
      }
    }
  }
  return best;
}

CompiledRule::Circuits CompiledRule::make_circuits(bool ternary) const {
  Circuits circuits;
  circuits.networks = find_networks(ternary ? ternary_costs() : two_input_costs());
  for (GateNetwork& network : circuits.networks) {
    if (!ternary) network = in_two_input_gates(network);
    circuits.slot_networks.push_back(with_slots(network));
  }
  return circuits;
}

const CompiledRule::Circuits& CompiledRule::circuits(bool ternary) const {
  const std::lock_guard lock(mutex_);
  auto& circuits = circuits_[ternary ? 1 : 0];
  if (!circuits) circuits = std::make_unique<const Circuits>(make_circuits(ternary));
  return *circuits;
}

const GateNetwork& CompiledRule::circuit(std::size_t sub_iteration) const {
  return circuits(true).networks.at(sub_iteration);
}

BoundRule CompiledRule::bind_interpreter(ScanFunction interpreter, bool ternary,
                                         Index register_elements) const {
  const Circuits& all = circuits(ternary);
  BoundRule rule;
  rule.register_elements = register_elements;
  rule.adds_pixels = adds_pixels_;
  rule.sub_iterations = tables_.size();
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    rule.scans[i] = {interpreter, &all.slot_networks[i]};
  }
  return rule;
}

BoundRule CompiledRule::bind(Isa isa, Layout layout, bool fixed) const {
  const Interpreters& interpreters = kernels_of<Interpreters>(isa);
  BoundRule rule = bind_interpreter(interpreters.by_layout[static_cast<std::size_t>(layout)],
                                    interpreters.ternary, interpreters.register_elements);
  const Circuits& all = circuits(interpreters.ternary);
  const std::lock_guard lock(mutex_);
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    const CodeKey key = {i, isa, layout, fixed};
    auto found = code_.find(key);
    if (found == code_.end()) {  // null, too, is kept: what is denied takes long to try again
      found = code_.emplace(key, MachineCode::make(all.networks[i], isa, layout, fixed)).first;
    }
    if (found->second) rule.scans[i] = found->second->scan();
  }
  return rule;
}

std::shared_ptr<const CompiledRule> compile(std::span<const WindowTable> tables,
                                            SearchEffort effort) {
  struct Entry {
    std::vector<WindowTable> tables;
    SearchEffort effort;
    std::shared_ptr<const CompiledRule> rule;
  };
  constexpr std::size_t kMaxEntries = 64;
  // Never destroyed, as threads may still run when the program ends.
  static auto& mutex = *new std::mutex;
  static auto& entries = *new std::list<Entry>;  // the last used first
  const std::lock_guard lock(mutex);
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) {
    return entry.effort == effort &&
           std::equal(entry.tables.begin(), entry.tables.end(), tables.begin(), tables.end());
  });
  if (found != entries.end()) {
    entries.splice(entries.begin(), entries, found);
    return entries.front().rule;
  }
  std::vector<WindowTable> copy(tables.begin(), tables.end());
  auto rule = std::make_shared<const CompiledRule>(copy, effort);
  entries.push_front({std::move(copy), effort, rule});
  if (entries.size() > kMaxEntries) entries.pop_back();
  return rule;
}

}  // namespace thinbench::detail
