// Filling holes from lists of labelled runs.
//
// Cost: that of labelled_runs.hpp, a load and a store per word to copy the image, and a look-up per
// background run, plus its words if it belongs to a hole.
#include <cstring>

#include "regions/labelled_runs.hpp"
#include "techniques/regions.hpp"

namespace thinbench::detail {
namespace {

class RunFillState final : public RegionsPlaneState<std::uint64_t> {
 public:
  explicit RunFillState(const RegionsSetting& setting)
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

}  // namespace

std::unique_ptr<RegionsState> make_run_fill(const RegionsSetting& setting) {
  return std::make_unique<RunFillState>(setting);
}

}  // namespace thinbench::detail
