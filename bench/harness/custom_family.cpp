#include <array>
#include <utility>

#include "harness/families.hpp"
#include "harness/splitmix64.hpp"
#include "reference.hpp"
#include "rules/rule_table.hpp"
#include "techniques/variants.hpp"
#include "thinbench/named_rules.hpp"

namespace thinbench {
namespace {

using Tables = std::vector<WindowTable>;

/// A built-in rule as tables.
template <class Rule>
Tables tables_of() {
  Tables tables;
  [&]<int... subs>(std::integer_sequence<int, subs...>) {
    (tables.push_back(detail::make_window_table_of<Rule, subs>()), ...);
  }
  (std::make_integer_sequence<int, Rule::kSubIterations>{});
  return tables;
}

Tables random_tables() {
  WindowTable table;
  for (std::size_t w = 0; w < table.words.size(); ++w) table.words[w] = splitmix64(1, w);
  return {table};
}

struct CustomCase {
  std::string_view name;
  std::string_view description;
  Tables (*tables)();
  int max_iterations;
};

constexpr std::array kCases = {
    CustomCase{"apply_naccache_shinghal", "thin_naccache_shinghal given as a table",
               &tables_of<detail::NaccacheShinghal>, kUnlimited},
    CustomCase{"apply_zhang_suen", "thin_zhang_suen given as tables", &tables_of<detail::ZhangSuen>,
               kUnlimited},
    CustomCase{"apply_guo_hall", "thin_guo_hall given as tables", &tables_of<detail::GuoHall>,
               kUnlimited},
    CustomCase{"apply_zhang_suen_skimage", "thin_zhang_suen_skimage given as tables",
               &tables_of<detail::ZhangSuenSkimage>, kUnlimited},
    CustomCase{"apply_life", "Conway's game of life, 100 generations",
               [] {
                 const auto life = find_named_rule("life")->sub_iterations;
                 return Tables(life.begin(), life.end());
               },
               100},
    CustomCase{"apply_random", "a random table of 512 bits, 20 iterations", &random_tables, 20},
};

/// Compiled when first needed: a thorough search takes a second.
const Rule& rule_of(std::size_t index) {
  static std::array<std::optional<Rule>, kCases.size()> rules;
  if (!rules[index]) {
    const CustomCase& custom = kCases[index];
    rules[index].emplace(custom.tables(),
                         RuleOptions{.max_iterations = custom.max_iterations, .optimise = true});
  }
  return *rules[index];
}

Operation operation_of_case(std::size_t index) {
  const CustomCase& custom = kCases[index];
  Operation operation = {std::string(custom.name), custom.description, InputKind::binary, {}, {}};
  const bool adds_pixels = custom.max_iterations != kUnlimited;
  const auto variants =
      detail::study::all_variants(*detail::body_of(Rule(custom.tables(), {.max_iterations = 1})));
  for (const detail::ThinningVariant& variant : variants) {
    operation.variants.push_back(
        library_variant(variant, true, [index, variant](Index width, Index height, int threads) {
          const auto parameters = detail::thinning_parameters(rule_of(index), {});
          return thinning_job(detail::make_state(variant, width, height, parameters, threads));
        }));
  }
  operation.reference = [index](Index, Index, int) {
    const CustomCase& custom_case = kCases[index];
    return counting_job([tables = custom_case.tables(), limit = custom_case.max_iterations](
                            const ConstImageView& input, const ImageView& output) {
      return reference::apply_tables(tables, {Border::background, limit}, input, output);
    });
  };
  operation.counter = "iterations";
  operation.operation = custom.name;
  operation.border = Border::background;
  if (adds_pixels) operation.max_iterations = custom.max_iterations;
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
