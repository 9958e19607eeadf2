#include <utility>

#include "harness/families.hpp"
#include "reference.hpp"

namespace thinbench {
namespace {

using detail::ThinningState;
using detail::ThinningVariant;

/// What all thinning gives beside the image.
class CountingJob : public Job {
 public:
  [[nodiscard]] std::vector<std::int64_t> numbers() const override { return {iterations_}; }
  [[nodiscard]] std::string name_of_number(std::size_t) const override { return "iterations"; }

 protected:
  int iterations_ = 0;
};

class StateJob final : public CountingJob {
 public:
  explicit StateJob(std::unique_ptr<ThinningState> state) : state_(std::move(state)) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    iterations_ = state_->run(input, output);
  }
  void load(const ConstImageView& input) override { state_->load(input); }
  void kernel() override { iterations_ = state_->thin(); }
  void store(const ImageView& output) const override { state_->store(output); }

 private:
  std::unique_ptr<ThinningState> state_;
};

class FunctionJob final : public CountingJob {
 public:
  using Function = std::function<int(const ConstImageView& input, const ImageView& output)>;

  explicit FunctionJob(Function function) : function_(std::move(function)) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    iterations_ = function_(input, output);
  }

 private:
  Function function_;
};

std::string case_name(std::string_view operation, const ThinningCase& options) {
  std::string name(operation);
  if (options.border == Border::keep) name += ":keep";
  if (options.max_iterations != kUnlimited) {
    name.append(":").append(std::to_string(options.max_iterations));
  }
  return name;
}

/// OpenCV keeps the border, by these two rules.
bool has_peer_with_border(Rule rule) {
  return rule == Rule::zhang_suen || rule == Rule::guo_hall;
}

}  // namespace

Variant library_variant(const detail::VariantInfo& variant, bool has_kernel_scope,
                        JobMaker make_job) {
  const TechniqueInfo& info = technique_info(variant.technique);
  return {info.name,
          info.description,
          variant.isa,
          variant.threaded,
          has_kernel_scope,
          std::move(make_job),
          [&variant](Index width) { return detail::unavailable_reason(variant, width); },
          variant.priority};
}

std::unique_ptr<Job> thinning_job(std::unique_ptr<ThinningState> state) {
  return std::make_unique<StateJob>(std::move(state));
}

std::unique_ptr<Job> counting_job(
    std::function<int(const ConstImageView& input, const ImageView& output)> function) {
  return std::make_unique<FunctionJob>(std::move(function));
}

Operation thinning_operation(const detail::ThinningOperation& operation,
                             const ThinningCase& options) {
  Operation result = {
      case_name(operation.name, options), operation.description, InputKind::binary, {}, {}};
  for (const ThinningVariant& variant : operation.variants) {
    Variant one = library_variant(
        variant, true, [&operation, &variant, options](Index width, Index height, int threads) {
          return thinning_job(make_state(operation, variant, width, height,
                                         {.border = options.border,
                                          .max_iterations = options.max_iterations,
                                          .threads = threads,
                                          .net = options.net}));
        });
    one.unavailable_reason = [&variant, options](Index width) {
      return detail::unavailable_reason(variant, width, options.border);
    };
    result.variants.push_back(std::move(one));
  }
  result.reference = [rule = operation.rule, options](Index, Index, int) {
    const reference::Repetition repetition = {options.border, options.max_iterations};
    return counting_job([repetition, function = reference::thinning(rule)](
                            const ConstImageView& input, const ImageView& output) {
      return function(repetition, input, output);
    });
  };
  result.counter = "iterations";
  result.is_net = operation.is_net;
  result.operation = operation.name;
  result.border = options.border;
  if (options.max_iterations != kUnlimited) result.max_iterations = options.max_iterations;
  result.small_sets_only = operation.is_net && !result.max_iterations;
  result.timed = options.border == Border::background || has_peer_with_border(operation.rule);
  return result;
}

std::vector<Operation> thinning_family() {
  std::vector<Operation> family;
  for (const detail::ThinningOperation& operation : detail::thinning_operations()) {
    for (const Border border : {Border::background, Border::keep}) {
      family.push_back(thinning_operation(operation, {border}));
      const bool has_single = operation.is_net && operation.rule != Rule::net_two_layer_rounded;
      if (has_single) family.push_back(thinning_operation(operation, {border, 1}));
    }
  }
  return family;
}

}  // namespace thinbench
