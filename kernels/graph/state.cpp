#include "graph/state.hpp"

#include <utility>

#include "core/exported.hpp"
#include "graph/pruner.hpp"

namespace thinbench::detail {
namespace {

std::unique_ptr<GraphState> make_simd(const GraphSetting& setting) {
  return std::make_unique<GraphState>(kernels_of<GraphKernels>(setting.isa), setting);
}

}  // namespace

GraphState::GraphState(const GraphKernels& kernels, const GraphSetting& setting)
    : kernels_(kernels),
      conversion_(plane_conversion<std::uint64_t>(setting.isa)),
      team_(setting.threads),
      image_(setting.width, setting.height),
      nodes_(setting.width, setting.height),
      lines_(setting.width, setting.height),
      walker_(setting.width, setting.height) {}

Graph& GraphState::run(const ConstImageView& source) {
  read_rows(team_, conversion_, source, image_.view());
  return walk();
}

Graph& GraphState::walk() {
  team_.for_ranges(image_.view().height, [&](Index first, Index last) {
    kernels_.split(image_.view(), nodes_.view(), lines_.view(), first, last);
  });
  return walker_.walk(image_.view(), nodes_.view(), lines_.view());
}

Graph GraphState::prune(const ConstImageView& source, const Pruning& pruning,
                        const ImageView& destination) {
  const Graph& whole = run(source);
  Pruner(image_.view(), nodes_.view(), walker_.node_at(), whole, pruning).run();
  Graph pruned = std::move(walk());
  conversion_.write(image_.view(), destination);
  return pruned;
}

const GraphOperation& graph_operation() {
  static const auto& operation = never_destroyed<GraphOperation>(
      {{}, "skeleton_graph", "ends, junctions and the lines between them", [] {
         VariantList<GraphState> list;
         for (const Isa isa : isas_of<GraphKernels>()) {
           list.add_with_threads("simd_bitpacked", isa, &make_simd, {1});
         }
         return list.take();
       }()});
  return operation;
}

}  // namespace thinbench::detail
