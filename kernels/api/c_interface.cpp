// The C interface: arguments to C++ types, exceptions to statuses.
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

#include "api/catalogue.hpp"
#include "api/many.hpp"
#include "image/checks.hpp"
#include "thinbench.h"
#include "thinbench/batch.hpp"
#include "thinbench/edges.hpp"
#include "thinbench/labels.hpp"
#include "thinbench/localise.hpp"
#include "thinbench/packed.hpp"
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
using detail::require;

thread_local std::string last_error;

thinbench_status fail(thinbench_status status, const char* message) noexcept {
  try {
    last_error = message;
  } catch (...) {
    last_error.clear();
  }
  return status;
}

/// Runs a body and turns its exceptions into a status.
template <class Body>
thinbench_status guarded(const Body& body) noexcept {
  try {
    body();
    return THINBENCH_OK;
  } catch (const std::bad_alloc&) {
    return fail(THINBENCH_OUT_OF_MEMORY, "out of memory");
  } catch (const std::invalid_argument& error) {
    return fail(THINBENCH_INVALID_ARGUMENT, error.what());
  } catch (const std::exception& error) {
    return fail(THINBENCH_INTERNAL_ERROR, error.what());
  } catch (...) {
    return fail(THINBENCH_INTERNAL_ERROR, "unknown error");
  }
}

std::string text_of(const char* name) {
  return name == nullptr ? "NULL" : std::string("'").append(name).append("'");
}

void require_pointer(const void* pointer, const char* name) {
  require(pointer != nullptr, name + std::string(" is NULL"));
}

template <class Infos>
std::string names_of(const Infos& infos) {
  std::string names;
  for (const auto& info : infos) names.append(names.empty() ? "" : ", ").append(info.name);
  return names;
}

/// The value with this name, if there is one; `names` lists all for the message.
template <class T, class Names>
T named(const char* what, const char* name, std::optional<T> value, const Names& names) {
  if (!value) {
    throw std::invalid_argument(std::string(what) + ": expected one of " + names() + "; got " +
                                text_of(name));
  }
  return *value;
}

std::string_view view_of(const char* name) {
  return name == nullptr ? std::string_view() : name;
}

Rule rule_of(const char* name) {
  return named("rule", name, rule_from_name(view_of(name)), [] { return names_of(kRules); });
}

Isa isa_of(const char* name) {
  return named("isa", name, isa_from_name(view_of(name)), [] {
    std::string names;
    for (const Isa isa : kAllIsas) names.append(names.empty() ? "" : ", ").append(isa_name(isa));
    return names;
  });
}

/// A struct whose caller may know fewer members than this library, but at least those up to
/// `first_version`; the others keep their defaults.
template <class Struct>
Struct versioned(const Struct* given, size_t first_version, Struct defaults, const char* name) {
  require(first_version <= given->size && given->size <= sizeof(Struct),
          std::string(name) + ".size: expected " + std::to_string(sizeof(Struct)) + ", got " +
              std::to_string(given->size));
  std::memcpy(&defaults, given, given->size);
  return defaults;
}

constexpr size_t kFirstOptions = offsetof(thinbench_options, technique) + sizeof(const char*);
constexpr size_t kFirstVariant =
    offsetof(thinbench_variant, unavailable_reason) + sizeof(const char*);

Options options_of(const thinbench_options* given) {
  Options options;
  if (given == nullptr) return options;
  const thinbench_options defaults = THINBENCH_OPTIONS_INIT;
  const auto from = versioned(given, kFirstOptions, defaults, "options");
  require(from.max_iterations >= 0, "max_iterations: expected 0 (unlimited) or more, got " +
                                        std::to_string(from.max_iterations));
  options.border = from.keep_border != 0 ? Border::keep : Border::background;
  if (from.max_iterations > 0) options.max_iterations = from.max_iterations;
  options.threads = from.threads;
  if (from.isa != nullptr) options.isa = isa_of(from.isa);
  if (from.technique != nullptr) {
    options.technique = named("technique", from.technique, technique_from_name(from.technique),
                              [] { return names_of(kTechniques); });
  }
  return options;
}

/// Where there is no next image, the distance to it says nothing and passes every check.
Index image_stride_of(Index given, Index count) {
  return count == 1 ? PTRDIFF_MAX : given;
}

ConstStackView source_of(const thinbench_stack* stack) {
  require_pointer(stack, "source");
  return {stack->data,   stack->count,  stack->width,
          stack->height, stack->stride, image_stride_of(stack->image_stride, stack->count)};
}

StackView destination_of(const thinbench_output* output, const ConstStackView& source) {
  require_pointer(output, "destination");
  return {output->data,  source.count,   source.width,
          source.height, output->stride, image_stride_of(output->image_stride, source.count)};
}

ConstImageView image_of(const thinbench_stack* stack) {
  const ConstStackView source = source_of(stack);
  require(source.count == 1, "expected one image, got " + std::to_string(source.count));
  return source.image(0);
}

