// The C interface of rules.
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include "api/c_arguments.hpp"
#include "thinbench/named_rules.hpp"
#include "thinbench/rule.hpp"
#include "thinbench/rule_notation.hpp"

static_assert(sizeof(thinbench::WindowTable) == THINBENCH_TABLE_WORDS * sizeof(uint64_t));

struct thinbench_rule {
  thinbench::Rule rule;
};

namespace {

using namespace thinbench;
using namespace thinbench::detail;

// In the order of the enumerations, and of the constants.
constexpr std::string_view kWindowOrderNames[] = {"raster", "matlab", "octave"};
constexpr std::string_view kActivationNames[] = {"sigmoid", "linear"};
constexpr std::string_view kNeighbourOrderNames[] = {"descriptor", "clockwise", "raster"};
constexpr NeighbourOrder kNeighbourOrders[] = {kDescriptorOrder, kClockwiseOrder, kRasterOrder};

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
  std::vector<std::string> list;
  for (const char* const pattern : span_of<const char*>(patterns, count, "patterns")) {
    require_pointer(pattern, "a pattern");
    list.emplace_back(pattern);
  }
  return list;
}

std::vector<WindowTable> tables_of(const uint64_t* words, size_t count) {
  require(1 <= count && count <= Rule::kMaxSubIterations,
          "sub_iterations: expected 1 to " + std::to_string(Rule::kMaxSubIterations) + ", got " +
              std::to_string(count));
  require_pointer(words, "tables");
  std::vector<WindowTable> tables(count);
  for (size_t i = 0; i < count; ++i) {
    std::memcpy(&tables[i].words, words + i * THINBENCH_TABLE_WORDS, sizeof(tables[i].words));
  }
  return tables;
}

Neuron neuron_of(const float* weights) {
  Neuron neuron;
  std::copy_n(weights, kNetInputs, neuron.weight);
  neuron.bias = weights[kNetInputs];
  return neuron;
}

TwoLayerWeights two_layer_weights(const float* weights) {
  TwoLayerWeights net;
  for (Neuron& hidden : net.hidden) {
    hidden = neuron_of(weights);
    weights += kNetInputs + 1;
  }
  net.output = neuron_of(weights);
  return net;
}

ClusterWeights cluster_weights(const int32_t* last, const float* weights, size_t count) {
  require(1 <= count && count <= kMaxClusterNets, "count: expected an integer in [1, " +
                                                      std::to_string(kMaxClusterNets) + "], got " +
                                                      std::to_string(count));
  ClusterWeights cluster = {static_cast<int>(count), {}};
  for (size_t i = 0; i < count; ++i) {
    cluster.nets[i] = {last[i], neuron_of(weights + i * (kNetInputs + 1))};
  }
  return cluster;
}

/// What is listed of built-in and named rules, also after the rule's end.
void set_texts(std::string_view name, thinbench_rule_info& info) {
  if (const auto built_in = rule_from_name(name)) {
    info.built_in = 1;
    info.name = rule_info(*built_in).name.data();
    info.description = rule_info(*built_in).description.data();
  } else if (const NamedRule* const found = find_named_rule(name)) {
    info.name = found->name.data();
    info.description = found->description.data();
    info.source = found->source.data();
  }
}

}  // namespace

namespace thinbench::detail {

const Rule& rule_of(const thinbench_rule* handle) {
  require_pointer(handle, "rule");
  return handle->rule;
}

}  // namespace thinbench::detail

thinbench_status thinbench_rule_named(const char* name, thinbench_rule** rule) {
  return give(rule, "rule", [&] {
    require_pointer(name, "name");
    return Rule::named(name);
  });
}

thinbench_status thinbench_rule_from_tables(const uint64_t* tables, size_t sub_iterations,
                                            const thinbench_thinning* defaults, int32_t optimise,
                                            thinbench_rule** rule) {
  return give(rule, "rule", [&] {
    const Thinning given = thinning_of(defaults);
    return Rule(tables_of(tables, sub_iterations),
                {given.border.value_or(Border::background),
                 given.max_iterations.value_or(kUnlimited), optimise != 0});
  });
}

thinbench_status thinbench_rule_from_two_layer_net(const float* weights, const char* activation,
                                                   thinbench_rule** rule) {
  return give(rule, "rule", [&] {
    require_pointer(weights, "weights");
    return Rule::from_net(two_layer_weights(weights),
                          enumerator<Activation>("activation", activation, kActivationNames));
  });
}

thinbench_status thinbench_rule_from_cluster(const int32_t* last, const float* weights,
                                             size_t count, thinbench_rule** rule) {
  return give(rule, "rule", [&] {
    require_pointer(last, "last");
    require_pointer(weights, "weights");
    return Rule::from_net(cluster_weights(last, weights, count));
  });
}

void thinbench_rule_destroy(thinbench_rule* rule) {
  delete rule;
}

thinbench_status thinbench_rule_describe(const thinbench_rule* rule, thinbench_rule_info* info) {
  return guarded([&] {
    require_pointer(info, "info");
    const Rule& described = rule_of(rule);
    auto found = fresh(info, thinbench_rule_info THINBENCH_RULE_INFO_INIT, "info");
    found.name = described.name().data();
    set_texts(described.name(), found);
    const auto tables = described.sub_iterations();
    if (!tables.empty()) found.tables = tables.front().words.data();
    found.sub_iterations = tables.size();
    found.border = border_name(described.border()).data();
    found.max_iterations = described.max_iterations();
    found.reach = described.reach();
    give_known(found, info);
  });
}

thinbench_status thinbench_rule_gates(const thinbench_rule* rule, size_t sub_iteration,
                                      int32_t* gates) {
  return guarded([&] {
    require_pointer(gates, "gates");
    *gates = rule_of(rule).gates(sub_iteration);
  });
}

const char* thinbench_rule_name(size_t index) {
  if (index < kRules.size()) return kRules[index].name.data();
  return name_at(named_rules(), index - kRules.size());
}

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
                             enumerator<WindowOrder>("order", order, kWindowOrderNames));
  });
}

thinbench_status thinbench_table_from_removals(const uint8_t* removed, const char* order,
                                               uint64_t* table) {
  return give_table(table, [&] {
    require_pointer(removed, "removed");
    return table_from_removals({removed, 256},
                               kNeighbourOrders[index_of("order", order, kNeighbourOrderNames)]);
  });
}
