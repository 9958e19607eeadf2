// The C interface of channels and thresholds.
#include <algorithm>

#include "api/c_arguments.hpp"
#include "thinbench.h"
#include "thinbench/binarise.hpp"

namespace {

using namespace thinbench;
using namespace thinbench::detail;

/// The value whose name, as options have it, this is.
template <class Value, std::size_t N>
Value value_named(const char* what, const char* name,
                  const std::array<std::string_view, N>& known) {
  const auto found = std::find(known.begin(), known.end(), view_of(name));
  const auto value = found == known.end()
                         ? std::nullopt
                         : std::optional(static_cast<Value>(found - known.begin()));
  return named(what, name, value, [&known] {
    std::string names;
    for (const std::string_view one : known) names.append(names.empty() ? "" : ", ").append(one);
    return names;
  });
}

Binarisation binarisation_of(const thinbench_binarisation* given) {
  constexpr std::int32_t otsu = -1, local = -2;
  if (given == nullptr) return {};
  const thinbench_binarisation all =
      versioned(given, sizeof(*given), thinbench_binarisation THINBENCH_BINARISATION_INIT,
                "request", "THINBENCH_BINARISATION_INIT");
  Binarisation request;
  if (all.foreground != nullptr) {
    request.foreground = value_named<Foreground>("foreground", all.foreground, kForegroundNames);
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

thinbench_status thinbench_select_channel(const uint8_t* colours, ptrdiff_t height, ptrdiff_t width,
                                          ptrdiff_t stride, int32_t samples, const char* channel,
                                          uint8_t* levels, ptrdiff_t levels_stride,
                                          const char** chosen) {
  return guarded([&] {
    const Channel found = select_channel({colours, width, height, stride, samples},
                                         {levels, width, height, levels_stride},
                                         value_named<Channel>("channel", channel, kChannelNames));
    if (chosen != nullptr) *chosen = channel_name(found).data();
  });
}
