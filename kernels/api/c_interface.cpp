// The C interface of edges, distances and regions.
#include <cstddef>
#include <cstring>
#include <string>

#include "api/c_arguments.hpp"
#include "core/checks.hpp"
#include "thinbench.h"
#include "thinbench/distance.hpp"
#include "thinbench/edges.hpp"
#include "thinbench/localise.hpp"
#include "thinbench/memory.hpp"
#include "thinbench/regions.hpp"
#include "thinbench/version.hpp"

static_assert(sizeof(thinbench_region) == sizeof(thinbench::Region));
static_assert(offsetof(thinbench_region, enclosing_object) ==
              offsetof(thinbench::Region, enclosing_object));

struct thinbench_regions : thinbench::Regions {};

namespace {

using namespace thinbench;
using namespace thinbench::detail;

/// Calls `body(source, destination)` for every image, after a check of the whole stack. Without
/// pixels, where there may be no memory, it does so once for an image without rows, so that `body`
/// checks the other arguments.
template <class Body>
void for_images(const thinbench_stack* stack, const thinbench_output* output, const Body& body) {
  const ConstStackView source = source_of(stack);
  const StackView destination = destination_of(output, source);
  check_views(source, destination, InPlace::allowed);
  if (source.count == 0 || source.width == 0 || source.height == 0) {
    body({nullptr, source.width, 0}, {nullptr, source.width, 0});
    return;
  }
  for (Index i = 0; i < source.count; ++i) body(source.image(i), destination.image(i));
  set_foreground(output, destination);
}

Connectivity connectivity_of(std::int32_t number) {
  detail::require_connectivity(number);
  return static_cast<Connectivity>(number);
}

LabelOrder order_of(const char* name) {
  constexpr std::string_view names[] = {"pixels", "opencv"};
  if (name == nullptr) return LabelOrder::pixels;
  return static_cast<LabelOrder>(index_of("order", name, names));
}

/// Hands over a result in a handle.
void hand_over(Regions found, thinbench_regions** handle) {
  *handle = new thinbench_regions{{std::move(found)}};
}

}  // namespace

void thinbench_release_memory() {
  release_memory();
}

const char* thinbench_version() {
  return kVersion.data();
}

const char* thinbench_last_error() {
  return last_error();
}

thinbench_status thinbench_edges(const char* edge_operator, const thinbench_stack* source,
                                 const thinbench_output* destination, int32_t gradient_threshold,
                                 int32_t brightness_threshold,
                                 const thinbench_execution* execution) {
  return guarded([&] {
    const EdgeOperator op = named("edge operator", edge_operator,
                                  edge_operator_from_name(view_of(edge_operator)), kEdgeOperators);
    const EdgeThresholds thresholds = {gradient_threshold, brightness_threshold};
    const Execution given = execution_of(execution);
    for_images(source, destination, [&](const ConstImageView& from, const ImageView& to) {
      detect_edges(op, from, to, thresholds, given);
    });
  });
}

thinbench_status thinbench_squared_distances(const thinbench_stack* source, int32_t* distances,
                                             ptrdiff_t stride,
                                             const thinbench_execution* execution) {
  return guarded([&] {
    const ConstImageView image = image_of(source);
    squared_distances(image, {distances, image.width, image.height, stride},
                      execution_of(execution));
  });
}

thinbench_status thinbench_distances(const thinbench_stack* source, double* distances,
                                     ptrdiff_t stride, const thinbench_spacing* spacing,
                                     const thinbench_execution* execution) {
  return guarded([&] {
    const ConstImageView image = image_of(source);
    thinbench::distances(image, {distances, image.width, image.height, stride}, spacing_of(spacing),
                         execution_of(execution));
  });
}

thinbench_status thinbench_find_regions(const thinbench_stack* source, int32_t* labels,
                                        ptrdiff_t labels_stride,
                                        const thinbench_execution* execution,
                                        thinbench_regions** regions) {
  return guarded([&] {
    require_pointer(regions, "regions");
    *regions = nullptr;
    const ConstImageView image = image_of(source);
    const Execution given = execution_of(execution);
    if (labels == nullptr) {
      hand_over(find_regions(image, given), regions);
      return;
    }
    hand_over(label_regions(image, {labels, image.width, image.height, labels_stride}, given),
              regions);
  });
}

