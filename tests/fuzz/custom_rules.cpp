// Rules of any tables, compiled, against the reference: every technique on images of any
// size. Compiling takes longest, so a rule is applied several times.

#include "drawn_image.hpp"
#include "reference.hpp"
#include "techniques/variants.hpp"
#include "thinbench/named_rules.hpp"

namespace thinbench {
namespace {

/// Bits of the input, or a named rule with a few bits changed.
WindowTable draw_table(ByteSource& input) {
  WindowTable table;
  if (input.once_in(2)) {
    table = input.pick(named_rules()).sub_iterations.front();
    for (Index flips = input.number(0, 3); flips > 0; --flips) {
      const auto window = static_cast<std::size_t>(input.number(0, 511));
      table.set(window, !table[window]);
    }
    return table;
  }
  for (std::uint64_t& word : table.words) word = input.word();
  return table;
}

/// The table without its pixels that are added, or that are removed.
WindowTable monotone(const WindowTable& table, bool removes) {
  return make_window_table([&](std::size_t window) {
    const bool pixel = (window >> WindowTable::kCentre & 1) != 0;
    return removes ? pixel && table[window] : pixel || table[window];
  });
}

struct DrawnRule {
  std::vector<WindowTable> tables;
  RuleOptions options;
};

DrawnRule draw_rule(ByteSource& input) {
  DrawnRule rule;
  rule.options.border = static_cast<Border>(input.number(0, 2));
  const Index limit = input.number(0, 4);
  const bool removes = input.once_in(2);
  if (limit > 0) rule.options.max_iterations = static_cast<int>(limit);
  for (Index tables = input.number(1, 3); tables > 0; --tables) {
    const WindowTable table = draw_table(input);
    rule.tables.push_back(limit > 0 ? table : monotone(table, removes));
  }
  return rule;
}

void check(ByteSource& input, const DrawnRule& drawn, const Rule& rule) {
  const auto parameters = detail::thinning_parameters(rule, {});
  const auto variants = parameters.complemented ? detail::thinning_variants(*parameters.rule)
                                                : detail::study::all_variants(*parameters.rule);
  const detail::ThinningVariant& variant =
      variants[static_cast<std::size_t>(input.number(0, std::ssize(variants) - 1))];
  const DrawnSize size = draw_size(input);
  const int threads = variant.threaded && input.once_in(32) ? 2 : 1;
  const ByteImage image = draw_binary(input, size);
  if (!unavailable_reason(variant, size.width).empty()) return;
  const auto state = detail::make_state(variant, size.width, size.height, parameters, threads);
  DrawnPair images(input, image.view());
  const int iterations = state->run(images.source.view(), images.to());
  ByteImage expected(size.width, size.height);
  const RuleOptions& options = drawn.options;
  must(iterations == reference::apply_tables(drawn.tables, {options.border, options.max_iterations},
                                             image.view(), expected.view()),
       "other iterations");
  must_be_equal(images.to(), expected.view(), std::string(variant.technique));
  images.must_be_intact();
}

}  // namespace

void try_input(ByteSource& input) {
  const DrawnRule drawn = draw_rule(input);
  const Rule rule(drawn.tables, drawn.options);
  for (int i = 0; i < 20 && !input.is_empty(); ++i) check(input, drawn, rule);
}

}  // namespace thinbench
