#include "compile/emitter.hpp"

#ifdef THINBENCH_WITH_XBYAK

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "core/features.hpp"

namespace thinbench::detail {
namespace {

constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();
constexpr auto kCentre = static_cast<int>(WindowTable::kCentre);

/// The truth table with inputs 0 and i exchanged.
std::uint8_t with_exchanged_input(std::uint8_t function, int i) {
  unsigned result = 0;
  for (unsigned row = 0; row < 8; ++row) {
    const unsigned first = 4;
    const unsigned other = 4U >> i;
    unsigned from = row & ~(first | other);
    if ((row & first) != 0) from |= other;
    if ((row & other) != 0) from |= first;
    result |= (static_cast<unsigned>(function) >> from & 1U) << row;
  }
  return static_cast<std::uint8_t>(result);
}

}  // namespace

Emitter::Emitter(const GateNetwork& network, Isa isa, Layout layout, bool fixed,
                 std::uint8_t* buffer)
    : CodeGenerator(kMaxCodeBytes, buffer),
      network_(network),
      layout_(layout),
      has_fixed_(fixed),
      wide_(has(isa, feature("avx512vl"))),
      funnel_(has(isa, feature("avx512vbmi2"))),
      uses_(static_cast<std::size_t>(kWindowPixels) + network.gates.size()),
      places_(uses_.size()) {
  find_row_functions();
  for (std::size_t i = 0; i < network.gates.size(); ++i) {
    if (row_functions_by_gate_[i].function != kNowhere) continue;
    for (const std::uint16_t input : network.gates[i].inputs) {
      if (uses_[input].empty() || uses_[input].back() != i) uses_[input].push_back(i);
    }
  }
  for (const int value : {network.output, kCentre}) {
    uses_[static_cast<std::size_t>(value)].push_back(network.gates.size());
  }
  divide_registers();
  emit_function();
}

/// The function of a row that a gate computes, if it reads pixels of one row alone,
/// directly or through earlier gates. Sets the row.
std::optional<Emitter::RowFunction> Emitter::row_function_of(const Gate& gate,
                                                             std::size_t& row) const {
  RowFunction function = {gate.function, {}};
  std::array<std::size_t, 3> rows{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t value = gate.inputs[k];
    if (value < kWindowPixels) {
      rows[k] = value / 3;
      function.inputs[k] = static_cast<std::uint16_t>(value % 3);
      continue;
    }
    const Use& use = row_functions_by_gate_[value - kWindowPixels];
    if (use.function == kNowhere) return std::nullopt;
    rows[k] = use.row;
    function.inputs[k] = static_cast<std::uint16_t>(use.function + 3);
  }
  if (rows[1] != rows[0] || rows[2] != rows[0]) return std::nullopt;
  row = rows[0];
  return function;
}

/// Finds the functions of rows that several rows need.
void Emitter::find_row_functions() {
  row_functions_by_gate_.resize(network_.gates.size());
  if (layout_ == Layout::tiles && !wide_) return;  // every row loads all that it reads
  std::vector<RowFunction> functions;
  std::vector<unsigned> rows_with;  // by function: a bit per row
  for (std::size_t i = 0; i < network_.gates.size(); ++i) {
    Use& use = row_functions_by_gate_[i];
    const auto function = row_function_of(network_.gates[i], use.row);
    if (!function) continue;
    const auto found = std::find(functions.begin(), functions.end(), *function);
    use.function = static_cast<int>(found - functions.begin());
    if (found == functions.end()) {
      functions.push_back(*function);
      rows_with.push_back(0);
    }
    rows_with[static_cast<std::size_t>(use.function)] |= 1U << use.row;
  }
  choose_row_functions(functions, rows_with);
}

/// Keeps those that several rows need and whose inputs are kept, and renumbers them.
void Emitter::choose_row_functions(const std::vector<RowFunction>& functions,
                                   const std::vector<unsigned>& rows_with) {
  const std::size_t max_functions = wide_ ? 4 : 8;  // each takes three registers if they are wide
  std::vector<int> number(functions.size(), kNowhere);
  for (std::size_t f = 0; f < functions.size() && row_functions_.size() < max_functions; ++f) {
    if (std::popcount(rows_with[f]) < 2) continue;
    RowFunction function = functions[f];
    bool has_inputs = true;
    for (std::uint16_t& input : function.inputs) {
      if (input < 3) continue;
      const int moved = number[static_cast<std::size_t>(input - 3)];
      has_inputs = has_inputs && moved != kNowhere;
      input = static_cast<std::uint16_t>(moved + 3);
    }
    if (!has_inputs) continue;
    number[f] = static_cast<int>(row_functions_.size());
    row_functions_.push_back(function);
  }
  for (Use& use : row_functions_by_gate_) {
    if (use.function != kNowhere) use.function = number[static_cast<std::size_t>(use.function)];
  }
}

void Emitter::divide_registers() {
  int next = 0;
  changed_ = next++;
  scratch_ = next++;
  if (has_fixed_) fixed_ = next++;
  if (layout_ == Layout::row) zero_ = next++;
  for (RowPlaces& row : rows_) {
    row.resize(3 + row_functions_.size());
    for (Place& place : row) {
      if (wide_) {
        place.reg = next++;
      } else if (layout_ != Layout::tiles) {
        place.stack = spills_++;
      }
    }
  }
  home_places_ = spills_;
  while (next < (wide_ ? 32 : 16)) pool_.push_back(next++);
}

Emitter::Vector Emitter::vector(int number) const {
  if (wide_) return Xbyak::Zmm(number);
  return Xbyak::Ymm(number);
}

Xbyak::Address Emitter::stack(int place) const {
  return ptr[rsp + static_cast<std::size_t>(place) * (wide_ ? 64 : 32)];
}

void Emitter::load(const Vector& to, const Xbyak::Address& from) {
  wide_ ? vmovdqu64(to, from) : vmovdqu(to, from);
}

void Emitter::store(const Xbyak::Address& to, const Vector& from) {
  wide_ ? vmovdqu64(to, from) : vmovdqu(to, from);
}

void Emitter::copy(int to, const Place& from) {
  if (from.reg == kNowhere) return load(vector(to), stack(from.stack));
  wide_ ? vmovdqa64(vector(to), vector(from.reg)) : vmovdqa(vector(to), vector(from.reg));
}

void Emitter::clear(const Vector& to) {
  wide_ ? vpxorq(to, to, to) : vpxor(to, to, to);
}

// --- Registers ---

std::size_t Emitter::next_use(int value, std::size_t from) const {
  const auto& uses = uses_[static_cast<std::size_t>(value)];
  const auto use = std::lower_bound(uses.begin(), uses.end(), from);
  return use == uses.end() ? kNever : *use;
}

bool Emitter::in_pool(int reg) const {
  return reg != kNowhere && reg >= pool_.front();
}

bool Emitter::is_last_use(int value) const {
  return next_use(value, now_ + 1) == kNever;
}

void Emitter::begin_row(std::size_t turn) {
  holds_.fill(kNowhere);
  std::fill(places_.begin(), places_.end(), Place{});
  for (std::size_t y = 0; y < 3; ++y) {
    for (std::size_t x = 0; x < 3; ++x) places_[3 * y + x] = rows_[(turn + y + 2) % 3][x];
  }
  for (std::size_t i = 0; i < row_functions_by_gate_.size(); ++i) {
    const Use& use = row_functions_by_gate_[i];
    if (use.function == kNowhere) continue;
    places_[kWindowPixels + i] =
        rows_[(turn + use.row + 2) % 3][3 + static_cast<std::size_t>(use.function)];
  }
  // What the row before left on the stack is no longer needed.
  free_spills_.clear();
  for (int place = spills_ - 1; place >= home_places_; --place) {
    free_spills_.push_back(place);
  }
}

/// A free register of the pool; if there is none, that of the value which is needed last, but not
/// that of a pinned value.
int Emitter::take_register(std::array<int, 3> pinned) {
  int victim = kNowhere;
  std::size_t latest = 0;
  for (const int reg : pool_) {
    const int value = holds_[static_cast<std::size_t>(reg)];
    if (value == kNowhere) return reg;
    if (std::find(pinned.begin(), pinned.end(), value) != pinned.end()) continue;
    const std::size_t use = next_use(value, now_);
    if (victim != kNowhere && use <= latest) continue;
    victim = reg;
    latest = use;
  }
  Place& place = place_of(std::exchange(holds_[static_cast<std::size_t>(victim)], kNowhere));
  place.reg = kNowhere;
  if (place.stack != kNowhere || latest == kNever) return victim;
  if (free_spills_.empty()) free_spills_.push_back(spills_++);
  place.stack = free_spills_.back();
  free_spills_.pop_back();
  store(stack(place.stack), vector(victim));
  return victim;
}

int Emitter::in_register(int value, std::array<int, 3> pinned) {
  Place& place = place_of(value);
  if (place.reg != kNowhere) return place.reg;
  const int reg = take_register(pinned);
  load(vector(reg), stack(place.stack));
  place.reg = reg;
  holds_[static_cast<std::size_t>(reg)] = value;
  return reg;
}

/// A register with the value that the gate may overwrite.
int Emitter::result_register(int value, std::array<int, 3> pinned) {
  if (is_last_use(value) && in_pool(place_of(value).reg)) return place_of(value).reg;
  const Place from = place_of(value);
  const int reg = take_register(pinned);
  copy(reg, from);
  return reg;
}

/// Releases what the gate was the last to read; `reg` has its result.
void Emitter::finish_gate(std::size_t index, int reg) {
  for (const std::uint16_t value : network_.gates[index].inputs) {
    if (!is_last_use(value)) continue;
    Place& place = place_of(value);
    if (in_pool(place.reg)) {
      holds_[static_cast<std::size_t>(place.reg)] = kNowhere;
      place.reg = kNowhere;
    }
    if (place.stack >= home_places_) {
      free_spills_.push_back(std::exchange(place.stack, kNowhere));
    }
  }
  const int result = kWindowPixels + static_cast<int>(index);
  place_of(result).reg = reg;
  holds_[static_cast<std::size_t>(reg)] = result;
}

// --- Instructions ---

/// vpternlog overwrites its first operand, best one that is not needed any more.
void Emitter::emit_ternary(std::size_t index) {
  const Gate& gate = network_.gates[index];
  std::array<int, 3> operands = {gate.inputs[0], gate.inputs[1], gate.inputs[2]};
  std::uint8_t function = gate.function;
  const auto can_overwrite = [&](int value) {
    return is_last_use(value) && in_pool(place_of(value).reg);
  };
  for (int i = 1; i < 3 && !can_overwrite(operands[0]); ++i) {
    const auto other = static_cast<std::size_t>(i);
    if (!can_overwrite(operands[other])) continue;
    std::swap(operands[0], operands[other]);
    function = with_exchanged_input(function, i);
  }
  const int second = in_register(operands[1], operands);
  const int third = in_register(operands[2], operands);
  const int first = result_register(operands[0], operands);
  vpternlogq(vector(first), vector(second), vector(third), function);
  finish_gate(index, first);
}

void Emitter::emit_binary(std::size_t index) {
  const Gate& gate = network_.gates[index];
  const int a = gate.inputs[0];
  const int b = gate.inputs[1];
  const std::array<int, 3> pinned = {a, b, b};
  const int first = in_register(a, pinned);
  const bool reuse = is_last_use(a) && in_pool(first) && gate.function != kNot;
  const int to = reuse ? first : take_register(pinned);
  const Place& place = place_of(b);
  if (place.reg == kNowhere) load(vector(scratch_), stack(place.stack));
  const Vector second = vector(place.reg == kNowhere ? scratch_ : place.reg);
  apply(gate.function, vector(to), vector(first), second);
  finish_gate(index, to);
}

/// The complement is of `first`; then `to` is another register.
void Emitter::apply(std::uint8_t function, const Vector& to, const Vector& first,
                    const Vector& second) {
  switch (function) {
    case kAnd:
      vpand(to, first, second);
      break;
    case kOr:
      vpor(to, first, second);
      break;
    case kAndNot:
      vpandn(to, first, second);
      break;
    case kXor:
      vpxor(to, first, second);
      break;
    case kNot:
      vpcmpeqd(to, to, to);
      vpxor(to, to, first);
      break;
  }
}

/// Restores fixed pixels, stores the row and records changes.
void Emitter::emit_output(const Xbyak::Address& target) {
  const int output = network_.output;
  const std::array<int, 3> pinned = {output, kCentre, output};
  const Vector before = vector(in_register(kCentre, pinned));
  if (wide_) {
    Vector next = vector(in_register(output, pinned));
    if (has_fixed_) {
      vmovdqa64(vector(scratch_), next);
      next = vector(scratch_);
      vpternlogq(next, before, vector(fixed_), 0xD8);  // fixed ? before : next
    }
    store(target, next);
    vpternlogq(vector(changed_), before, next, 0xF6);  // changed | (before ^ next)
    return;
  }
  const Vector next = vector(in_register(output, pinned));
  const Vector difference = vector(scratch_);
  if (!has_fixed_) store(target, next);
  vpxor(difference, next, before);
  if (has_fixed_) {
    vpandn(difference, vector(fixed_), difference);
    vpor(vector(changed_), vector(changed_), difference);
    vpxor(difference, difference, before);
    store(target, difference);
    return;
  }
  vpor(vector(changed_), vector(changed_), difference);
}

// --- Rows ---

void Emitter::emit_neighbours(const Vector& west, const Vector& centre, const Vector& east,
                              const Xbyak::RegExp& at) {
  if (layout_ == Layout::lanes_32 || layout_ == Layout::lanes_64) {
    const bool narrow = layout_ == Layout::lanes_32;
    narrow ? vpslld(west, centre, 1) : vpsllq(west, centre, 1);
    narrow ? vpsrld(east, centre, 1) : vpsrlq(east, centre, 1);
    return;
  }
  if (layout_ == Layout::words) {
    load(west, ptr[at - 8]);
    load(east, ptr[at + 8]);
  } else if (layout_ == Layout::row) {
    valignq(west, centre, vector(zero_), 7);
    valignq(east, vector(zero_), centre, 1);
  } else {
    vpslldq(west, centre, 8);
    vpsrldq(east, centre, 8);
  }
  combine_neighbours<64>(west, centre, east);
}

/// From the registers to the west and to the east of `centre`, in lanes of 32 or 64 bits.
template <int bits>
void Emitter::combine_neighbours(const Vector& west, const Vector& centre, const Vector& east) {
  constexpr bool narrow = bits == 32;
  if (funnel_) {
    narrow ? vpshldd(west, centre, west, 1) : vpshldq(west, centre, west, 1);
    narrow ? vpshrdd(east, centre, east, 1) : vpshrdq(east, centre, east, 1);
    return;
  }
  const Vector shifted = vector(scratch_);
  const auto left = [&](const Vector& to, const Vector& from, std::uint8_t count) {
    narrow ? vpslld(to, from, count) : vpsllq(to, from, count);
  };
  const auto right = [&](const Vector& to, const Vector& from, std::uint8_t count) {
    narrow ? vpsrld(to, from, count) : vpsrlq(to, from, count);
  };
  const auto combine = [&](const Vector& to) {
    wide_ ? vporq(to, to, shifted) : vpor(to, to, shifted);
  };
  right(west, west, bits - 1);
  left(shifted, centre, 1);
  combine(west);
  left(east, east, bits - 1);
  right(shifted, centre, 1);
  combine(east);
}

/// Into the places of a row; without registers of their own, through those of the pool.
void Emitter::load_row(RowPlaces& row, const Xbyak::RegExp& at) {
  std::vector<int> registers;
  for (std::size_t i = 0; i < row.size(); ++i) registers.push_back(wide_ ? row[i].reg : pool_[i]);
  load(vector(registers[1]), ptr[at]);
  emit_neighbours(vector(registers[0]), vector(registers[1]), vector(registers[2]), at);
  emit_row_functions(registers);
  if (wide_) return;
  for (std::size_t i = 0; i < row.size(); ++i) store(stack(row[i].stack), vector(registers[i]));
}

/// `registers`: those of the pixels, then those of the functions.
void Emitter::emit_row_functions(const std::vector<int>& registers) {
  for (std::size_t f = 0; f < row_functions_.size(); ++f) {
    const auto& [a, b, c] = row_functions_[f].inputs;
    const Vector to = vector(registers[3 + f]);
    if (wide_) {
      copy(registers[3 + f], {registers[a], kNowhere});
      vpternlogq(to, vector(registers[b]), vector(registers[c]), row_functions_[f].function);
    } else {
      apply(row_functions_[f].function, to, vector(registers[a]), vector(registers[b]));
    }
  }
}

/// Register `y` of a tile, or of the one `column` tiles to the east; see ColumnScan for those above
/// the first and below the last.
void Emitter::load_tile_register(const Vector& to, int y, int column) {
  const int bytes = wide_ ? 64 : 32;
  constexpr auto registers = static_cast<int>(kScannedRegisters);
  const auto own = [&](int number, int offset) {
    const int displacement = (column * registers + number) * bytes + offset;
    return ptr[r8 + static_cast<std::size_t>(displacement)];
  };
  if (0 <= y && y < registers) return load(to, own(y, 0));
  const bool is_above = y < 0;
  const Vector other = vector(scratch_);
  vpbroadcastd(other, ptr[(is_above ? r9 : r11) + static_cast<std::size_t>(column * 4)]);
  if (wide_) {
    load(to, own(is_above ? registers - 1 : 0, 0));
    is_above ? valignd(to, to, other, 15) : valignd(to, other, to, 1);
  } else {
    load(to, is_above ? own(registers - 1, -4) : own(0, 4));
    vpblendd(to, to, other, is_above ? 0x01 : 0x80);
  }
}

/// Into registers of west, centre and east pixels.
void Emitter::load_tile_row(int y, const std::array<int, 3>& registers) {
  for (std::size_t i = 0; i < registers.size(); ++i) {
    load_tile_register(vector(registers[i]), y, static_cast<int>(i) - 1);
  }
  combine_neighbours<32>(vector(registers[0]), vector(registers[1]), vector(registers[2]));
}

/// r8 is the address of the tile, r9 that of the row above it, r11 of the row below, r10 the
/// target. Without registers of their own, rows are in the pool; there are no places on the stack
/// until the pool is full.
void Emitter::emit_tile() {
  const int bytes = wide_ ? 64 : 32;
  const auto load_wide = [&](int y) {
    const RowPlaces& row = rows_[static_cast<std::size_t>(y + 3) % 3];
    std::vector<int> registers;
    for (const Place& place : row) registers.push_back(place.reg);
    load_tile_row(y, {registers[0], registers[1], registers[2]});
    emit_row_functions(registers);
  };
  if (wide_) {
    load_wide(-1);
    load_wide(0);
  }
  for (int y = 0; y < static_cast<int>(kScannedRegisters); ++y) {
    const auto turn = static_cast<std::size_t>(y) % 3;
    if (wide_) {
      load_wide(y + 1);
      begin_row(turn);
    } else {
      for (std::size_t i = 0; i < kWindowPixels; ++i) {
        rows_[(turn + i / 3 + 2) % 3][i % 3].reg = pool_[i];
      }
      begin_row(turn);
      for (std::size_t row = 0; row < 3; ++row) {
        load_tile_row(y - 1 + static_cast<int>(row),
                      {pool_[3 * row], pool_[3 * row + 1], pool_[3 * row + 2]});
      }
      for (std::size_t i = 0; i < kWindowPixels; ++i) {
        holds_[static_cast<std::size_t>(pool_[i])] = static_cast<int>(i);
      }
    }
    emit_gates();
    emit_output(ptr[r10 + static_cast<std::size_t>(y * bytes)]);
  }
  emit_return();
}

void Emitter::emit_gates() {
  for (now_ = 0; now_ < network_.gates.size(); ++now_) {
    if (row_functions_by_gate_[now_].function != kNowhere) continue;
    wide_ ? emit_ternary(now_) : emit_binary(now_);
  }
}

void Emitter::emit_row(std::size_t turn) {
  L(row_labels_[turn]);
  load_row(rows_[(turn + 1) % 3], r8 + r9);
  begin_row(turn);
  if (!wide_) {
    for (std::size_t i = 0; i < 3; ++i) {  // still in the registers through which they came
      const int value = 6 + static_cast<int>(i);
      place_of(value).reg = pool_[i];
      holds_[static_cast<std::size_t>(pool_[i])] = value;
    }
  }
  emit_gates();
  emit_output(ptr[r10]);
  add(r8, r9);
  add(r10, r11);
  dec(rcx);
  Xbyak::Label same_band;
  jnz(turn == 2 ? row_labels_[0] : same_band, T_NEAR);
  emit_band_end(turn);
  L(same_band);
}

/// Records whether the band changed, then ends, or continues with the next row and band.
void Emitter::emit_band_end(std::size_t turn) {
  Xbyak::Label unchanged;
  Xbyak::Label more;
  const Vector changed = vector(changed_);
  if (wide_) {
    vptestmq(k1, changed, changed);
    kortestb(k1, k1);
  } else {
    vptest(changed, changed);
  }
  jz(unchanged);
  or_(rax, rdi);
  clear(changed);
  L(unchanged);
  add(rdi, rdi);
  test(rdx, rdx);
  jnz(more);
  emit_return();
  L(more);
  mov(rcx, ptr[rsi + offsetof(ColumnScan, band_rows)]);
  cmp(rcx, rdx);
  cmovg(rcx, rdx);
  sub(rdx, rcx);
  jmp(row_labels_[(turn + 1) % 3], T_NEAR);
}

void Emitter::emit_return() {
  vzeroupper();
  leave();
  ret();
}

/// rdi is the program, unused, then the bit of the band; rsi the scan; r8, r9 address and stride of
/// the source, r10, r11 of the target; rcx the rows left in the band, rdx those below it. For tiles
/// see emit_tile().
void Emitter::emit_function() {
  endbr64();  // an indirect call leads here
  push(rbp);
  mov(rbp, rsp);
  constexpr std::uint32_t kUnknown = 1U << 30;  // large, so that the operand takes four bytes
  sub(rsp, kUnknown);
  const std::size_t frame_operand = getSize() - 4;
  and_(rsp, ~std::uint32_t{63});
  mov(r8, ptr[rsi + offsetof(ColumnScan, source)]);
  mov(r9, ptr[rsi + offsetof(ColumnScan, source_stride)]);
  mov(r10, ptr[rsi + offsetof(ColumnScan, target)]);
  mov(r11, ptr[rsi + offsetof(ColumnScan, target_stride)]);
  mov(rdx, ptr[rsi + offsetof(ColumnScan, rows)]);
  mov(rcx, ptr[rsi + offsetof(ColumnScan, band_rows)]);
  cmp(rcx, rdx);
  cmovg(rcx, rdx);
  sub(rdx, rcx);
  if (has_fixed_) {
    mov(rax, ptr[rsi + offsetof(ColumnScan, fixed)]);
    load(vector(fixed_), ptr[rax]);
  }
  if (zero_ != kNowhere) clear(vector(zero_));
  clear(vector(changed_));
  xor_(eax, eax);
  if (layout_ == Layout::tiles) {
    mov(r9, ptr[rsi + offsetof(ColumnScan, above)]);
    mov(r11, ptr[rsi + offsetof(ColumnScan, below)]);
    emit_tile();
  } else {
    mov(edi, 1);
    sub(r8, r9);
    load_row(rows_[2], r8);
    add(r8, r9);
    load_row(rows_[0], r8);
    for (std::size_t turn = 0; turn < 3; ++turn) emit_row(turn);
  }
  rewrite(frame_operand, frame_bytes(), 4);
  ready();
}

}  // namespace thinbench::detail

#endif
