// The C interface of thinning.
#include <algorithm>

#include "api/c_arguments.hpp"
#include "core/checks.hpp"
#include "thinbench/batch.hpp"
#include "thinbench/labels.hpp"
#include "thinbench/thinning.hpp"
#include "thinning/many.hpp"

struct thinbench_thinner {
  thinbench::Thinner thinner;
};

namespace {

using namespace thinbench;
using namespace thinbench::detail;

int run_image(const ThinningCall& call, const ConstStackView& source, const StackView& destination,
              const thinbench_output* output) {
  const int iterations =
      thin(call.rule, source.image(0), destination.image(0), call.thinning, call.execution);
  set_foreground(output, destination);
  return iterations;
}

/// Images [first, last) of a stack.
template <class Stack>
Stack part_of(Stack stack, Index first, Index last) {
  stack.data += first * stack.image_stride;
  stack.count = last - first;
  return stack;
}

/// A number of threads for which each has enough images.
int useful_threads(Index images, int threads) {
  constexpr Index images_per_thread = 16;
  return static_cast<int>(std::clamp<Index>((images - 1) / images_per_thread + 1, 1, threads));
}

/// Thins a stack in parts that stay in the cache until their foreground has its value.
int run_stack(ThinningCall call, const ConstStackView& source, const StackView& destination,
              const thinbench_output* output) {
  constexpr Index part_bytes = Index{1} << 18;
  check_views(source, destination, InPlace::allowed);
  require_threads(call.execution.threads);
  call.execution.threads = useful_threads(source.count, call.execution.threads);
  ThinningBatch batch(call.rule, source.width, source.height, call.thinning, call.execution);
  if (source.width == 0 || source.height == 0) return batch(source, destination);
  const Index image_bytes = std::max<Index>(1, source.height * source.stride);
  const Index part = std::max<Index>(16, part_bytes / image_bytes * call.execution.threads);
  int iterations = 0;
  for (Index first = 0; first < source.count; first += part) {
    const Index last = std::min(first + part, source.count);
    const StackView written = part_of(destination, first, last);
    iterations = std::max(iterations, batch(part_of(source, first, last), written));
    set_foreground(output, written);
  }
  return iterations;
}

}  // namespace

thinbench_status thinbench_thin(const thinbench_rule* rule, const thinbench_stack* source,
                                const thinbench_output* destination,
                                const thinbench_thinning* thinning,
                                const thinbench_execution* execution, int32_t* iterations) {
  return guarded([&] {
    const ThinningCall call = call_of(rule, thinning, execution);
    const ConstStackView from = source_of(source);
    const StackView to = destination_of(destination, from);
    const int count = from.count == 1 ? run_image(call, from, to, destination)
                                      : run_stack(call, from, to, destination);
    if (iterations != nullptr) *iterations = count;
  });
}

thinbench_status thinbench_thin_many(const thinbench_rule* rule, const thinbench_stack* sources,
                                     const thinbench_output* destinations, size_t count,
                                     const thinbench_thinning* thinning,
                                     const thinbench_execution* execution, int32_t* iterations) {
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
    const int maximum = thin_list(call_of(rule, thinning, execution), {from, to, foregrounds});
    if (iterations != nullptr) *iterations = maximum;
  });
}

thinbench_status thinbench_thin_packed(const thinbench_rule* rule, const thinbench_packed* source,
                                       uint8_t* destination, ptrdiff_t destination_stride,
                                       const thinbench_thinning* thinning,
                                       const thinbench_execution* execution, int32_t* iterations) {
  return guarded([&] {
    const PackedViews views = packed_views(source, destination, destination_stride);
    const int count = thin(rule_of(rule), views.source, views.destination, thinning_of(thinning),
                           execution_of(execution));
    if (iterations != nullptr) *iterations = count;
  });
}

thinbench_status thinbench_thin_labels(const thinbench_rule* rule, const int32_t* source,
                                       ptrdiff_t source_stride, int32_t* destination,
                                       ptrdiff_t destination_stride, ptrdiff_t height,
                                       ptrdiff_t width, const thinbench_thinning* thinning,
                                       const thinbench_execution* execution, int32_t* iterations) {
  return guarded([&] {
    const int count = thin_labels(rule_of(rule), {source, width, height, source_stride},
                                  {destination, width, height, destination_stride},
                                  thinning_of(thinning), execution_of(execution));
    if (iterations != nullptr) *iterations = count;
  });
}

thinbench_status thinbench_thinner_create(const thinbench_rule* rule, ptrdiff_t height,
                                          ptrdiff_t width, const thinbench_thinning* thinning,
                                          const thinbench_execution* execution,
                                          thinbench_thinner** thinner) {
  return guarded([&] {
    require_pointer(thinner, "thinner");
    *thinner = nullptr;
    *thinner = new thinbench_thinner{
        Thinner(rule_of(rule), width, height, thinning_of(thinning), execution_of(execution))};
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
  return thinner == nullptr ? nullptr : thinner->thinner.technique().data();
}

const char* thinbench_thinner_isa(const thinbench_thinner* thinner) {
  return thinner == nullptr ? nullptr : isa_name(thinner->thinner.isa()).data();
}

void thinbench_thinner_destroy(thinbench_thinner* thinner) {
  delete thinner;
}
