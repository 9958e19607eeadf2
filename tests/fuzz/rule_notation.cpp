// Hensel's notation, Pillow's patterns and tables in other orders: a table, or one line that says
// what is wrong.
#include "thinbench/rule_notation.hpp"

#include <stdexcept>
#include <vector>

#include "byte_source.hpp"

namespace thinbench {
namespace {

void read_table(ByteSource& input) {
  constexpr std::array orders = {WindowOrder::raster, WindowOrder::matlab, WindowOrder::octave,
                                 static_cast<WindowOrder>(3)};
  constexpr std::array neighbour_orders = {kDescriptorOrder, kClockwiseOrder, kRasterOrder,
                                           NeighbourOrder{0, 1, 2, 3, 4, 5, 6, 9}};
  switch (input.number(0, 3)) {
    case 0:
      static_cast<void>(table_from_hensel(input.rest()));
      break;
    case 1: {
      std::vector<std::string> patterns;
      while (!input.is_empty()) patterns.push_back(input.line());
      static_cast<void>(table_from_patterns(patterns));
      break;
    }
    case 2: {
      const WindowOrder order = input.pick(orders);
      static_cast<void>(table_from_values(input.take(513), order));
      break;
    }
    default: {
      const NeighbourOrder order = input.pick(neighbour_orders);
      static_cast<void>(table_from_removals(input.take(257), order));
    }
  }
}

}  // namespace

void try_input(ByteSource& input) {
  must_succeed_or_explain<std::invalid_argument>([&] { read_table(input); });
}

}  // namespace thinbench
