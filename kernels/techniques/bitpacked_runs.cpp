// Lists of regions from the runs of one row after the other.
//
// Cost: 4 instructions per word without a boundary. Each run, of either colour, takes 6 to find,
// about 10 to compare with the row above, and 12, with 6 loads and stores, to sum in closed form.
// An image of parts has about one run per 30 pixels, so this should be over 10 times as fast as
// visiting single pixels.
#include "techniques/regions.hpp"

namespace thinbench::detail {
namespace {

template <bool with_background>
Index label_rows(const ConstBitPlaneView& image, Index first, Index last, RunLabelling& labelling) {
  return label_rows_singly<with_background>(image, first, last, labelling);
}

constexpr RunEngine kEngine = {&label_rows<true>, &label_rows<false>};

}  // namespace

std::unique_ptr<ListState> make_bitpacked_runs(const ListSetting& setting) {
  return std::make_unique<ListState>(kEngine, setting);
}

}  // namespace thinbench::detail
