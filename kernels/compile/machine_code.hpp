// Machine code for circuits, made at run time on x86-64.
#pragma once

#include <cstddef>
#include <memory>

#include "compile/gate_network.hpp"
#include "scan/bound_rule.hpp"
#include "thinbench/isa.hpp"

namespace thinbench::detail {

/// Set to "off", makes every rule run in the interpreter. Read once, on first use.
inline constexpr const char* kMachineCodeVariable = "THINBENCH_MACHINE_CODE";

inline constexpr std::size_t kMaxFrameBytes = 4096 - 64;  // a page less what aligns it

/// Owns the pages of a scan function: written first, then executable, never both at once.
class MachineCode {
 public:
  /// A scan function for an ISA from avx2 on, to which all gates are native. With `fixed` every
  /// ColumnScan must have fixed pixels, else none. nullptr if this build, the ISA or the layout has
  /// none, if the system denies executable memory, or if the circuit needs more than kMaxFrameBytes
  /// of stack (random tables need 1.2 KB).
  [[nodiscard]] static std::shared_ptr<const MachineCode> make(const GateNetwork& network, Isa isa,
                                                               Layout layout, bool fixed);
  /// Whether there is machine code for this ISA here, tried once.
  [[nodiscard]] static bool is_available(Isa isa);
  ~MachineCode();
  MachineCode(const MachineCode&) = delete;
  MachineCode& operator=(const MachineCode&) = delete;

  /// Its program is the address of the code. Valid as long as this object.
  [[nodiscard]] BoundScan scan() const;

 private:
  MachineCode() = default;

  void* memory_ = nullptr;
  std::size_t bytes_ = 0;
};

}  // namespace thinbench::detail
