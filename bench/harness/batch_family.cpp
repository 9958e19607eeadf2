#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "core/exported.hpp"
#include "engines/lanes.hpp"
#include "harness/library_operation.hpp"
#include "reference.hpp"
#include "scan/built_in.hpp"
#include "thinbench/many.hpp"

namespace thinbench {
namespace {

struct BatchRule {
  BuiltInRule rule;
  std::string_view name;
};
constexpr std::array kBatchRules = {
    BatchRule{BuiltInRule::guo_hall, "batch_guo_hall"},
    BatchRule{BuiltInRule::zhang_suen, "batch_zhang_suen"},
    BatchRule{BuiltInRule::naccache_shinghal, "batch_naccache_shinghal"}};

/// The square images of an input; `View` is that of one image.
template <class Stack, class View>
Stack stack_in(const View& all) {
  const Index count = all.width > 0 ? all.height / all.width : 0;
  if (count == 0) return {};
  return {all.data, count, all.width, all.width, all.stride, all.width * all.stride};
}

/// Jobs that call `thin(source, destination)`, which `make_thin(side)` makes for images of this
/// size; 0 where there are none, so that no memory is allocated.
template <class MakeThin>
JobMaker stack_job_maker(MakeThin make_thin) {
  return [make_thin](Index width, Index height, int) {
    return counting_job(
        [thin = make_thin(height >= width ? width : 0)](const auto& input, const auto& output) {
          const auto destination = stack_in<StackView>(output);
          const int iterations = thin(stack_in<ConstStackView>(input), destination);
          for (Index y = destination.count * output.width; y < output.height; ++y) {
            std::fill_n(output.row(y), output.width, std::uint8_t{0});
          }
          return iterations;
        });
  };
}

/// Returns the largest number of iterations.
template <class ThinImage>
auto one_by_one(ThinImage thin) {
  return [thin = std::move(thin)](const ConstStackView& source, const StackView& destination) {
    int iterations = 0;
    for (Index i = 0; i < source.count; ++i) {
      iterations = std::max(iterations, thin(source.image(i), destination.image(i)));
    }
    return iterations;
  };
}

JobMaker by_reference(BuiltInRule rule) {
  return stack_job_maker([rule](Index) {
    return one_by_one([function = reference::thinning(rule)](const auto& from, const auto& to) {
      return function({}, from, to);
    });
  });
}

JobMaker by_images(BuiltInRule rule, Isa isa) {
  return stack_job_maker([rule, isa](Index side) {
    return one_by_one(
        [state = detail::make_thinning({rule, {}, {.isa = isa}}, side, side)](
            const ConstImageView& from, const ImageView& to) { return state->run(from, to); });
  });
}

JobMaker by_batches(BuiltInRule rule, Isa isa) {
  return stack_job_maker([rule, isa](Index side) {
    return [thinner = std::make_unique<StackThinner>(
                rule, side, side, Thinning{}, Execution{.isa = isa})](const auto& source,
                                                                      const auto& destination) {
      return (*thinner)(source, destination);
    };
  });
}

Operation operation_of(const BatchRule& batch_rule) {
  const auto [rule, name] = batch_rule;
  Operation operation = {std::string(name),
                         "thins many small images of one size",
                         InputKind::binary,
                         {},
                         by_reference(rule)};
  for (const Isa isa : detail::isas_of<detail::BuiltInScans>()) {
    const int priority = 2 * static_cast<int>(isa);
    operation.variants.push_back(library_variant(
        {"one_by_one", isa, false, detail::kAnyWidth, priority}, by_images(rule, isa),
        "image after image by the library's choice for one image"));
    operation.variants.push_back(
        library_variant({"batch", isa, false, detail::kMaxLaneWidth, priority + 1},
                        by_batches(rule, isa), "one image per lane of a vector register"));
  }
  operation.counts_iterations = true;
  operation.operation = name;
  operation.border = Border::background;
  operation.timed = false;
  return operation;
}

}  // namespace

std::vector<Operation> batch_family() {
  std::vector<Operation> family;
  for (const BatchRule& rule : kBatchRules) family.push_back(operation_of(rule));
  return family;
}

}  // namespace thinbench
