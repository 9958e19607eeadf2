// The interpreters of one ISA.
#pragma once

#include "scan/bound_rule.hpp"

namespace thinbench::detail {

/// A program is a SlotNetwork. Ternary where gates with three inputs are
/// one instruction. The entry of a layout that an ISA has not is nullptr, and that of tiles: they
/// need machine code.
struct Interpreters {
  bool ternary;
  Index register_elements;
  ScanFunction by_layout[kLayouts];
};

}  // namespace thinbench::detail
