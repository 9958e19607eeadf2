#include <array>
#include <utility>

#include "harness/library_operation.hpp"
#include "harness/splitmix64.hpp"
#include "reference.hpp"

namespace thinbench {
namespace {

using Tables = std::vector<WindowTable>;

struct CustomCase {
  std::string_view name;
  std::string_view description;
  std::string_view rule;  // whose tables are taken; empty for a random table
  int max_iterations;
};

constexpr std::array kCases = {
    CustomCase{"apply_naccache_shinghal", "thin_naccache_shinghal given as a table",
               "naccache_shinghal", kUnlimited},
    CustomCase{"apply_zhang_suen", "thin_zhang_suen given as tables", "zhang_suen", kUnlimited},
    CustomCase{"apply_guo_hall", "thin_guo_hall given as tables", "guo_hall", kUnlimited},
    CustomCase{"apply_zhang_suen_skimage", "thin_zhang_suen_skimage given as tables",
               "zhang_suen_skimage", kUnlimited},
    CustomCase{"apply_life", "Conway's game of life, 100 generations", "life", 100},
    CustomCase{"apply_random", "a random table of 512 bits, 20 iterations", "", 20},
};

Tables tables_of(const CustomCase& custom) {
  if (!custom.rule.empty()) {
    const Rule rule = Rule::named(custom.rule);
    return {rule.sub_iterations().begin(), rule.sub_iterations().end()};
  }
  WindowTable table;
  for (std::size_t w = 0; w < table.words.size(); ++w) table.words[w] = splitmix64(1, w);
  return {table};
}

/// Compiled when first needed: a thorough search takes a second.
const Rule& rule_of(std::size_t index) {
  static std::array<std::optional<Rule>, kCases.size()> rules;
  if (!rules[index]) {
    const CustomCase& custom = kCases[index];
    rules[index].emplace(tables_of(custom),
                         RuleOptions{.max_iterations = custom.max_iterations, .optimise = true});
  }
  return *rules[index];
}

Operation operation_of_case(std::size_t index) {
  const CustomCase& custom = kCases[index];
  const Tables tables = tables_of(custom);
  Operation operation = {
      std::string(custom.name),
      custom.description,
      InputKind::binary,
      {},
      counting_job_maker(
          [tables, limit = custom.max_iterations](const auto& input, const auto& output) {
            return reference::apply_tables(tables, {Border::background, limit}, input, output);
          })};
  const Rule one_iteration(tables, {.max_iterations = 1});
  add_variants(operation, detail::study::all_variants(*detail::body_of(one_iteration)),
               [index](const auto& variant, Index width, Index height, int threads) {
                 const auto parameters = detail::thinning_parameters(rule_of(index), {});
                 return thinning_job(make_state(variant, width, height, parameters, threads));
               });
  for (Variant& variant : operation.variants) variant.has_kernel_scope = true;
  operation.counts_iterations = true;
  operation.operation = custom.name;
  operation.border = Border::background;
  if (custom.max_iterations != kUnlimited) operation.max_iterations = custom.max_iterations;
  operation.small_sets_only = true;
  operation.timed = false;
  return operation;
}

}  // namespace

std::vector<Operation> custom_family() {
  std::vector<Operation> family;
  for (std::size_t i = 0; i < kCases.size(); ++i) family.push_back(operation_of_case(i));
  return family;
}

}  // namespace thinbench
