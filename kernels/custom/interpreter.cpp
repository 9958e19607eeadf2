// Interpreters of custom rules on vectors, compiled once for every ISA.
#include "custom/interpreter.hpp"

#include "custom/interpreters.hpp"
#include "dispatch/exported.hpp"
#include "simd/vector.hpp"
#include "thinning/engines/layouts.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

/// A part of a row of a plane.
struct PlaneRows {
  using Word = WordBatch;
  static RowTriple<Word> row(const std::uint64_t* at) { return load_row<Word>(at); }
};

/// A whole row. A template, see with_neighbours_in_row.
template <class AnyWord>
struct WholeRows {
  using Word = AnyWord;
  static RowTriple<Word> row(const std::uint64_t* at) {
    return with_neighbours_in_row(Word::load_aligned(at));
  }
};

/// Rows of images in lanes.
template <class Lanes>
struct LaneRows {
  using Word = WordBatch;
  static RowTriple<Word> row(const std::uint64_t* at) {
    using Element = typename Lanes::Element;
    const auto rows =
        Lanes::with_neighbours(Lanes::Word::load_aligned(reinterpret_cast<const Element*>(at)));
    return {reinterpreted<Word>(rows.west), reinterpreted<Word>(rows.centre),
            reinterpreted<Word>(rows.east)};
  }
};

template <bool holds_row>
constexpr ScanFunction whole_row_function() {
  if constexpr (holds_row) {
    return &interpret<WholeRows<WordBatch>>;
  } else {
    return nullptr;
  }
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const Interpreters Exported<Interpreters, kThisIsa>::kKernels = {
    TernaryGate<WordBatch>::kOneInstruction,
    static_cast<Index>(WordBatch::size),
    {&interpret<PlaneRows>, whole_row_function<kRegisterHoldsRow>(),
     &interpret<LaneRows<PlainLanes<std::uint32_t>>>,
     &interpret<LaneRows<PlainLanes<std::uint64_t>>>, &interpret<LaneRows<PairedLanes>>, nullptr}};

}  // namespace thinbench::detail
