#include "regions/variants.hpp"

#include <atomic>
#include <stdexcept>
#include <string>

#include "core/exported.hpp"
#include "core/features.hpp"
#include "core/thread_team.hpp"
#include "regions/euler.hpp"
#include "regions/fill_state.hpp"
#include "regions/run_labeller.hpp"

namespace thinbench::detail {
namespace {

using State = std::unique_ptr<RegionsState>;

class RunState final : public RegionsPlaneState<std::uint64_t> {
 public:
  RunState(const RunEngine& engine, const RegionsSetting& setting)
      : RegionsPlaneState(setting),
        labeller_(engine, setting.task == RegionsTask::holes, setting.isa, setting.width,
                  setting.height, setting.threads) {}

  void compute() override { lists_ = labeller_.label(image()); }
  [[nodiscard]] RegionLists regions() const override { return lists_; }

 private:
  RunLabeller labeller_;
  RegionLists lists_;
};

State make_bitpacked_runs(const RegionsSetting& setting) {
  return std::make_unique<RunState>(kBitpackedRunEngine, setting);
}
State make_simd_runs(const RegionsSetting& setting) {
  return std::make_unique<RunState>(kernels_of<RunEngine>(setting.isa), setting);
}

template <class Kernel>
Kernel euler_kernel(const EulerPair<Kernel>& kernels, RegionsTask task) {
  return task == RegionsTask::euler_eight ? kernels.eight : kernels.four;
}

class EulerState final : public RegionsPlaneState<std::uint64_t> {
 public:
  EulerState(const EulerKernels& kernels, const RegionsSetting& setting)
      : RegionsPlaneState(setting),
        kernel_(euler_kernel(kernels, setting.task)),
        team_(setting.threads) {}

  void compute() override {
    number_ = 0;
    team_.for_ranges(image().height + 1, [&](Index first, Index last) {
      number_.fetch_add(kernel_(image(), first, last), std::memory_order_relaxed);
    });
  }
  [[nodiscard]] std::int64_t number() const override { return number_; }

 private:
  EulerKernel kernel_;
  ThreadTeam team_;
  std::atomic<std::int64_t> number_ = 0;
};

State make_euler_bitpacked(const RegionsSetting& setting) {
  return std::make_unique<EulerState>(kBitpackedEuler, setting);
}
State make_euler_simd(const RegionsSetting& setting) {
  return std::make_unique<EulerState>(kernels_of<EulerKernels>(setting.isa), setting);
}

void add_list_variants(RegionsVariants& list) {
  list.add_with_threads("bitpacked_runs", Isa::baseline, &make_bitpacked_runs, {1});
  for (const Isa isa : all_isas()) {
    list.add_with_threads("simd_runs", isa, &make_simd_runs, {2, kSimdRunsWidth});
  }
}

void add_euler_variants(RegionsVariants& list) {
  list.add_with_threads("bitpacked", Isa::baseline, &make_euler_bitpacked, {1});
  for (const Isa isa : all_isas()) {
    if (isa == Isa::baseline) continue;  // the same as `bitpacked`
    list.add_with_threads("simd_bitpacked", isa, &make_euler_simd, {2});
  }
}

void add_fill_variants(RegionsVariants& list) {
  constexpr Features used = feature("bmi2") | feature("avx512bw") | feature("gfni");
  for (const Isa isa : isas_with(used)) {
    const bool words = isa == Isa::baseline;
    list.add(words ? "bitpacked_flood" : "simd_flood", isa, &make_fill, {words ? 1 : 2});
  }
}

std::vector<RegionsVariant> regions_variants(RegionsTask task) {
  RegionsVariants list;
  if (task == RegionsTask::holes || task == RegionsTask::components) {
    add_list_variants(list);
  } else if (task == RegionsTask::fill || task == RegionsTask::fill_four) {
    add_fill_variants(list);
  } else {
    add_euler_variants(list);
  }
  return list.take();
}

std::vector<RegionsOperation> make_regions_operations() {
  const auto operation = [](RegionsTask task, std::string_view name, std::string_view description) {
    return RegionsOperation{task, name, description, regions_variants(task)};
  };
  return {operation(RegionsTask::holes, "holes",
                    "objects (8-connected) and their holes, with areas and centres"),
          operation(RegionsTask::components, "components",
                    "objects (8-connected) alone, with areas and centres"),
          operation(RegionsTask::fill, "fill_holes",
                    "objects with all that they enclose, interior contours filled"),
          operation(RegionsTask::fill_four, "fill_holes_4",
                    "4-connected objects with all that they enclose"),
          operation(RegionsTask::euler_eight, "euler_number",
                    "8-connected objects minus 4-connected holes"),
          operation(RegionsTask::euler_four, "euler_number_4",
                    "4-connected objects minus 8-connected holes")};
}

}  // namespace

std::span<const RegionsOperation> regions_operations() {
  static const auto& operations = kept(make_regions_operations());
  return operations;
}

RegionsTask task_for(Connectivity objects, RegionsTask eight, RegionsTask four) {
  require_connectivity(static_cast<int>(objects));
  return objects == Connectivity::four ? four : eight;
}

void require_max_area(std::int64_t max_area) {
  if (max_area >= 0) return;
  throw std::invalid_argument("max_area: expected at least 0, got " + std::to_string(max_area));
}

const RegionsOperation& operation_of(RegionsTask task) {
  return operation_with(task, regions_operations(), "task");
}

}  // namespace thinbench::detail
