// The C interface of built-in operations.
#include <cstddef>
#include <cstring>
#include <string>

#include "api/c_arguments.hpp"
#include "api/catalogue.hpp"
#include "api/many.hpp"
#include "image/checks.hpp"
#include "thinbench.h"
#include "thinbench/distance.hpp"
#include "thinbench/edges.hpp"
#include "thinbench/labels.hpp"
#include "thinbench/localise.hpp"
#include "thinbench/regions.hpp"
#include "thinbench/thinning.hpp"
#include "thinbench/version.hpp"

static_assert(sizeof(thinbench_region) == sizeof(thinbench::Region));
static_assert(offsetof(thinbench_region, enclosing_object) ==
              offsetof(thinbench::Region, enclosing_object));

struct thinbench_thinner {
  thinbench::Thinner thinner;
};

struct thinbench_regions {
  thinbench::Regions found;
};

namespace {

using namespace thinbench;
using namespace thinbench::detail;

Rule rule_of(const char* name) {
  return named("rule", name, rule_from_name(view_of(name)), [] { return names_of(kRules); });
}

constexpr size_t kFirstVariant =
    offsetof(thinbench_variant, unavailable_reason) + sizeof(const char*);

/// Calls `body(source, destination)` for every image, after a check of the whole stack. Without
/// pixels, where there may be no memory, it does so once for an image without rows, so that `body`
/// checks the other arguments.
template <class Body>
void for_images(const thinbench_stack* stack, const thinbench_output* output, const Body& body) {
  const ConstStackView source = source_of(stack);
  const StackView destination = destination_of(output, source);
  check_stacks(source, destination);
  if (source.count == 0 || source.width == 0 || source.height == 0) {
    body({nullptr, source.width, 0}, {nullptr, source.width, 0});
    return;
  }
  for (Index i = 0; i < source.count; ++i) body(source.image(i), destination.image(i));
  set_foreground(output, destination);
}

const thinbench_region* regions_of(const std::vector<Region>& list, size_t* count, size_t size) {
  const bool same_struct = size == sizeof(thinbench_region);
  if (count != nullptr) *count = same_struct ? list.size() : 0;
  if (!same_struct) return nullptr;
  return reinterpret_cast<const thinbench_region*>(list.data());
}

/// Hands over a result in a handle.
void hand_over(Regions found, thinbench_regions** handle) {
  *handle = new thinbench_regions{std::move(found)};
}

}  // namespace

const char* thinbench_version() {
  return kVersion.data();
}

const char* thinbench_last_error() {
  return last_error();
}

thinbench_status thinbench_thin(const char* rule, const thinbench_stack* source,
                                const thinbench_output* destination,
                                const thinbench_options* options, int32_t* iterations) {
  return guarded([&] { run_images(rule_of(rule), source, destination, options, iterations); });
}

thinbench_status thinbench_thin_many(const char* rule, const thinbench_stack* sources,
                                     const thinbench_output* destinations, size_t count,
                                     const thinbench_options* options, int32_t* iterations) {
  return guarded([&] {
    if (count > 0) {
      require_pointer(sources, "sources");
      require_pointer(destinations, "destinations");
    }
    std::vector<ConstImageView> from;
    std::vector<ImageView> to;
    std::vector<std::uint8_t> foregrounds;
    for (size_t i = 0; i < count; ++i) {
      from.push_back(image_of(&sources[i]));
      to.emplace_back(destinations[i].data, from[i].width, from[i].height, destinations[i].stride);
      foregrounds.push_back(foreground_of(destinations[i]));
    }
    const int maximum = thin_list(rule_of(rule), {from, to, foregrounds}, options_of(options));
    if (iterations != nullptr) *iterations = maximum;
  });
}

thinbench_status thinbench_thin_packed(const char* rule, const thinbench_packed* source,
                                       uint8_t* destination, ptrdiff_t destination_stride,
                                       const thinbench_options* options, int32_t* iterations) {
  return guarded([&] {
    const PackedViews views = packed_views(source, destination, destination_stride);
    const int count = thin(rule_of(rule), views.source, views.destination, options_of(options));
    if (iterations != nullptr) *iterations = count;
  });
}

thinbench_status thinbench_thin_labels(const char* rule, const int32_t* source,
                                       ptrdiff_t source_stride, int32_t* destination,
                                       ptrdiff_t destination_stride, ptrdiff_t height,
                                       ptrdiff_t width, const thinbench_options* options,
                                       int32_t* iterations) {
  return guarded([&] {
    const int count =
        thin_labels(rule_of(rule), {source, width, height, source_stride},
                    {destination, width, height, destination_stride}, options_of(options));
    if (iterations != nullptr) *iterations = count;
  });
}

thinbench_status thinbench_thinner_create(const char* rule, ptrdiff_t width, ptrdiff_t height,
                                          const thinbench_options* options,
                                          thinbench_thinner** thinner) {
  return guarded([&] {
    require_pointer(thinner, "thinner");
    *thinner = nullptr;
    *thinner = new thinbench_thinner{Thinner(rule_of(rule), width, height, options_of(options))};
  });
}

thinbench_status thinbench_thinner_run(thinbench_thinner* thinner, const thinbench_stack* source,
                                       const thinbench_output* destination, int32_t* iterations) {
  return guarded([&] {
    require_pointer(thinner, "thinner");
    const StackView to = destination_of(destination, source_of(source));
    const int count = thinner->thinner(image_of(source), to.image(0));
    set_foreground(destination, to);
    if (iterations != nullptr) *iterations = count;
  });
}

