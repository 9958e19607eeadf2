#include "edges/state.hpp"

#include "core/exported.hpp"

namespace thinbench::detail {
namespace {

using State = std::unique_ptr<EdgeState>;

template <class Kernel, class Target>
void run_bands(const ThreadTeam& team, Kernel kernel, const EdgeThresholds& thresholds,
               const ConstImageView& source, const Target& target) {
  if (source.width == 0) return;
  team.for_ranges(source.height, [&](Index first, Index last) {
    kernel(thresholds, source, target, EdgeRows{first, last});
  });
}

template <class Kernels, EdgeTable<EdgesToBytes> Kernels::*table>
State make(const EdgeSetting& setting) {
  return std::make_unique<EdgeState>((kernels_of<Kernels>(setting.isa).*table)[setting.op],
                                     setting);
}

void require_threshold(const char* name, int value) {
  require(0 <= value && value <= kMaxThreshold, [&] {
    return std::string(name) + ": expected an integer in [0, 255], got " + std::to_string(value);
  });
}

}  // namespace

EdgeState::EdgeState(EdgesToBytes kernel, const EdgeSetting& setting)
    : kernel_(kernel), thresholds_(setting.thresholds), team_(setting.threads) {}

void EdgeState::run(const ConstImageView& source, const ImageView& destination) {
  run_bands(team_, kernel_, thresholds_, source, destination);
}

PackedEdges::PackedEdges(const EdgeSetting& setting)
    : kernel_(kernels_of<EdgeKernels>(setting.isa).to_bits[setting.op]),
      thresholds_(setting.thresholds),
      team_(setting.threads),
      bits_(setting.width, setting.height) {}

ConstBitPlaneView PackedEdges::run(const ConstImageView& source) {
  run_bands(team_, kernel_, thresholds_, source, bits_.view());
  return bits_.view();
}

void require_thresholds(const EdgeThresholds& thresholds) {
  require_threshold("gradient_threshold", thresholds.gradient_threshold);
  require_threshold("brightness_threshold", thresholds.brightness_threshold);
}

namespace {

std::vector<EdgeVariant> edge_variants(EdgeOperator op) {
  constexpr auto make_16bit = &make<EdgeKernels, &EdgeKernels::simd_16bit>;
  EdgeVariants list;
  for (const Isa isa : isas_of<EdgeKernels>()) {
    list.add("simd_16bit", isa, make_16bit, {1});
    if (kernels_of<EdgeKernels>(isa).simd_8bit[op] != nullptr) {
      list.add_with_threads("simd_8bit", isa, &make<EdgeKernels, &EdgeKernels::simd_8bit>, {2});
    } else {
      list.add("simd_16bit", isa, make_16bit, {1}, true);
    }
  }
  return list.take();
}

}  // namespace

std::span<const EdgeOperation> edge_operations() {
  static const auto& all = never_destroyed([] {
    std::vector<EdgeOperation> operations;
    operations.reserve(std::size(kEdgeOperators));
    for (const EdgeOperatorInfo& info : kEdgeOperators) {
      operations.push_back({info.op, info.operation, info.description, edge_variants(info.op)});
    }
    return operations;
  }());
  return all;
}

const EdgeOperation& operation_of(EdgeOperator op) {
  return operation_with(op, edge_operations(), "operator");
}

}  // namespace thinbench::detail
