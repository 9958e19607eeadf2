#include "edges/variant.hpp"

namespace thinbench::detail {
namespace {

constexpr bool kThreads = true;
constexpr bool kNoThreads = false;

class Rows {
 public:
  explicit Rows(EdgeOperator op) : op_(op) {}

  template <class Kernel>
  void add(Technique technique, Isa isa, const EdgeTable<Kernel>& table, bool with_threads) {
    const Kernel kernel = table[op_];
    if (kernel == nullptr) return;
    rows_.push_back({{technique, isa, false}, kernel});
    if (with_threads) rows_.push_back({{technique, isa, true}, kernel});
  }

  template <Isa isa>
  void add_level() {
    using Level = IsaEdges<isa>;
    const bool has_8_bits = Level::kSimd8Bit[op_] != nullptr;
    add(Technique::autovec, isa, Level::kAutovec, kNoThreads);
    add(Technique::simd_16bit, isa, Level::kSimd16Bit, !has_8_bits);
    add(Technique::simd_8bit, isa, Level::kSimd8Bit, kThreads);
    add(Technique::simd_to_bits, isa, Level::kSimdToBits, kThreads);
  }

  [[nodiscard]] std::vector<EdgeVariant> take() { return std::move(rows_); }

 private:
  EdgeOperator op_;
  std::vector<EdgeVariant> rows_;
};

}  // namespace

std::vector<EdgeVariant> edge_rows(EdgeOperator op) {
  Rows rows(op);
  rows.add(Technique::lut, Isa::baseline, ScalarEdges::kLut, kThreads);
  rows.add_level<Isa::baseline>();
  rows.add_level<Isa::sse42>();
  rows.add_level<Isa::avx2>();
  rows.add_level<Isa::avx512>();
  return rows.take();
}

}  // namespace thinbench::detail
