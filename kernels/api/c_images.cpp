// The C interface of binarisation, edges, distances and the library itself.
#include "api/c_arguments.hpp"
#include "thinbench/binarise.hpp"
#include "thinbench/distance.hpp"
#include "thinbench/edges.hpp"
#include "thinbench/graph_labels.hpp"
#include "thinbench/memory.hpp"
#include "thinbench/midpoint_scan.hpp"
#include "thinbench/version.hpp"

namespace {

using namespace thinbench;
using namespace thinbench::detail;

Binarisation binarisation_of(const thinbench_binarisation* given) {
  if (given == nullptr) return {};
  const auto all = known(given, thinbench_binarisation THINBENCH_BINARISATION_INIT, "request");
  Binarisation request;
  if (all.foreground != nullptr) {
    request.foreground = enumerator<Foreground>("foreground", all.foreground, kForegroundNames);
  }
  if (all.threshold == THINBENCH_LOCAL) {
    request.local = LocalThreshold{all.window, {}};
    if (all.offset != -1) request.local->offset = all.offset;
    return request;
  }
  const auto require_local = [](const char* name, std::int32_t value, std::int32_t by_default) {
    require(value == by_default, [&] {
      return name + (": expected THINBENCH_LOCAL beside it, got " + std::to_string(value));
    });
  };
  require_local("window", all.window, 0);
  require_local("offset", all.offset, -1);
  if (all.threshold != THINBENCH_OTSU) request.threshold = all.threshold;
  return request;
}

ConstColourView colours_of(const thinbench_colours* colours) {
  const auto from = known(colours, thinbench_colours THINBENCH_COLOURS_INIT, "colours");
  return {from.data, from.width, from.height, from.stride, from.samples};
}

ColourView<std::uint16_t> colours_of(const thinbench_colours16* colours) {
  const auto from = known(colours, thinbench_colours16 THINBENCH_COLOURS16_INIT, "colours");
  return {from.data, from.width, from.height, from.stride, from.samples};
}

View<std::uint16_t> levels_of(const thinbench_image16* image, const char* name) {
  const auto from = known(image, thinbench_image16 THINBENCH_IMAGE16_INIT, name);
  return {from.data, from.width, from.height, from.stride};
}

/// Calls binarise(destination) and reports what it chose.
template <class Binarise>
thinbench_status binarise_into(const thinbench_image* destination, const char** foreground,
                               std::int32_t* threshold, const Binarise& binarise) {
  return guarded([&] {
    Binarised found;
    write_to(destination, [&](const ImageView& to) { found = binarise(to); });
    report(foreground_name(found.foreground).data(), foreground);
    report(found.threshold, threshold);
  });
}

static_assert(THINBENCH_ROWS == 1 << static_cast<int>(Direction::rows));
static_assert(THINBENCH_COLUMNS == 1 << static_cast<int>(Direction::columns));
static_assert(THINBENCH_DIAGONALS == 1 << static_cast<int>(Direction::diagonals));
static_assert(THINBENCH_ANTIDIAGONALS == 1 << static_cast<int>(Direction::antidiagonals));
static_assert(THINBENCH_ALL_DIRECTIONS == Directions{}.bits);

Directions directions_of(std::int32_t bits) {
  require(0 <= bits && bits <= THINBENCH_ALL_DIRECTIONS,
          [&] { return "directions: expected bits in [0, 15], got " + std::to_string(bits); });
  return {static_cast<std::uint8_t>(bits)};
}

}  // namespace

const char* thinbench_version() {
  return kVersion.data();
}

void thinbench_release_memory() {
  release_memory();
}

const char* thinbench_isa_name(size_t index) {
  return name_at(all_isas(), index);
}

int32_t thinbench_isa_available(const char* isa) {
  bool available = false;
  const thinbench_status status = guarded([&] { available = isa_available(isa_of(isa)); });
  if (status != THINBENCH_OK) return -1;
  return available ? 1 : 0;
}

