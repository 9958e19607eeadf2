// The C interface of channels and thresholds.
#include "api/c_arguments.hpp"
#include "thinbench.h"
#include "thinbench/binarise.hpp"

namespace {

using namespace thinbench;
using namespace thinbench::detail;

Binarisation binarisation_of(const thinbench_binarisation* given) {
  constexpr std::int32_t otsu = -1, local = -2;
  if (given == nullptr) return {};
  const thinbench_binarisation defaults = THINBENCH_BINARISATION_INIT;
  const auto all = versioned(given, &thinbench_binarisation::reserved, defaults, "request",
                             "THINBENCH_BINARISATION_INIT");
  require_reserved("request", all.reserved);
  Binarisation request;
  if (all.foreground != nullptr) {
    request.foreground =
        static_cast<Foreground>(index_of("foreground", all.foreground, kForegroundNames));
  }
  if (all.threshold == local) request.local = LocalThreshold{all.window, all.offset};
  if (all.threshold != local && all.threshold != otsu) request.threshold = all.threshold;
  return request;
}

}  // namespace

thinbench_status thinbench_binarise(const thinbench_stack* grey,
                                    const thinbench_output* destination,
                                    const thinbench_binarisation* request, const char** foreground,
                                    int32_t* threshold) {
  return guarded([&] {
    const ConstImageView from = image_of(grey);
    const StackView to = destination_of(destination, source_of(grey));
    const Binarised found = binarise(from, to.image(0), binarisation_of(request));
    set_foreground(destination, to);
    if (foreground != nullptr) *foreground = foreground_name(found.foreground).data();
    if (threshold != nullptr) *threshold = found.threshold;
  });
}

thinbench_status thinbench_select_channel(const uint8_t* colours, ptrdiff_t colours_stride,
                                          uint8_t* levels, ptrdiff_t levels_stride,
                                          ptrdiff_t height, ptrdiff_t width, int32_t samples,
                                          const char* channel, const char** chosen) {
  return guarded([&] {
    const Channel found = select_channel(
        {colours, width, height, colours_stride, samples}, {levels, width, height, levels_stride},
        static_cast<Channel>(index_of("channel", channel, kChannelNames)));
    if (chosen != nullptr) *chosen = channel_name(found).data();
  });
}
