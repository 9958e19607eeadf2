// The C interface of thinning.
#include <algorithm>

#include "api/c_arguments.hpp"
#include "core/thread_team.hpp"
#include "thinbench/labels.hpp"
#include "thinbench/many.hpp"
#include "thinbench/thinning.hpp"

struct thinbench_thinner {
  thinbench::Thinner thinner;
};

namespace {

using namespace thinbench;
using namespace thinbench::detail;

/// Images [first, last) of a stack.
template <class Stack>
Stack part_of(Stack stack, Index first, Index last) {
  stack.data += first * stack.image_stride;
  stack.count = last - first;
  return stack;
}

/// Thins a stack in parts that stay in the cache until their foreground has its value.
int thin_by_parts(StackThinner& thinner, const ConstStackView& source,
                  const Written<StackView>& destination, int threads) {
  constexpr Index part_bytes = Index{1} << 18;
  if (source.width == 0 || source.height == 0) return thinner(source, destination.view);
  const Index image_bytes = std::max<Index>(1, source.height * source.stride);
  const Index part = std::max<Index>(16, part_bytes / image_bytes * threads);
  int iterations = 0;
  for (Index first = 0; first < source.count; first += part) {
    const Index last = std::min(first + part, source.count);
    const Written<StackView> to = {part_of(destination.view, first, last), destination.foreground};
    iterations = std::max(iterations, thinner(part_of(source, first, last), to.view));
    set_foreground(to);
  }
  return iterations;
}

/// Views of a list of structs, which are as large as the first of them says.
std::vector<Written<ImageView>> images_of(const thinbench_image* images, size_t count,
                                          const char* name) {
  if (count > 0) require_pointer(images, name);
  std::vector<Written<ImageView>> list;
  const auto* at = reinterpret_cast<const char*>(images);
  for (size_t i = 0; i < count; ++i, at += images->size) {
    const auto* const image = reinterpret_cast<const thinbench_image*>(at);
    list.push_back(written(image, name));
    require(image->size == images->size,
            [&] { return name + std::string(": expected structs of one size"); });
  }
  return list;
}

PackedView packed_of(const thinbench_packed* image, const char* name) {
  const auto from = known(image, thinbench_packed THINBENCH_PACKED_INIT, name);
  const BitOrder order = from.lsb_first != 0 ? BitOrder::lsb_first : BitOrder::msb_first;
  return {from.data, from.width, from.height, from.stride, order};
}

}  // namespace

thinbench_status thinbench_thin(const thinbench_rule* rule, const thinbench_image* source,
                                const thinbench_image* destination,
                                const thinbench_thinning* thinning,
                                const thinbench_execution* execution, int32_t* iterations) {
  return guarded([&] {
    const ConstImageView from = image_of(source);
    int count = 0;
    write_to(destination, [&](const ImageView& to) {
      count = thin(rule_of(rule), from, to, thinning_of(thinning), execution_of(execution));
    });
    report(count, iterations);
  });
}

thinbench_status thinbench_thin_stack(const thinbench_rule* rule, const thinbench_stack* source,
                                      const thinbench_stack* destination,
                                      const thinbench_thinning* thinning,
                                      const thinbench_execution* execution, int32_t* iterations) {
  return guarded([&] {
    const ConstStackView from = written(source, "source").view;
    const Written<StackView> to = written(destination, "destination");
    check_views(from, to.view, InPlace::allowed);
    const Execution given = execution_of(execution);
    StackThinner thinner(rule_of(rule), from.width, from.height, thinning_of(thinning), given);
    report(thin_by_parts(thinner, from, to, available_threads(given.threads)), iterations);
  });
}

thinbench_status thinbench_thin_many(const thinbench_rule* rule, const thinbench_image* sources,
                                     const thinbench_image* destinations, size_t count,
                                     const thinbench_thinning* thinning,
                                     const thinbench_execution* execution, int32_t* iterations) {
  return guarded([&] {
    const auto read_images = images_of(sources, count, "sources");
    const auto written_images = images_of(destinations, count, "destinations");
    std::vector<ConstImageView> from(count);
    std::vector<ImageView> to(count);
    for (std::size_t i = 0; i < count; ++i) {
      from[i] = read_images[i].view;
      to[i] = written_images[i].view;
    }
    const int maximum =
        thin_many(rule_of(rule), from, to, thinning_of(thinning), execution_of(execution));
    for (const auto& image : written_images) set_foreground(image);
    report(maximum, iterations);
  });
}

thinbench_status thinbench_thin_packed(const thinbench_rule* rule, const thinbench_packed* source,
                                       const thinbench_packed* destination,
                                       const thinbench_thinning* thinning,
                                       const thinbench_execution* execution, int32_t* iterations) {
  return guarded([&] {
    report(thin_packed(rule_of(rule), packed_of(source, "source"),
                       packed_of(destination, "destination"), thinning_of(thinning),
                       execution_of(execution)),
           iterations);
  });
}

thinbench_status thinbench_thin_labels(const thinbench_rule* rule, const thinbench_labels* source,
                                       const thinbench_labels* destination,
                                       const thinbench_thinning* thinning,
                                       const thinbench_execution* execution, int32_t* iterations) {
  return guarded([&] {
    report(thin_labels(rule_of(rule), labels_of(source, "source"),
                       labels_of(destination, "destination"), thinning_of(thinning),
                       execution_of(execution)),
           iterations);
  });
}

thinbench_status thinbench_thinner_create(const thinbench_rule* rule, ptrdiff_t width,
                                          ptrdiff_t height, const thinbench_thinning* thinning,
                                          const thinbench_execution* execution,
                                          thinbench_thinner** thinner) {
  return give(thinner, "thinner", [&] {
    return Thinner(rule_of(rule), width, height, thinning_of(thinning), execution_of(execution));
  });
}

thinbench_status thinbench_thinner_run(thinbench_thinner* thinner, const thinbench_image* source,
                                       const thinbench_image* destination, int32_t* iterations) {
  return guarded([&] {
    require_pointer(thinner, "thinner");
    const ConstImageView from = image_of(source);
    int count = 0;
    write_to(destination, [&](const ImageView& to) { count = thinner->thinner(from, to); });
    report(count, iterations);
  });
}

void thinbench_thinner_destroy(thinbench_thinner* thinner) {
  delete thinner;
}