thinbench_status thinbench_binarise(const thinbench_image* grey, const thinbench_image* destination,
                                    const thinbench_binarisation* request,
                                    const thinbench_execution* execution, const char** foreground,
                                    int32_t* threshold) {
  return binarise_into(destination, foreground, threshold, [&](const ImageView& to) {
    return binarise(image_of(grey, "grey"), to, binarisation_of(request), execution_of(execution));
  });
}

thinbench_status thinbench_binarise16(const thinbench_image16* grey,
                                      const thinbench_image* destination,
                                      const thinbench_binarisation* request,
                                      const thinbench_execution* execution, const char** foreground,
                                      int32_t* threshold) {
  return binarise_into(destination, foreground, threshold, [&](const ImageView& to) {
    return binarise16(levels_of(grey, "grey"), to, binarisation_of(request),
                      execution_of(execution));
  });
}

thinbench_status thinbench_select_channel(const thinbench_colours* colours,
                                          const thinbench_image* destination, const char* channel,
                                          const thinbench_execution* execution,
                                          const char** chosen) {
  return guarded([&] {
    const auto wanted = enumerator<Channel>("channel", channel, kChannelNames);
    const Channel found = select_channel(colours_of(colours), written(destination).view, wanted,
                                         execution_of(execution));
    report(channel_name(found).data(), chosen);
  });
}

thinbench_status thinbench_select_channel16(const thinbench_colours16* colours,
                                            const thinbench_image16* destination,
                                            const char* channel,
                                            const thinbench_execution* execution,
                                            const char** chosen) {
  return guarded([&] {
    const auto wanted = enumerator<Channel>("channel", channel, kChannelNames);
    const Channel found =
        select_channel16(colours_of(colours), levels_of(destination, "destination"), wanted,
                         execution_of(execution));
    report(channel_name(found).data(), chosen);
  });
}

thinbench_status thinbench_midpoint_scan(const thinbench_image* source,
                                         const thinbench_image* destination, int32_t directions,
                                         const char* border, const thinbench_execution* execution) {
  return guarded([&] {
    const Border outside =
        border == nullptr ? Border::background : enumerator<Border>("border", border, kBorderNames);
    write_to(destination, [&](const ImageView& to) {
      midpoint_scan(image_of(source), to, directions_of(directions), outside,
                    execution_of(execution));
    });
  });
}

thinbench_status thinbench_detect_edges(const char* edge_operator, const thinbench_image* source,
                                        const thinbench_image* destination,
                                        int32_t gradient_threshold, int32_t brightness_threshold,
                                        const thinbench_execution* execution) {
  return guarded([&] {
    const EdgeOperator op = named("edge operator", edge_operator,
                                  edge_operator_from_name(view_of(edge_operator)), kEdgeOperators);
    const EdgeThresholds thresholds = {gradient_threshold, brightness_threshold};
    write_to(destination, [&](const ImageView& to) {
      detect_edges(op, image_of(source), to, thresholds, execution_of(execution));
    });
  });
}

const char* thinbench_edge_operator_name(size_t index) {
  return name_at(kEdgeOperators, index);
}

thinbench_status thinbench_squared_distances(const thinbench_image* source,
                                             const thinbench_labels* distances,
                                             const thinbench_execution* execution) {
  return guarded([&] {
    squared_distances(image_of(source), labels_of(distances, "distances"), execution_of(execution));
  });
}

thinbench_status thinbench_distances(const thinbench_image* source,
                                     const thinbench_reals* distances,
                                     const thinbench_spacing* spacing,
                                     const thinbench_execution* execution) {
  return guarded([&] {
    thinbench::distances(image_of(source), reals_of(distances, "distances"), spacing_of(spacing),
                         execution_of(execution));
  });
}

thinbench_status thinbench_distances_of_labels(const thinbench_labels* labels,
                                               const thinbench_reals* distances,
                                               const thinbench_spacing* spacing,
                                               const thinbench_execution* execution) {
  return guarded([&] {
    distances_of_labels(labels_of(labels, "labels"), reals_of(distances, "distances"),
                        spacing_of(spacing), execution_of(execution));
  });
}
