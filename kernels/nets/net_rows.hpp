// The variants of operations whose rule is a net, and the nets that they use by default.
#pragma once

#include <span>

#include "nets/model.hpp"
#include "thinning/variant.hpp"

namespace thinbench::detail {

enum class NetKind { sigmoid, linear, cluster };

/// All techniques for one kind of net.
[[nodiscard]] std::span<const ThinningVariant> net_rows(NetKind kind);

/// Only those techniques that evaluate the net once for each descriptor, or not at all.
[[nodiscard]] std::span<const ThinningVariant> net_table_rows();

/// Table 1 with equation (1).
[[nodiscard]] const RuleModel& paper_sigmoid_model();
/// Table 1 rounded to integers, with equation (1). Its table is no known rule: what shows the cost
/// of circuits that nobody minimised.
[[nodiscard]] const RuleModel& rounded_sigmoid_model();
/// Table 1 with equation (2).
[[nodiscard]] const RuleModel& paper_linear_model();
/// The twelve nets of trained_cluster.hpp; the paper prints none.
[[nodiscard]] const RuleModel& trained_cluster_model();

}  // namespace thinbench::detail
