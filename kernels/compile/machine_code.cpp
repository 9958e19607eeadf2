#include "compile/machine_code.hpp"

#include "compile/emitter.hpp"
#include "core/features.hpp"

#ifdef THINBENCH_WITH_XBYAK

#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

#include <sys/mman.h>

namespace thinbench::detail {
namespace {

bool is_allowed() {
  static const bool allowed = [] {
    const char* const value = std::getenv(kMachineCodeVariable);
    return value == nullptr || std::string_view(value) != "off";
  }();
  return allowed;
}

}  // namespace

std::shared_ptr<const MachineCode> MachineCode::make(const GateNetwork& network, Isa isa,
                                                     Layout layout, bool fixed) {
  if (!is_allowed() || !has(isa, feature("avx2"))) return nullptr;
  if (layout == Layout::row && !has(isa, feature("avx512f"))) return nullptr;
  std::vector<std::uint8_t> buffer(Emitter::kMaxCodeBytes);
  const Emitter emitter(network, isa, layout, fixed, buffer.data());
  // The code does not probe its frame: a larger one could reach beyond a guard page.
  if (emitter.frame_bytes() > kMaxFrameBytes) return nullptr;
  const std::size_t bytes = emitter.bytes();
  const std::shared_ptr<MachineCode> code(new MachineCode);
  void* const memory =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return nullptr;
  code->memory_ = memory;
  code->bytes_ = bytes;
  std::memcpy(memory, buffer.data(), bytes);
  if (mprotect(memory, bytes, PROT_READ | PROT_EXEC) != 0) return nullptr;
  return code;
}

bool MachineCode::is_available(Isa isa) {
  static const bool available = [] {
    const GateNetwork identity = {.gates = {}, .output = WindowTable::kCentre};
    return make(identity, Isa::avx2, Layout::words, false) != nullptr;
  }();
  return available && has(isa, feature("avx2"));
}

MachineCode::~MachineCode() {
  if (memory_ != nullptr) munmap(memory_, bytes_);
}

ScanFunction MachineCode::function() const {
  return reinterpret_cast<ScanFunction>(memory_);
}

}  // namespace thinbench::detail

#else

namespace thinbench::detail {

std::shared_ptr<const MachineCode> MachineCode::make(const GateNetwork&, Isa, Layout, bool) {
  return nullptr;
}
bool MachineCode::is_available(Isa) {
  return false;
}
MachineCode::~MachineCode() = default;
ScanFunction MachineCode::function() const {
  return nullptr;
}

}  // namespace thinbench::detail

#endif
