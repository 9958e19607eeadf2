#include "reference.hpp"

#include <array>
#include <utility>

namespace thinbench::reference {

// A rule without a reference does not link.
Thinning thinning(BuiltInRule rule) {
  static constexpr auto kTable = []<std::size_t... i>(std::index_sequence<i...>) {
    return std::array<Thinning, sizeof...(i)>{&thin<kRules[i].rule>...};
  }
  (std::make_index_sequence<kRules.size()>{});
  return kTable.at(static_cast<std::size_t>(rule));
}

}  // namespace thinbench::reference
