#include "thinning/operations.hpp"

#include "core/checks.hpp"
#include "engines/variants.hpp"

namespace thinbench::detail {

const std::vector<ThinningVariant>& thinning_variants(const RuleBody& rule) {
  static const auto& built_in = never_destroyed(parallel_variants(true, false));
  static const auto& removing = never_destroyed(parallel_variants(false, false));
  static const auto& adding = never_destroyed(parallel_variants(false, true));
  if (rule.circuits) return built_in;
  return rule.adds_pixels() ? adding : removing;
}

std::span<const ThinningOperation> thinning_operations() {
  static const auto& all = never_destroyed([] {
    std::vector<ThinningOperation> operations;
    for (const RuleInfo& info : kRules) {
      const Rule rule = info.rule;
      operations.push_back(
          {rule, info.operation, info.description, thinning_variants(*body_of(rule))});
    }
    return operations;
  }());
  return all;
}

ThinningParameters thinning_parameters(const Rule& rule, const Thinning& thinning) {
  const SharedRule& body = body_of(rule);
  const Border border = thinning.border.value_or(body->border);
  const int max_iterations = thinning.max_iterations.value_or(body->max_iterations);
  const std::string& name = body->name;
  require(static_cast<std::size_t>(border) < kBorderNames.size(), [&] {
    return "border: expected background, keep or foreground, got " +
           std::to_string(static_cast<int>(border));
  });
  require(max_iterations >= 1, [&] {
    return "max_iterations: expected an integer of at least 1, got " +
           std::to_string(max_iterations);
  });
  require(max_iterations != kUnlimited || !body->adds_pixels() || !body->removes_pixels(), [&] {
    return name +
           ": this rule adds and removes pixels, so it may never end; it needs a limit "
           "(max_iterations)";
  });
  if (border != Border::foreground) return {body, border, max_iterations, false};
  require(body->complement != nullptr,
          name +
              ": border: expected background or keep, got foreground, which only rules that are "
              "functions of 3 x 3 pixels can have");
  return {body->complement, Border::background, max_iterations, true};
}

std::unique_ptr<ThinningState> make_thinning(const ThinningCall& call, Index width, Index height) {
  const ThinningParameters parameters = thinning_parameters(call.rule, call.thinning);
  return make_best_state(thinning_variants(*parameters.rule), width, height, parameters,
                         call.execution);
}

}  // namespace thinbench::detail
