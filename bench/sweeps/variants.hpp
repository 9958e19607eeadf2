// Which variant stands for an operation.
#pragma once

#include "harness/operation.hpp"

namespace thinbench {

/// What the library would choose on an image of this width were `cap` the highest ISA here;
/// nullptr where nothing runs.
[[nodiscard]] const Variant* chosen_variant(const Operation& operation, Index width, bool threaded,
                                            Isa cap = kAllIsas.back());

/// The preferred one that needs neither SIMD nor a vectorising compiler, on one thread; nullptr for
/// none.
[[nodiscard]] const Variant* scalar_variant(const Operation& operation, Index width);

/// The same technique and ISA on one thread; nullptr for none.
[[nodiscard]] const Variant* on_one_thread(const Operation& operation, const Variant& threaded);

}  // namespace thinbench