const char* thinbench_thinner_technique(const thinbench_thinner* thinner) {
  return thinner == nullptr ? nullptr : technique_name(thinner->thinner.technique()).data();
}

const char* thinbench_thinner_isa(const thinbench_thinner* thinner) {
  return thinner == nullptr ? nullptr : isa_name(thinner->thinner.isa()).data();
}

void thinbench_thinner_destroy(thinbench_thinner* thinner) {
  delete thinner;
}

thinbench_status thinbench_edges(const char* edge_operator, const thinbench_stack* source,
                                 const thinbench_output* destination, int32_t gradient_threshold,
                                 int32_t brightness_threshold, const thinbench_options* options) {
  return guarded([&] {
    const EdgeOperator op =
        named("edge operator", edge_operator, edge_operator_from_name(view_of(edge_operator)),
              [] { return names_of(kEdgeOperators); });
    const EdgeThresholds thresholds = {gradient_threshold, brightness_threshold};
    const Options given = options_of(options);
    for_images(source, destination, [&](const ConstImageView& from, const ImageView& to) {
      detect_edges(op, from, to, thresholds, given);
    });
  });
}

thinbench_status thinbench_squared_distances(const thinbench_stack* source, int32_t* distances,
                                             ptrdiff_t stride, const thinbench_options* options) {
  return guarded([&] {
    const ConstImageView image = image_of(source);
    squared_distances(image, {distances, image.width, image.height, stride}, options_of(options));
  });
}

thinbench_status thinbench_find_regions(const thinbench_stack* source, int32_t* labels,
                                        ptrdiff_t labels_stride, const thinbench_options* options,
                                        thinbench_regions** regions) {
  return guarded([&] {
    require_pointer(regions, "regions");
    *regions = nullptr;
    const ConstImageView image = image_of(source);
    const Options given = options_of(options);
    if (labels == nullptr) {
      hand_over(find_regions(image, given), regions);
      return;
    }
    require(given.border == Border::background && given.max_iterations == kUnlimited &&
                given.threads == 1 && !given.isa && !given.technique,
            "options: with labels none may be set");
    hand_over(label_regions(image, {labels, image.width, image.height, labels_stride}), regions);
  });
}

thinbench_status thinbench_localise(const thinbench_stack* grey, int32_t gradient_threshold,
                                    int32_t brightness_threshold, const thinbench_options* options,
                                    thinbench_regions** regions) {
  return guarded([&] {
    require_pointer(regions, "regions");
    *regions = nullptr;
    const EdgeThresholds thresholds = {gradient_threshold, brightness_threshold};
    hand_over(localise_objects(image_of(grey), thresholds, options_of(options)), regions);
  });
}

const thinbench_region* thinbench_regions_objects(const thinbench_regions* regions, size_t* count,
                                                  size_t size) {
  static const std::vector<Region> none;
  return regions_of(regions == nullptr ? none : regions->found.objects, count, size);
}

const thinbench_region* thinbench_regions_holes(const thinbench_regions* regions, size_t* count,
                                                size_t size) {
  static const std::vector<Region> none;
  return regions_of(regions == nullptr ? none : regions->found.holes, count, size);
}

void thinbench_regions_destroy(thinbench_regions* regions) {
  delete regions;
}

thinbench_status thinbench_fill_holes(const thinbench_stack* source,
                                      const thinbench_output* destination,
                                      const thinbench_options* options) {
  return guarded([&] {
    const Options given = options_of(options);
    for_images(source, destination, [&](const ConstImageView& from, const ImageView& to) {
      fill_holes(from, to, given);
    });
  });
}

thinbench_status thinbench_euler_number(const thinbench_stack* source, int32_t connectivity,
                                        const thinbench_options* options, int64_t* number) {
  return guarded([&] {
    require_pointer(number, "number");
    require(connectivity == 4 || connectivity == 8,
            "connectivity: expected 4 or 8, got " + std::to_string(connectivity));
    const Options given = options_of(options);
    *number = connectivity == 8 ? euler_number(image_of(source), given)
                                : euler_number_4(image_of(source), given);
  });
}

const char* thinbench_rule_name(size_t index) {
  return name_at(kRules, index);
}

const char* thinbench_rule_description(size_t index) {
  return index < kRules.size() ? kRules[index].description.data() : nullptr;
}

int32_t thinbench_rule_reach(size_t index) {
  return index < kRules.size() ? kRules[index].reach : -1;
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

thinbench_status thinbench_rule_variant(const char* rule, size_t index,
                                        thinbench_variant* variant) {
  return guarded([&] {
    static thread_local std::string reason;
    require_pointer(variant, "variant");
    const size_t size = versioned(variant, kFirstVariant, thinbench_variant{}, "variant").size;
    const auto& variants = operation_of(rule_of(rule)).variants;
    require(index < variants.size(), "index: expected less than " +
                                         std::to_string(variants.size()) + ", got " +
                                         std::to_string(index));
    const VariantInfo& info = variants[index];
    reason = unavailable_reason(info, 0);
    const thinbench_variant found = {size, technique_name(info.technique).data(),
                                     isa_name(info.isa).data(), info.threaded ? 1 : 0,
                                     reason.empty() ? nullptr : reason.c_str()};
    std::memcpy(variant, &found, size);
  });
}
