#include "nets/net_rows.hpp"

#include <array>
#include <vector>

#include "nets/make_model.hpp"
#include "nets/model_passes.hpp"
#include "nets/trained_cluster.hpp"
#include "thinning/rule_rows.hpp"

namespace thinbench {
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

template <class T>
constexpr std::span<const Pass<T>> pass_of(const NetPasses<T>& passes, NetKind kind) {
  switch (kind) {
    case NetKind::kSigmoid:
      return one(passes.sigmoid);
    case NetKind::kLinear:
      return one(passes.linear);
    case NetKind::kCluster:
      return one(passes.cluster);
  }
  return {};
}

using Rows = std::vector<ThinningVariant>;

void add_scalar_net_rows(Rows& rows) {
  using enum Technique;
  using Passes = ScalarModelPasses;
  constexpr Isa base = Isa::kBaseline;
  for (const bool threaded : {kOneThread, kThreaded}) {
    rows.push_back({kLut, base, threaded, kAnyWidth, one(Passes::kLut)});
    rows.push_back({kBitpacked, base, threaded, kAnyWidth, one(Passes::kBitpacked),
                    known_passes<ScalarPasses::kBitpacked>()});
  }
  rows.push_back({kLutSliding, base, kOneThread, kAnyWidth, one(Passes::kLutSliding)});
}

template <Isa isa>
void add_isa_net_rows(Rows& rows, NetKind kind) {
  using enum Technique;
  using Passes = IsaModelPasses<isa>;
  const auto bits = pass_of(Passes::kFloatBits, kind);
  rows.push_back({kAutovec, isa, kOneThread, kAnyWidth, pass_of(Passes::kAutovec, kind)});
  rows.push_back({kSimdFloatBytes, isa, kOneThread, kAnyWidth, pass_of(Passes::kFloatBytes, kind)});
  for (const bool threaded : {kOneThread, kThreaded}) {
    rows.push_back({kSimdFloatBits, isa, threaded, kAnyWidth, bits});
    rows.push_back({kSimdBitpacked, isa, threaded, kAnyWidth, one(Passes::kSimdBitpacked),
                    known_passes<IsaPasses<isa>::kSimdBitpacked>()});
  }
  if (kind == NetKind::kLinear) {
    rows.push_back({kSimdFixedPoint, isa, kOneThread, kAnyWidth, one(Passes::kFixedPointBits)});
  }
}

template <Isa isa>
void add_row_kernel_net_rows(Rows& rows) {
  rows.push_back({Technique::kSimdBitpackedRow, isa, kOneThread, kRowKernelWidth,
                  &RowKernels<isa>::kModel, known_kernels<isa>()});
}

Rows all_rows(NetKind kind) {
  Rows all;
  add_scalar_net_rows(all);
  add_isa_net_rows<Isa::kBaseline>(all, kind);
  add_isa_net_rows<Isa::kSse42>(all, kind);
  add_isa_net_rows<Isa::kAvx2>(all, kind);
  add_isa_net_rows<Isa::kAvx512>(all, kind);
  add_isa_net_rows<Isa::kAvx512Icl>(all, kind);
  add_row_kernel_net_rows<Isa::kAvx512>(all);
  add_row_kernel_net_rows<Isa::kAvx512Icl>(all);
  return all;
}

}  // namespace

std::span<const ThinningVariant> net_rows(NetKind kind) {
  static const std::array rows = {all_rows(NetKind::kSigmoid), all_rows(NetKind::kLinear),
                                  all_rows(NetKind::kCluster)};
  return rows.at(static_cast<std::size_t>(kind));
}

const RuleModel& paper_sigmoid_model() {
  static const RuleModel model = two_layer_model(kPaperTwoLayer, Activation::kSigmoid);
  return model;
}

const RuleModel& paper_linear_model() {
  static const RuleModel model = two_layer_model(kPaperTwoLayer, Activation::kLinear);
  return model;
}

const RuleModel& trained_cluster_model() {
  static const RuleModel model = cluster_model(kTrainedCluster);
  return model;
}

}  // namespace thinbench
