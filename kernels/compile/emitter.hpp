// Emits the machine code of a scan function.
#pragma once

#ifdef THINBENCH_WITH_XBYAK

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <xbyak/xbyak.h>

#include "compile/gate_network.hpp"
#include "scan/bound_rule.hpp"
#include "thinbench/isa.hpp"

namespace thinbench::detail {

/// The code of one scan function, in a buffer of kMaxCodeBytes bytes. It does not depend on its
/// address.
///
/// It keeps three rows, each with its west and east neighbours, as the C++ kernels do. The loop is
/// unrolled three times, so that rows change roles instead of places; the few rows of a tile have
/// no loop. With 32 registers the rows are in registers; with 16 they are on the stack, and
/// registers hold what is needed next.
class Emitter : private Xbyak::CodeGenerator {
 public:
  static constexpr std::size_t kMaxCodeBytes = 256 * 1024;

  Emitter(const GateNetwork& network, Isa isa, Layout layout, bool fixed, std::uint8_t* buffer);
  [[nodiscard]] std::size_t bytes() const { return getSize(); }
  /// What the function takes of the stack.
  [[nodiscard]] std::size_t frame_bytes() const {
    return static_cast<std::size_t>(spills_) * (wide_ ? 64 : 32);
  }

 private:
  static constexpr int kNowhere = -1;

  using Vector = Xbyak::Xmm;  // of any width

  /// Where a value is: in a register, on the stack, or both.
  struct Place {
    int reg = kNowhere;
    int stack = kNowhere;
  };
  /// West, centre and east pixels, then functions.
  using RowPlaces = std::vector<Place>;
  /// A gate of one row that the network has for several rows. It is computed once per row. Inputs 0
  /// to 2 are pixels, 3 + i is function i.
  using RowFunction = Gate;
  /// A gate that a function replaces.
  struct Use {
    int function = kNowhere;
    std::size_t row = 0;
  };

  [[nodiscard]] std::optional<RowFunction> row_function_of(const Gate& gate,
                                                           std::size_t& row) const;
  void find_row_functions();
  void choose_row_functions(const std::vector<RowFunction>& functions,
                            const std::vector<unsigned>& rows_with);
  void divide_registers();
  void emit_row_functions(const std::vector<int>& registers);
  void emit_function();
  void emit_row(std::size_t turn);
  void emit_gates();
  void emit_tile();
  void load_tile_row(int y, const std::array<int, 3>& registers);
  void load_tile_register(const Vector& to, int y, int column);
  void emit_band_end(std::size_t turn);
  void load_row(RowPlaces& row, const Xbyak::RegExp& at);
  void emit_neighbours(const Vector& west, const Vector& centre, const Vector& east,
                       const Xbyak::RegExp& at);
  template <int bits>
  void combine_neighbours(const Vector& west, const Vector& centre, const Vector& east);
  void emit_return();
  void emit_ternary(std::size_t index);
  void emit_binary(std::size_t index);
  void apply(std::uint8_t function, const Vector& to, const Vector& first, const Vector& second);
  void emit_output(const Xbyak::Address& target);

  // Registers during a row.
  void begin_row(std::size_t turn);
  int take_register(std::array<int, 3> pinned);
  int in_register(int value, std::array<int, 3> pinned);
  int result_register(int value, std::array<int, 3> pinned);
  void finish_gate(std::size_t index, int reg);
  [[nodiscard]] bool in_pool(int reg) const;
  [[nodiscard]] bool is_last_use(int value) const;
  [[nodiscard]] std::size_t next_use(int value, std::size_t from) const;
  [[nodiscard]] Place& place_of(int value) { return places_[static_cast<std::size_t>(value)]; }

  [[nodiscard]] Vector vector(int number) const;
  [[nodiscard]] Xbyak::Address stack(int place) const;
  void load(const Vector& to, const Xbyak::Address& from);
  void store(const Xbyak::Address& to, const Vector& from);
  void copy(int to, const Place& from);
  void clear(const Vector& to);

  const GateNetwork& network_;
  const Layout layout_;
  const bool has_fixed_;
  const bool wide_;    // 32 registers of 512 bits with vpternlog, else 16 of 256 bits
  const bool funnel_;  // has shifts of two registers

  // Registers with one purpose; the others are the pool, for values.
  int changed_ = kNowhere;
  int fixed_ = kNowhere;
  int zero_ = kNowhere;
  int scratch_ = kNowhere;
  std::vector<int> pool_;
  std::vector<RowFunction> row_functions_;
  std::vector<Use> row_functions_by_gate_;
  int home_places_ = 0;  // of rows, on the stack
  std::array<RowPlaces, 3> rows_;
  std::vector<std::vector<std::size_t>> uses_;  // of each value: gates, in order
  std::array<Xbyak::Label, 3> row_labels_;

  std::vector<Place> places_;
  std::array<int, 32> holds_{};  // the value in each register of the pool
  std::size_t now_ = 0;          // the gate
  int spills_ = 0;
  std::vector<int> free_spills_;
};

}  // namespace thinbench::detail

#endif
