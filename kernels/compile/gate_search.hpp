// Finds small circuits for tables.
#pragma once

#include <cstdint>

#include "compile/gate_network.hpp"

namespace thinbench::detail {

/// How much work a search does, in units that take about a nanosecond. It ends after this amount of
/// work, not of time, so that equal tables always get equal circuits.
struct SearchEffort {
  std::int64_t work;

  friend bool operator==(SearchEffort, SearchEffort) = default;
};
inline constexpr SearchEffort kFastSearch = {16'000'000};
inline constexpr SearchEffort kThoroughSearch = {1'100'000'000};

/// A circuit that computes `table`, as cheap as the search could make it.
[[nodiscard]] GateNetwork minimised_network(const WindowTable& table, const GateCosts& costs,
                                            SearchEffort effort);

}  // namespace thinbench::detail
