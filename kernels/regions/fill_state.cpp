// Holes filled from their runs: all runs are labelled and kept, then those of holes are set.
//
// Cost: that of labelled_runs.hpp, and for each light run a look-up and, in a hole, the words it
// covers. The image is copied first: a load and a store a word.
//
// There is no variant with lanes or threads: simd_runs gains where it sums up matching runs without
// a label for each, while here every run keeps its label; and bands of rows labelled apart would
// need their kept labels renumbered after the seams are joined, another pass over all runs.
#include <cstring>

#include "image/packing.hpp"
#include "image/planes.hpp"
#include "regions/labelled_runs.hpp"
#include "regions/variants.hpp"

namespace thinbench::detail {
namespace {

class FillState final : public RegionsState {
 public:
  explicit FillState(const RegionsSetting& setting)
      : conversion_(plane_conversion<std::uint64_t>(setting.isa)),
        source_(setting.width, setting.height),
        result_(setting.width, setting.height),
        runs_(setting.width, setting.height) {}

  void load(const ConstImageView& source) override { conversion_.read(source, source_.view()); }
  void store(const ImageView& destination) const override {
    conversion_.write(result_.view(), destination);
  }
  void compute() override {
    const ConstBitPlaneView image = source_.view();
    if (image.height == 0) return;
    runs_.label(image);
    for (Index y = 0; y < image.height; ++y) {
      const auto bytes = static_cast<std::size_t>(image.row_elements) * sizeof(std::uint64_t);
      std::memcpy(result_.view().row(y), image.row(y), bytes);
      fill_row(y);
    }
  }

 private:
  void fill_row(Index y) {
    const RunRow runs = runs_.row(y);
    const Label* const roots = runs_.roots(0);
    for (Index i = 2; i < runs.count; i += 2) {
      if (roots[runs.labels[i]] != 0) set_run(result_.view().row(y), runs, i);
    }
  }

  const PlaneConversion<std::uint64_t>& conversion_;
  BitPlane source_;
  BitPlane result_;
  LabelledRuns runs_;
};

}  // namespace

std::unique_ptr<RegionsState> make_bitpacked_fill(const RegionsSetting& setting) {
  return std::make_unique<FillState>(setting);
}

}  // namespace thinbench::detail
