// Circuits that need many values at once, more than any table for which the search was tried.
#include <algorithm>
#include <array>
#include <cstdint>

#include <gtest/gtest.h>

#include "compile/interpreters.hpp"
#include "compile/machine_code.hpp"
#include "compile/slots.hpp"
#include "core/byte_image.hpp"
#include "core/exported.hpp"
#include "harness/splitmix64.hpp"

namespace thinbench::detail {
namespace {

/// Gates of every pair of pixels, all of which are needed before the last of them is read.
GateNetwork wide_circuit() {
  GateNetwork network;
  for (std::uint16_t a = 0; a < kWindowPixels; ++a) {
    for (std::uint16_t b = 0; b < kWindowPixels; ++b) {
      if (a == b) continue;
      network.gates.push_back({a < b ? kOr : kAndNot, {a, b, b}});
      network.gates.push_back({a < b ? kXor : kAnd, {a, b, b}});
    }
  }
  const auto first = static_cast<std::uint16_t>(kWindowPixels);
  const auto wide = static_cast<std::uint16_t>(first + network.gates.size());
  std::uint16_t sum = first;
  for (auto value = static_cast<std::uint16_t>(first + 1); value < wide; ++value) {
    const std::uint8_t function = value % 3 == 0 ? kOr : kXor;
    network.gates.push_back({function, {sum, value, value}});
    sum = static_cast<std::uint16_t>(first + network.gates.size() - 1);
  }
  network.output = sum;
  return network;
}

/// Lanes of 64 columns, one image in each; rows 0 and kRows + 1 are around it.
constexpr Index kRows = 21;

struct LanesImage {
  Index elements;
  AlignedArray<std::uint64_t> words =
      make_aligned<std::uint64_t>(static_cast<std::size_t>(elements * (kRows + 2)));

  [[nodiscard]] std::uint64_t* row(Index y) const { return words.get() + (y + 1) * elements; }
  [[nodiscard]] std::size_t pixel(Index lane, Index x, Index y) const {
    return x < 0 || x > 63 ? 0 : row(y)[lane] >> x & 1;
  }
  [[nodiscard]] std::size_t window(Index lane, Index x, Index y) const {
    std::size_t bits = 0;
    for (Index i = 0; i < 9; ++i) bits |= pixel(lane, x + i % 3 - 1, y + i / 3 - 1) << i;
    return bits;
  }
};

TEST(WideCircuits, are_interpreted_with_slots_on_the_heap) {
  const SlotNetwork circuit = with_slots(wide_circuit());
  ASSERT_GT(circuit.slots, kMaxSlotsOnStack);
  const WindowTable expected =
      tables_of(wide_circuit())[static_cast<std::size_t>(wide_circuit().output)];
  for (const Isa isa : all_isas()) {
    if (!isa_available(isa)) continue;
    const Interpreters& interpreters = kernels_of<Interpreters>(isa);
    const LanesImage before = {interpreters.register_elements};
    const LanesImage after = {interpreters.register_elements};
    for (Index y = 0; y < kRows; ++y) {
      for (Index lane = 0; lane < before.elements; ++lane) {
        before.row(y)[lane] =
            splitmix64(static_cast<std::uint64_t>(y), static_cast<unsigned>(lane));
      }
      std::copy_n(before.row(y), before.elements, after.row(y));
    }
    const Index stride = 8 * before.elements;
    interpreters.by_layout[static_cast<std::size_t>(Layout::lanes_64)](
        &circuit, {after.row(0), stride, after.row(0), stride, kRows, kRows, nullptr});
    for (Index y = 0; y < kRows; ++y) {
      for (Index lane = 0; lane < before.elements; ++lane) {
        for (Index x = 0; x < 64; ++x) {
          ASSERT_EQ(after.pixel(lane, x, y) != 0, expected[before.window(lane, x, y)])
              << isa_name(isa) << ": lane " << lane << ", " << x << ", " << y;
        }
      }
    }
  }
}

TEST(WideCircuits, have_no_machine_code_as_its_frame_is_not_probed) {
  if (!MachineCode::is_available(Isa::avx2)) GTEST_SKIP() << "no machine code here";
  EXPECT_EQ(MachineCode::make(wide_circuit(), Isa::avx2, Layout::words, false), nullptr);
}

TEST(MachineCode, begins_with_the_instruction_that_marks_targets_of_indirect_calls) {
  if (!MachineCode::is_available(Isa::avx2)) GTEST_SKIP() << "no machine code here";
  const GateNetwork identity = {.gates = {}, .output = WindowTable::kCentre};
  const auto code = MachineCode::make(identity, Isa::avx2, Layout::words, false);
  const auto* const bytes = static_cast<const std::uint8_t*>(code->scan().program);
  constexpr std::array<std::uint8_t, 4> endbr64 = {0xF3, 0x0F, 0x1E, 0xFA};
  EXPECT_TRUE(std::equal(endbr64.begin(), endbr64.end(), bytes));
}

}  // namespace
}  // namespace thinbench::detail
