#include "regions/variants.hpp"

namespace thinbench::detail {
namespace {

using enum Technique;

std::vector<RegionsVariant> list_variants() {
  RegionsVariants list;
  list.add(union_find, Isa::baseline, &make_union_find, {0});
  list.add_with_threads(bitpacked_runs, Isa::baseline, &make_bitpacked_runs, {1});
  for (const Isa isa : kAllIsas) {
    list.add_with_threads(simd_runs, isa, &make_simd_runs, {2, kSimdRunsWidth});
  }
  return list.take();
}

std::vector<RegionsVariant> euler_variants() {
  RegionsVariants list;
  list.add(lut, Isa::baseline, &make_euler_lut, {0});
  list.add_with_threads(bitpacked, Isa::baseline, &make_euler_bitpacked, {1});
  for (const Isa isa : kAllIsas) {
    if (isa == Isa::baseline) continue;  // counts words as `bitpacked` does
    list.add_with_threads(simd_bitpacked, isa, &make_euler_simd, {2});
  }
  return list.take();
}

std::vector<RegionsVariant> fill_variants() {
  RegionsVariants list;
  list.add(union_find, Isa::baseline, &make_union_find_fill, {0});
  list.add(bitpacked_runs, Isa::baseline, &make_bitpacked_fill, {1});
  return list.take();
}

}  // namespace

std::vector<RegionsVariant> regions_variants(RegionsTask task) {
  switch (task) {
    case RegionsTask::holes:
    case RegionsTask::components:
      return list_variants();
    case RegionsTask::fill:
      return fill_variants();
    case RegionsTask::euler_eight:
    case RegionsTask::euler_four:
      break;
  }
  return euler_variants();
}

}  // namespace thinbench::detail
