// Interpreters of tables on vectors, compiled per ISA.
#include "compile/interpreter.hpp"

#include "compile/interpreters.hpp"
#include "core/exported.hpp"
#include "scan/layouts.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

consteval Interpreters make_interpreters() {
  return {
      TernaryGate<WordBatch>::kOneInstruction,
      static_cast<Index>(WordBatch::size),
      {&interpret<PlaneRows<WordBatch>>,
       for_whole_rows([]<class Rows>() -> ScanFunction { return &interpret<Rows>; }),
       &interpret<RowsOfLanes32>, &interpret<RowsOfLanes64>, &interpret<RowsOfLanes128>, nullptr}};
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const Interpreters Exported<Interpreters, kThisIsa>::kKernels = make_interpreters();

}  // namespace thinbench::detail
