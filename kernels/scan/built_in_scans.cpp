// The scan functions of built-in rules. Compiled per ISA.
//
// Cost per register: of whole rows 1 load, 1 store and 4 instructions for the two neighbours (2
// lane shifts, 2 funnel shifts; 6 without VBMI2); of lanes 1 load, 1 store and 2 shifts. In
// addition the rule's gates, 1 gate to detect changes and 1 more to keep fixed pixels. Padding
// needs no special case because these rules never set background pixels.
#include "core/exported.hpp"
#include "scan/layouts.hpp"
#include "scan/scans.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

consteval BuiltInScans make_scans() {
  return {static_cast<Index>(WordBatch::size),
          for_whole_rows([]<class Rows>() { return scan_functions_by_rule<Rows>(); }),
          {repeat_functions_by_rule<RowsOfLanes32>(), repeat_functions_by_rule<RowsOfLanes64>(),
           repeat_functions_by_rule<RowsOfLanes128>()}};
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const BuiltInScans Exported<BuiltInScans, kThisIsa>::kKernels = make_scans();

}  // namespace thinbench::detail
