// The C interface of objects and holes.
#include <cstddef>

#include "api/c_arguments.hpp"
#include "thinbench/localise.hpp"

static_assert(offsetof(thinbench_region, reserved) == offsetof(thinbench::Region, reserved));

struct thinbench_regions : thinbench::Regions {};

namespace {

using namespace thinbench;
using namespace thinbench::detail;

LabelOrder order_of(const char* name) {
  constexpr std::string_view names[] = {"pixels", "opencv"};
  return name == nullptr ? LabelOrder::pixels : enumerator<LabelOrder>("order", name, names);
}

HoleFilling filling_of(const thinbench_hole_filling* given) {
  if (given == nullptr) return {};
  const auto all = known(given, thinbench_hole_filling THINBENCH_HOLE_FILLING_INIT, "filling");
  return {connectivity_of(all.connectivity), all.max_area};
}

}  // namespace

thinbench_status thinbench_find_regions(const thinbench_image* source,
                                        const thinbench_execution* execution,
                                        thinbench_regions** regions) {
  return give(regions, "regions",
              [&] { return find_regions(image_of(source), execution_of(execution)); });
}

thinbench_status thinbench_label_regions(const thinbench_image* source,
                                         const thinbench_labels* labels,
                                         const thinbench_execution* execution,
                                         thinbench_regions** regions) {
  return give(regions, "regions", [&] {
    return label_regions(image_of(source), labels_of(labels, "labels"), execution_of(execution));
  });
}

thinbench_status thinbench_find_objects(const thinbench_image* source,
                                        const thinbench_execution* execution,
                                        thinbench_regions** regions) {
  return give(regions, "regions", [&] {
    return Regions{find_objects(image_of(source), execution_of(execution)), {}};
  });
}

thinbench_status thinbench_label_objects(const thinbench_image* source,
                                         const thinbench_labels* labels, int32_t connectivity,
                                         const char* order, const thinbench_execution* execution,
                                         thinbench_regions** regions) {
  return give(regions, "regions", [&] {
    return Regions{
        label_objects(image_of(source), labels_of(labels, "labels"), connectivity_of(connectivity),
                      order_of(order), execution_of(execution)),
        {}};
  });
}

thinbench_status thinbench_label_image(const thinbench_image* source,
                                       const thinbench_labels* labels, int32_t connectivity,
                                       const char* order, const thinbench_execution* execution,
                                       uint32_t* objects) {
  return guarded([&] {
    require_pointer(objects, "objects");
    *objects = label_image(image_of(source), labels_of(labels, "labels"),
                           connectivity_of(connectivity), order_of(order), execution_of(execution));
  });
}

thinbench_status thinbench_label_values(const thinbench_labels* values,
                                        const thinbench_labels* labels, int32_t connectivity,
                                        int32_t background, const thinbench_execution* execution,
                                        uint32_t* components) {
  return guarded([&] {
    require_pointer(components, "components");
    *components = label_values(labels_of(values, "values"), labels_of(labels, "labels"),
                               connectivity_of(connectivity), background, execution_of(execution));
  });
}

thinbench_status thinbench_localise_objects(const thinbench_image* grey,
                                            const thinbench_image* objects,
                                            int32_t gradient_threshold,
                                            int32_t brightness_threshold,
                                            const thinbench_execution* execution,
                                            thinbench_regions** regions) {
  return give(regions, "regions", [&] {
    const ConstImageView source = image_of(grey, "grey");
    const EdgeThresholds thresholds = {gradient_threshold, brightness_threshold};
    if (objects == nullptr) return localise_objects(source, thresholds, execution_of(execution));
    Regions found;
    const auto write = [&](const ImageView& to) {
      check(memory_of("grey", source), memory_of("objects", to), InPlace::allowed);
      found = localise_objects(source, thresholds, execution_of(execution), to);
    };
    write_to(objects, write, "objects");
    return found;
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

thinbench_status thinbench_fill_holes(const thinbench_image* source,
                                      const thinbench_image* destination,
                                      const thinbench_hole_filling* filling,
                                      const thinbench_execution* execution) {
  return guarded([&] {
    write_to(destination, [&](const ImageView& to) {
      fill_holes(image_of(source), to, filling_of(filling), execution_of(execution));
    });
  });
}

thinbench_status thinbench_fill_holes_of_labels(const thinbench_labels* source,
                                                const thinbench_labels* destination,
                                                const thinbench_hole_filling* filling,
                                                const thinbench_execution* execution) {
  return guarded([&] {
    fill_holes_of_labels(labels_of(source, "source"), labels_of(destination, "destination"),
                         filling_of(filling), execution_of(execution));
  });
}

thinbench_status thinbench_euler_number(const thinbench_image* source, int32_t connectivity,
                                        const thinbench_execution* execution, int64_t* number) {
  return guarded([&] {
    require_pointer(number, "number");
    *number =
        euler_number(image_of(source), connectivity_of(connectivity), execution_of(execution));
  });
}