thinbench_status thinbench_label_image(const thinbench_stack* source, int32_t* labels,
                                       ptrdiff_t labels_stride, int32_t connectivity,
                                       const char* order, const thinbench_execution* execution,
                                       uint32_t* objects) {
  return guarded([&] {
    require_pointer(objects, "objects");
    const ConstImageView image = image_of(source);
    *objects = label_image(image, {labels, image.width, image.height, labels_stride},
                           connectivity_of(connectivity), order_of(order), execution_of(execution));
  });
}

thinbench_status thinbench_label_components(const thinbench_stack* source, int32_t* labels,
                                            ptrdiff_t labels_stride, int32_t connectivity,
                                            const char* order, const thinbench_execution* execution,
                                            thinbench_regions** regions) {
  return guarded([&] {
    require_pointer(regions, "regions");
    *regions = nullptr;
    const ConstImageView image = image_of(source);
    const LabelView view = {labels, image.width, image.height, labels_stride};
    hand_over({label_objects(image, view, connectivity_of(connectivity), order_of(order),
                                execution_of(execution)),
               {}},
              regions);
  });
}

thinbench_status thinbench_label_values(const int32_t* values, ptrdiff_t values_stride,
                                        int32_t* labels, ptrdiff_t labels_stride, ptrdiff_t height,
                                        ptrdiff_t width, int32_t connectivity, int32_t background,
                                        uint32_t* components) {
  return guarded([&] {
    require_pointer(components, "components");
    *components =
        label_values({values, width, height, values_stride}, {labels, width, height, labels_stride},
                     connectivity_of(connectivity), background);
  });
}

thinbench_status thinbench_localise(const thinbench_stack* grey, int32_t gradient_threshold,
                                    int32_t brightness_threshold,
                                    const thinbench_execution* execution,
                                    thinbench_regions** regions) {
  return guarded([&] {
    require_pointer(regions, "regions");
    *regions = nullptr;
    const EdgeThresholds thresholds = {gradient_threshold, brightness_threshold};
    hand_over(localise_objects(image_of(grey), thresholds, execution_of(execution)), regions);
  });
}

const thinbench_region* thinbench_regions_objects(const thinbench_regions* regions, size_t* count,
                                                  size_t size) {
  return list_of<thinbench_region>(regions, &thinbench_regions::objects, count, size);
}

const thinbench_region* thinbench_regions_holes(const thinbench_regions* regions, size_t* count,
                                                size_t size) {
  return list_of<thinbench_region>(regions, &thinbench_regions::holes, count, size);
}

void thinbench_regions_destroy(thinbench_regions* regions) {
  delete regions;
}

thinbench_status thinbench_fill_holes(const thinbench_stack* source,
                                      const thinbench_output* destination,
                                      const thinbench_execution* execution) {
  return thinbench_fill_small_holes(source, destination, 8, kAnyHoleArea, execution);
}

thinbench_status thinbench_fill_small_holes(const thinbench_stack* source,
                                            const thinbench_output* destination,
                                            int32_t connectivity, int64_t max_area,
                                            const thinbench_execution* execution) {
  return guarded([&] {
    detail::require_connectivity(connectivity);
    const Execution given = execution_of(execution);
    for_images(source, destination, [&](const ConstImageView& from, const ImageView& to) {
      fill_holes(from, to, {static_cast<Connectivity>(connectivity), max_area}, given);
    });
  });
}

thinbench_status thinbench_fill_label_holes(const int32_t* source, ptrdiff_t source_stride,
                                            int32_t* destination, ptrdiff_t destination_stride,
                                            ptrdiff_t height, ptrdiff_t width, int32_t connectivity,
                                            int64_t max_area,
                                            const thinbench_execution* execution) {
  return guarded([&] {
    fill_holes_of_labels({source, width, height, source_stride},
                         {destination, width, height, destination_stride},
                         {connectivity_of(connectivity), max_area}, execution_of(execution));
  });
}

thinbench_status thinbench_euler_number(const thinbench_stack* source, int32_t connectivity,
                                        const thinbench_execution* execution, int64_t* number) {
  return guarded([&] {
    require_pointer(number, "number");
    *number =
        euler_number(image_of(source), connectivity_of(connectivity), execution_of(execution));
  });
}

const char* thinbench_edge_operator_name(size_t index) {
  return name_at(kEdgeOperators, index);
}

const char* thinbench_isa_name(size_t index) {
  return index < all_isas().size() ? isa_name(all_isas()[index]).data() : nullptr;
}

int32_t thinbench_isa_available(const char* isa) {
  bool available = false;
  const thinbench_status status = guarded([&] { available = isa_available(isa_of(isa)); });
  if (status != THINBENCH_OK) return -1;
  return available ? 1 : 0;
}
