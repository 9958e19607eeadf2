#include "graph/state.hpp"

#include "dispatch/exported.hpp"

namespace thinbench::detail {
namespace {

std::unique_ptr<GraphState> make_bitpacked(const GraphSetting& setting) {
  return std::make_unique<GraphState>(kBitpackedGraph, setting);
}

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

void GraphState::load(const ConstImageView& source) {
  conversion_.read(source, image_.view());
}

const Graph& GraphState::compute() {
  team_.for_ranges(image_.view().height, [&](Index first, Index last) {
    kernels_.split(image_.view(), nodes_.view(), lines_.view(), first, last);
  });
  return walker_.walk(image_.view(), nodes_.view(), lines_.view());
}

std::vector<GraphVariant> graph_variants() {
  GraphVariants list;
  list.add_with_threads(Technique::bitpacked, Isa::baseline, &make_bitpacked, {0});
  for (const Isa isa : all_isas()) {
    list.add_with_threads(Technique::simd_bitpacked, isa, &make_simd, {1});
  }
  return list.take();
}

}  // namespace thinbench::detail
