#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "core/exported.hpp"
#include "engines/lanes.hpp"
#include "harness/families.hpp"
#include "reference.hpp"
#include "scan/built_in.hpp"
#include "techniques/variants.hpp"
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

/// Of the images in an input of this size; 0 where there are none, so that no memory is allocated.
Index side_of(Index width, Index height) {
  return height >= width ? width : 0;
}

/// Thins all images of a stack and returns the largest number of iterations.
using ThinStack = std::function<int(const ConstStackView& source, const StackView& destination)>;

class StackJob final : public Job {
 public:
  explicit StackJob(ThinStack thin) : thin_(std::move(thin)) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    const auto destination = stack_in<StackView>(output);
    iterations_ = thin_(stack_in<ConstStackView>(input), destination);
    for (Index y = destination.count * output.width; y < output.height; ++y) {
      std::fill_n(output.row(y), output.width, std::uint8_t{0});
    }
  }
  [[nodiscard]] std::vector<std::int64_t> numbers() const override { return {iterations_}; }
  [[nodiscard]] std::string name_of_number(std::size_t) const override { return "iterations"; }

 private:
  ThinStack thin_;
  int iterations_ = 0;
};

template <class ThinImage>
ThinStack one_by_one(ThinImage thin) {
  return [thin = std::move(thin)](const ConstStackView& source, const StackView& destination) {
    int iterations = 0;
    for (Index i = 0; i < source.count; ++i) {
      iterations = std::max(iterations, thin(source.image(i), destination.image(i)));
    }
    return iterations;
  };
}

JobMaker reference_of(BuiltInRule rule) {
  return [function = reference::thinning(rule)](Index, Index, int) {
    return std::make_unique<StackJob>(
        one_by_one([function](const ConstImageView& source, const ImageView& destination) {
          return function({}, source, destination);
        }));
  };
}

JobMaker one_by_one(BuiltInRule rule, Isa highest) {
  return [rule, highest](Index width, Index height, int) {
    const Index side = side_of(width, height);
    const std::shared_ptr<detail::ThinningState> state =
        detail::make_thinning({rule, {}, {.isa = highest}}, side, side);
    return std::make_unique<StackJob>(
        one_by_one([state](const ConstImageView& source, const ImageView& destination) {
          return state->run(source, destination);
        }));
  };
}

JobMaker batch(BuiltInRule rule, Isa isa) {
  return [rule, isa](Index width, Index height, int) {
    const Index side = side_of(width, height);
    const auto thinner =
        std::make_shared<StackThinner>(rule, side, side, Thinning{}, Execution{.isa = isa});
    return std::make_unique<StackJob>(
        [thinner](const ConstStackView& source, const StackView& destination) {
          return (*thinner)(source, destination);
        });
  };
}

Variant variant_of(std::string_view technique, std::string_view description, Isa isa,
                   Index max_width, int priority, JobMaker make_job) {
  const detail::VariantInfo info = {technique, isa, false, max_width};
  return {technique,
          description,
          isa,
          false,
          false,
          std::move(make_job),
          [info](Index width) { return unavailable_reason(info, width); },
          2 * static_cast<int>(isa) + priority};
}

Operation operation_of(const BatchRule& batch_rule) {
  const auto [rule, name] = batch_rule;
  Operation operation = {std::string(name),
                         "thins many small images of one size",
                         InputKind::binary,
                         {},
                         reference_of(rule)};
  for (const Isa isa : detail::isas_of<detail::BuiltInScans>()) {
    operation.variants.push_back(
        variant_of("one_by_one", "image after image by the library's choice for one image", isa,
                   detail::kAnyWidth, 0, one_by_one(rule, isa)));
    operation.variants.push_back(variant_of("batch", "one image per lane of a vector register", isa,
                                            detail::kMaxLaneWidth, 1, batch(rule, isa)));
  }
  operation.counter = "iterations";
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
