// The C interface of rules given as tables.
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include "api/c_arguments.hpp"
#include "thinbench/custom_rule.hpp"
#include "thinbench/named_rules.hpp"
#include "thinbench/rule_notation.hpp"

static_assert(sizeof(thinbench::WindowTable) == THINBENCH_TABLE_WORDS * sizeof(uint64_t));

struct thinbench_custom_rule {
  thinbench::CustomRule rule;
};

namespace {

using namespace thinbench;
using namespace thinbench::detail;

template <class T>
struct NamedValue {
  std::string_view name;
  T value;
};

constexpr NamedValue<WindowOrder> kWindowOrders[] = {{"raster", WindowOrder::raster},
                                                     {"matlab", WindowOrder::matlab},
                                                     {"octave", WindowOrder::octave}};
constexpr NamedValue<NeighbourOrder> kNeighbourOrders[] = {
    {"descriptor", kDescriptorOrder}, {"clockwise", kClockwiseOrder}, {"raster", kRasterOrder}};
constexpr NamedValue<Border> kBorders[] = {{border_name(Border::background), Border::background},
                                           {border_name(Border::keep), Border::keep},
                                           {border_name(Border::foreground), Border::foreground}};

/// The value of this name in a list.
template <class Values>
auto value_named(const char* what, const char* name, const Values& values) {
  std::optional<decltype(values[0].value)> found;
  for (const auto& entry : values) {
    if (entry.name == view_of(name)) found = entry.value;
  }
  return named(what, name, found, [&] { return names_of(values); });
}

/// Hands over the table that `make` returns.
template <class Make>
thinbench_status give_table(uint64_t* table, const Make& make) noexcept {
  return guarded([&] {
    require_pointer(table, "table");
    const WindowTable made = make();
    std::memcpy(table, &made.words, sizeof(made.words));
  });
}

std::vector<std::string> patterns_of(const char* const* patterns, size_t count) {
  if (count > 0) require_pointer(patterns, "patterns");
  std::vector<std::string> list;
  for (size_t i = 0; i < count; ++i) {
    require_pointer(patterns[i], "a pattern");
    list.emplace_back(patterns[i]);
  }
  return list;
}

std::vector<WindowTable> tables_of(const uint64_t* words, size_t count) {
  require(1 <= count && count <= CustomRule::kMaxSubIterations,
          "sub_iterations: expected 1 to " + std::to_string(CustomRule::kMaxSubIterations) +
              ", got " + std::to_string(count));
  require_pointer(words, "tables");
  std::vector<WindowTable> tables(count);
  for (size_t i = 0; i < count; ++i) {
    std::memcpy(&tables[i].words, words + i * THINBENCH_TABLE_WORDS, sizeof(tables[i].words));
  }
  return tables;
}

int limit_of(int32_t max_iterations) {
  require(max_iterations >= 0,
          "max_iterations: expected 0 (unlimited) or more, got " + std::to_string(max_iterations));
  return max_iterations == 0 ? kUnlimited : max_iterations;
}

const CustomRule& rule_of(const thinbench_custom_rule* handle) {
  require_pointer(handle, "rule");
  return handle->rule;
}

const NamedRule& named_rule_of(const char* name) {
  const NamedRule* const found = find_named_rule(view_of(name));
  if (found == nullptr) {
    throw std::invalid_argument("rule: expected one of " + names_of(named_rules()) + "; got " +
                                text_of(name));
  }
  return *found;
}

thinbench_named_rule described(const NamedRule& rule, size_t size) {
  return {size,
          rule.name.data(),
          rule.description.data(),
          rule.source.data(),
          rule.sub_iterations.front().words.data(),
          rule.sub_iterations.size(),
          border_name(rule.border).data(),
          rule.max_iterations == kUnlimited ? 0 : rule.max_iterations};
}

}  // namespace

thinbench_status thinbench_table_from_hensel(const char* notation, uint64_t* table) {
  return give_table(table, [&] {
    require_pointer(notation, "notation");
    return table_from_hensel(notation);
  });
}

thinbench_status thinbench_table_from_patterns(const char* const* patterns, size_t count,
                                               uint64_t* table) {
  return give_table(table, [&] { return table_from_patterns(patterns_of(patterns, count)); });
}

thinbench_status thinbench_table_from_values(const uint8_t* values, const char* order,
                                             uint64_t* table) {
  return give_table(table, [&] {
    require_pointer(values, "values");
    return table_from_values({values, WindowTable::kWindows},
                             value_named("order", order, kWindowOrders));
  });
}

thinbench_status thinbench_table_from_removals(const uint8_t* removed, const char* order,
                                               uint64_t* table) {
  return give_table(table, [&] {
    require_pointer(removed, "removed");
    return table_from_removals({removed, 256}, value_named("order", order, kNeighbourOrders));
  });
}

const char* thinbench_named_rule_name(size_t index) {
  return name_at(named_rules(), index);
}

thinbench_status thinbench_find_named_rule(const char* name, thinbench_named_rule* rule) {
  return guarded([&] {
    constexpr size_t first_version =
        offsetof(thinbench_named_rule, max_iterations) + sizeof(int32_t);
    require_pointer(rule, "rule");
    const size_t size = versioned(rule, first_version, thinbench_named_rule{}, "rule").size;
    const thinbench_named_rule found = described(named_rule_of(name), size);
    std::memcpy(rule, &found, size);
  });
}

thinbench_status thinbench_custom_rule_create(const uint64_t* tables, size_t sub_iterations,
                                              const char* border, int32_t max_iterations,
                                              int32_t optimise, thinbench_custom_rule** rule) {
  return guarded([&] {
    require_pointer(rule, "rule");
    *rule = nullptr;
    *rule = new thinbench_custom_rule{CustomRule(
        tables_of(tables, sub_iterations),
        {value_named("border", border, kBorders), limit_of(max_iterations), optimise != 0})};
  });
}

thinbench_status thinbench_custom_rule_gates(const thinbench_custom_rule* rule,
                                             size_t sub_iteration, int32_t* gates) {
  return guarded([&] {
    require_pointer(gates, "gates");
    *gates = rule_of(rule).gates(sub_iteration);
  });
}

void thinbench_custom_rule_destroy(thinbench_custom_rule* rule) {
  delete rule;
}

thinbench_status thinbench_apply(const thinbench_custom_rule* rule, const thinbench_stack* source,
                                 const thinbench_output* destination,
                                 const thinbench_options* options, int32_t* iterations) {
  return guarded([&] { run_images(rule_of(rule), source, destination, options, iterations); });
}

thinbench_status thinbench_apply_packed(const thinbench_custom_rule* rule,
                                        const thinbench_packed* source, uint8_t* destination,
                                        ptrdiff_t destination_stride,
                                        const thinbench_options* options, int32_t* iterations) {
  return guarded([&] {
    const PackedViews views = packed_views(source, destination, destination_stride);
    const int count = apply(rule_of(rule), views.source, views.destination, options_of(options));
    if (iterations != nullptr) *iterations = count;
  });
}
