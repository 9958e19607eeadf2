// Compiled tables, shared by all rules that have them.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <tuple>
#include <vector>

#include "compile/gate_search.hpp"
#include "compile/machine_code.hpp"
#include "compile/slots.hpp"
#include "scan/bound_rule.hpp"

namespace thinbench::detail {

/// The tables of a rule with circuits and machine code, each made when first needed.
/// Thread-safe.
class CompiledRule {
 public:
  CompiledRule(std::vector<WindowTable> tables, SearchEffort effort);

  [[nodiscard]] std::span<const WindowTable> tables() const { return tables_; }
  [[nodiscard]] bool adds_pixels() const { return adds_pixels_; }
  [[nodiscard]] bool removes_pixels() const { return removes_pixels_; }

  /// The circuit of a sub-iteration with the fewest gates of three inputs.
  [[nodiscard]] const GateNetwork& circuit(std::size_t sub_iteration) const;

  /// With `fixed` every scan must have fixed pixels, else none. Machine code where there is some,
  /// else the interpreter; nullptr where a layout has neither. Valid as long as this object.
  [[nodiscard]] BoundRule bind(Isa isa, Layout layout, bool fixed) const;
  /// By an interpreter, for ISAs with gates of three inputs or for others.
  [[nodiscard]] BoundRule bind_interpreter(ScanFunction interpreter, bool ternary,
                                           Index register_elements) const;

 private:
  /// The circuits for one kind of processor.
  struct Circuits {
    std::vector<GateNetwork> networks;
    std::vector<SlotNetwork> slot_networks;
  };

  const Circuits& circuits(bool ternary) const;
  [[nodiscard]] Circuits make_circuits(bool ternary) const;
  [[nodiscard]] std::vector<GateNetwork> find_networks(const GateCosts& costs) const;

  std::vector<WindowTable> tables_;
  SearchEffort effort_;
  bool adds_pixels_;
  bool removes_pixels_;

  mutable std::mutex mutex_;
  mutable std::unique_ptr<const Circuits> circuits_[2];  // two-input, ternary
  using CodeKey = std::tuple<std::size_t, Isa, Layout, bool>;
  mutable std::map<CodeKey, std::shared_ptr<const MachineCode>> code_;
};

/// The compiled rule of these tables, the same object for equal tables while it is among the 64
/// that were used last.
[[nodiscard]] std::shared_ptr<const CompiledRule> compile(std::span<const WindowTable> tables,
                                                          SearchEffort effort);

}  // namespace thinbench::detail