void and_with(std::uint8_t* pixels, Index count, std::uint8_t value) {
  for (Index i = 0; i < count; ++i) pixels[i] &= value;
}

std::uint8_t foreground_of(const thinbench_output& output) {
  return output.foreground == 0 ? 255 : output.foreground;
}

/// Replaces 255 by the value that the caller wants for foreground.
void set_foreground(const thinbench_output* output, const StackView& written) {
  const std::uint8_t value = foreground_of(*output);
  if (value == 255) return;
  const Index pixels = written.width * written.height;
  const bool contiguous =
      written.stride == written.width && (written.count == 1 || written.image_stride == pixels);
  if (contiguous) {
    and_with(written.data, written.count * pixels, value);
    return;
  }
  for (Index i = 0; i < written.count; ++i) {
    for (Index y = 0; y < written.height; ++y) {
      and_with(written.image(i).row(y), written.width, value);
    }
  }
}

/// Calls `body(source, destination)` for every image, after a check of the whole stack. Without
/// images it does so once for an image without rows, so that `body` checks the other arguments.
template <class Body>
void for_images(const thinbench_stack* stack, const thinbench_output* output, const Body& body) {
  const ConstStackView source = source_of(stack);
  const StackView destination = destination_of(output, source);
  detail::check_stacks(source, destination);
  if (source.count == 0) body({nullptr, source.width, 0}, {nullptr, source.width, 0});
  for (Index i = 0; i < source.count; ++i) body(source.image(i), destination.image(i));
  set_foreground(output, destination);
}

/// Images [first, last) of a stack.
template <class Stack>
Stack part_of(Stack stack, Index first, Index last) {
  stack.data += first * stack.image_stride;
  stack.count = last - first;
  return stack;
}

/// Thins a stack in parts that stay in the cache until their foreground has its value.
int thin_stack(Rule rule, const ConstStackView& source, const StackView& destination,
               const Options& options, const thinbench_output* output) {
  constexpr Index part_bytes = Index{1} << 18;
  detail::check_stacks(source, destination);
  detail::require_threads(options.threads);
  constexpr Index images_per_thread = 16;
  Options useful = options;
  useful.threads = static_cast<int>(std::clamp<Index>(
      (source.count + images_per_thread - 1) / images_per_thread, 1, options.threads));
  ThinningBatch batch(rule, source.width, source.height, useful);
  const Index image_bytes = std::max<Index>(1, source.height * source.stride);
  const Index part = std::max<Index>(16, part_bytes / image_bytes * options.threads);
  int iterations = 0;
  for (Index first = 0; first < source.count; first += part) {
    const Index last = std::min(first + part, source.count);
    const StackView written = part_of(destination, first, last);
    iterations = std::max(iterations, batch(part_of(source, first, last), written));
    set_foreground(output, written);
  }
  return iterations;
}

template <class Infos>
const char* name_at(const Infos& infos, size_t index) {
  return index < infos.size() ? infos[index].name.data() : nullptr;
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
  return last_error.c_str();
}

thinbench_status thinbench_thin(const char* rule, const thinbench_stack* source,
                                const thinbench_output* destination,
                                const thinbench_options* options, int32_t* iterations) {
  return guarded([&] {
    const ConstStackView from = source_of(source);
    const StackView to = destination_of(destination, from);
    int count = 0;
    if (from.count == 1) {
      count = thin(rule_of(rule), from.image(0), to.image(0), options_of(options));
      set_foreground(destination, to);
    } else {
      count = thin_stack(rule_of(rule), from, to, options_of(options), destination);
    }
    if (iterations != nullptr) *iterations = count;
  });
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
    const int maximum =
        detail::thin_list(rule_of(rule), {from, to, foregrounds}, options_of(options));
    if (iterations != nullptr) *iterations = maximum;
  });
}

thinbench_status thinbench_thin_packed(const char* rule, const thinbench_packed* source,
                                       uint8_t* destination, ptrdiff_t destination_stride,
                                       const thinbench_options* options, int32_t* iterations) {
  return guarded([&] {
    require_pointer(source, "source");
    const BitOrder order = source->lsb_first != 0 ? BitOrder::lsb_first : BitOrder::msb_first;
    const int count =
        thin(rule_of(rule),
             ConstPackedView(source->data, source->width, source->height, source->stride, order),
             PackedView(destination, source->width, source->height, destination_stride, order),
             options_of(options));
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
  return index < kAllIsas.size() ? isa_name(kAllIsas[index]).data() : nullptr;
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
    const auto& variants = detail::operation_of(rule_of(rule)).variants;
    require(index < variants.size(), "index: expected less than " +
                                         std::to_string(variants.size()) + ", got " +
                                         std::to_string(index));
    const detail::VariantInfo& info = variants[index];
    reason = detail::unavailable_reason(info, 0);
    const thinbench_variant found = {size, technique_name(info.technique).data(),
                                     isa_name(info.isa).data(), info.threaded ? 1 : 0,
                                     reason.empty() ? nullptr : reason.c_str()};
    std::memcpy(variant, &found, size);
  });
}
