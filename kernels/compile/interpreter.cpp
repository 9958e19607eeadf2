// Interpreters of tables on vectors, compiled once for every ISA.
#include "compile/interpreter.hpp"

#include "compile/interpreters.hpp"
#include "core/exported.hpp"
#include "scan/layouts.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

consteval Interpreters make_interpreters() {
  Interpreters interpreters{
      TernaryGate<WordBatch>::kOneInstruction, static_cast<Index>(WordBatch::size), {}};
  fill_layouts(interpreters.by_layout, []<class Rows>() { return &interpret<Rows>; });
  return interpreters;
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const Interpreters Exported<Interpreters, kThisIsa>::kKernels = make_interpreters();

}  // namespace thinbench::detail
