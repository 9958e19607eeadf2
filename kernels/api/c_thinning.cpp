// The C interface of thinning.
#include <algorithm>

#include "api/c_arguments.hpp"
#include "core/checks.hpp"
#include "thinbench/labels.hpp"
#include "thinbench/many.hpp"
#include "thinbench/thinning.hpp"

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

/// Thins a stack in parts that stay in the cache until their foreground has its value.
int run_stack(const ThinningCall& call, const ConstStackView& source, const StackView& destination,
              const thinbench_output* output) {
  constexpr Index part_bytes = Index{1} << 18;
  check_views(source, destination, InPlace::allowed);
  StackThinner thinner(call.rule, source.width, source.height, call.thinning, call.execution);
  if (source.width == 0 || source.height == 0) return thinner(source, destination);
  const Index image_bytes = std::max<Index>(1, source.height * source.stride);
  const Index part = std::max<Index>(16, part_bytes / image_bytes * call.execution.threads);
  int iterations = 0;
  for (Index first = 0; first < source.count; first += part) {
    const Index last = std::min(first + part, source.count);
    const StackView written = part_of(destination, first, last);
    iterations = std::max(iterations, thinner(part_of(source, first, last), written));
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
    for (size_t i = 0; i < count; ++i) {
      from.push_back(image_of(&sources[i]));
      to.emplace_back(destinations[i].data, from[i].width, from[i].height, destinations[i].stride);
    }
    const ThinningCall call = call_of(rule, thinning, execution);
    const int maximum = thin_many(call.rule, from, to, call.thinning, call.execution);
    for (size_t i = 0; i < count; ++i) {
      set_foreground(&destinations[i], {to[i].data, 1, to[i].width, to[i].height, to[i].stride, 0});
    }
    if (iterations != nullptr) *iterations = maximum;
  });
}

thinbench_status thinbench_thin_packed(const thinbench_rule* rule, const thinbench_packed* source,
                                       uint8_t* destination, ptrdiff_t destination_stride,
                                       const thinbench_thinning* thinning,
                                       const thinbench_execution* execution, int32_t* iterations) {
  return guarded([&] {
    const PackedViews views = packed_views(source, destination, destination_stride);
    const int count = thin_packed(rule_of(rule), views.source, views.destination,
                                  thinning_of(thinning), execution_of(execution));
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

void thinbench_thinner_destroy(thinbench_thinner* thinner) {
  delete thinner;
}
