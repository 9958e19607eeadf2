#include "regions/variants.hpp"

#include <atomic>
#include <cstring>

#include "core/exported.hpp"
#include "core/thread_team.hpp"
#include "regions/euler.hpp"
#include "regions/labelled_runs.hpp"
#include "regions/run_labeller.hpp"

namespace thinbench::detail {
namespace {

using State = std::unique_ptr<RegionsState>;

class RunState final : public RegionsPlaneState<std::uint64_t> {
 public:
  RunState(const RunEngine& engine, const RegionsSetting& setting)
      : RegionsPlaneState(setting),
        with_holes_(setting.task == RegionsTask::holes),
        labeller_(with_holes_ ? engine.holes : engine.components, setting.width, setting.height,
                  setting.threads) {}

  void compute() override {
    lists_ = labeller_.label(image());
    if (!with_holes_) lists_.holes = {};
  }
  [[nodiscard]] RegionLists regions() const override { return lists_; }

 private:
  bool with_holes_;
  RunLabeller labeller_;
  RegionLists lists_;
};

State make_bitpacked_runs(const RegionsSetting& setting) {
  return std::make_unique<RunState>(kBitpackedRunEngine, setting);
}
State make_simd_runs(const RegionsSetting& setting) {
  return std::make_unique<RunState>(kernels_of<RunEngine>(setting.isa), setting);
}

/// Labels all runs, then sets those of holes.
///
/// Cost: that of labelled_runs.hpp, a load and a store per word to copy the image, and a look-up
/// per background run, plus its words if it belongs to a hole. Rejected without measurement:
/// docs/experiments.md#filling-with-lanes-or-threads.
class FillState final : public RegionsPlaneState<std::uint64_t> {
 public:
  explicit FillState(const RegionsSetting& setting)
      : RegionsPlaneState(setting),
        result_(setting.width, setting.height),
        runs_(setting.width, setting.height) {}

  void compute() override {
    if (image().height == 0) return;
    runs_.label(image());
    for (Index y = 0; y < image().height; ++y) fill_row(y);
  }
  void store(const ImageView& destination) const override {
    conversion().write(result_.view(), destination);
  }

 private:
  void fill_row(Index y) {
    std::uint64_t* const target = result_.view().row(y);
    const auto bytes = static_cast<std::size_t>(image().row_elements) * sizeof(std::uint64_t);
    std::memcpy(target, image().row(y), bytes);
    const RunRow runs = runs_.row(y);
    const Label* const roots = runs_.roots(0);
    for (Index i = 2; i < runs.count; i += 2) {
      if (roots[runs.labels[i]] != 0) set_run(target, runs, i);
    }
  }

  BitPlane result_;
  LabelledRuns runs_;
};

State make_bitpacked_fill(const RegionsSetting& setting) {
  return std::make_unique<FillState>(setting);
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

std::vector<RegionsVariant> regions_variants(RegionsTask task) {
  RegionsVariants list;
  if (task == RegionsTask::holes || task == RegionsTask::components) {
    add_list_variants(list);
  } else if (task == RegionsTask::fill) {
    list.add("bitpacked_runs", Isa::baseline, &make_bitpacked_fill, {1});
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

const RegionsOperation& operation_of(RegionsTask task) {
  return operation_with(task, regions_operations(), "task");
}

}  // namespace thinbench::detail
