#include "nets/net_rows.hpp"

#include <array>
#include <vector>

#include "nets/make_model.hpp"
#include "nets/model_passes.hpp"
#include "nets/trained_cluster.hpp"
#include "thinning/rule_rows.hpp"

namespace thinbench::detail {
namespace {

constexpr RuleTable kNaccacheShinghalTable = make_rule_table<NaccacheShinghal, 0>();

template <class T>
constexpr std::span<const Pass<T>> one(const Pass<T>& pass) {
  return {&pass, 1};
}

/// The hand-made circuit for models that have learned the Naccache-Shinghal rule.
template <const PassTable<std::uint64_t>& table>
std::span<const KnownRule> known_passes() {
  static const std::array rules = {
      KnownRule{&kNaccacheShinghalTable, cycle<NaccacheShinghal>(table)}};
  return rules;
}

template <Isa isa>
std::span<const KnownRule> known_kernels() {
  static const std::array rules = {
      KnownRule{&kNaccacheShinghalTable,
                &RowKernels<isa>::kTable.kernels[rule_index<NaccacheShinghal>(AllRules{})]}};
  return rules;
}

template <class AnyPass>
constexpr const AnyPass& pass_of(const NetPasses<AnyPass>& passes, NetKind kind) {
  switch (kind) {
    case NetKind::sigmoid:
      return passes.sigmoid;
    case NetKind::linear:
      return passes.linear;
    case NetKind::cluster:
      break;
  }
  return passes.cluster;
}

using Rows = std::vector<ThinningVariant>;

void add_scalar_net_rows(Rows& rows) {
  using enum Technique;
  using Passes = ScalarModelPasses;
  constexpr Isa base = Isa::baseline;
  for (const bool threaded : {kOneThread, kThreaded}) {
    rows.push_back({lut, base, threaded, kAnyWidth, one(Passes::kLut)});
    rows.push_back({bitpacked, base, threaded, kAnyWidth, one(Passes::kBitpacked),
                    known_passes<ScalarPasses::kBitpacked>()});
  }
  rows.push_back({lut_sliding, base, kOneThread, kAnyWidth, one(Passes::kLutSliding)});
}

template <Isa isa>
void add_arithmetic_rows(Rows& rows, NetKind kind) {
  using enum Technique;
  using Passes = IsaModelPasses<isa>;
  const ChangePass* bits = &pass_of(Passes::kFloatBits, kind);
  rows.push_back({autovec, isa, kOneThread, kAnyWidth, one(pass_of(Passes::kAutovec, kind))});
  rows.push_back(
      {simd_float_bytes, isa, kOneThread, kAnyWidth, one(pass_of(Passes::kFloatBytes, kind))});
  rows.push_back({simd_float_bits, isa, kOneThread, kAnyWidth, bits});
  rows.push_back({simd_float_bits, isa, kThreaded, kAnyWidth, bits});
  if (kind == NetKind::linear) {
    rows.push_back({simd_fixed_point, isa, kOneThread, kAnyWidth, &Passes::kFixedPointBits});
  }
}

template <Isa isa>
void add_circuit_rows(Rows& rows) {
  for (const bool threaded : {kOneThread, kThreaded}) {
    rows.push_back({Technique::simd_bitpacked, isa, threaded, kAnyWidth,
                    one(IsaModelPasses<isa>::kSimdBitpacked),
                    known_passes<IsaPasses<isa>::kSimdBitpacked>()});
  }
}

template <Isa isa>
void add_row_kernel_net_rows(Rows& rows) {
  rows.push_back({Technique::simd_bitpacked_row, isa, kOneThread, kRowKernelWidth,
                  &RowKernels<isa>::kModel, known_kernels<isa>()});
}

Rows all_table_rows() {
  Rows all;
  add_scalar_net_rows(all);
  add_circuit_rows<Isa::baseline>(all);
  add_circuit_rows<Isa::sse42>(all);
  add_circuit_rows<Isa::avx2>(all);
  add_circuit_rows<Isa::avx512>(all);
  add_circuit_rows<Isa::avx512icl>(all);
  add_row_kernel_net_rows<Isa::avx512>(all);
  add_row_kernel_net_rows<Isa::avx512icl>(all);
  return all;
}

Rows all_rows(NetKind kind) {
  Rows all = all_table_rows();
  add_arithmetic_rows<Isa::baseline>(all, kind);
  add_arithmetic_rows<Isa::sse42>(all, kind);
  add_arithmetic_rows<Isa::avx2>(all, kind);
  add_arithmetic_rows<Isa::avx512>(all, kind);
  add_arithmetic_rows<Isa::avx512icl>(all, kind);
  return all;
}

}  // namespace

std::span<const ThinningVariant> net_rows(NetKind kind) {
  static const std::array rows = {all_rows(NetKind::sigmoid), all_rows(NetKind::linear),
                                  all_rows(NetKind::cluster)};
  return rows.at(static_cast<std::size_t>(kind));
}

std::span<const ThinningVariant> net_table_rows() {
  static const Rows rows = all_table_rows();
  return rows;
}

const RuleModel& paper_sigmoid_model() {
  static const RuleModel model = two_layer_model(kPaperTwoLayer, Activation::sigmoid);
  return model;
}

const RuleModel& rounded_sigmoid_model() {
  static const RuleModel model = two_layer_model(kRoundedTwoLayer, Activation::sigmoid);
  return model;
}

const RuleModel& paper_linear_model() {
  static const RuleModel model = two_layer_model(kPaperTwoLayer, Activation::linear);
  return model;
}

const RuleModel& trained_cluster_model() {
  static const RuleModel model = cluster_model(kTrainedCluster);
  return model;
}

}  // namespace thinbench::detail
