#include "compile/machine_code.hpp"

#include "compile/emitter.hpp"
#include "core/features.hpp"

#ifdef THINBENCH_WITH_XBYAK

#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

#ifdef _WIN32
#include <windows.h>
#else
#include <sys/mman.h>
#endif

namespace thinbench::detail {
namespace {

bool is_allowed() {
  static const bool allowed = [] {
    const char* const value = std::getenv(kMachineCodeVariable);
    return value == nullptr || std::string_view(value) != "off";
  }();
  return allowed;
}

// Of pages: memory to write to, or nullptr; to execute, if the system allows it; to give back.
#ifdef _WIN32
void* writable_memory(std::size_t bytes) {
  return VirtualAlloc(nullptr, bytes, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE);
}
bool make_executable(void* memory, std::size_t bytes) {
  DWORD before = 0;
  return VirtualProtect(memory, bytes, PAGE_EXECUTE_READ, &before) != 0 &&
         FlushInstructionCache(GetCurrentProcess(), memory, bytes) != 0;
}
void release(void* memory, std::size_t) {
  VirtualFree(memory, 0, MEM_RELEASE);
}

/// A ScanFunction whose program is the code. The code follows the calling convention of System V:
/// it changes registers that functions of Windows preserve.
std::uint64_t call_code(const void* code, const ColumnScan& scan) {
  using Code = std::uint64_t(__attribute__((sysv_abi))*)(const void*, const ColumnScan&);
  return reinterpret_cast<Code>(reinterpret_cast<std::uintptr_t>(code))(nullptr, scan);
}
#else
void* writable_memory(std::size_t bytes) {
  void* const memory =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return memory == MAP_FAILED ? nullptr : memory;
}
bool make_executable(void* memory, std::size_t bytes) {
  return mprotect(memory, bytes, PROT_READ | PROT_EXEC) == 0;
}
void release(void* memory, std::size_t bytes) {
  munmap(memory, bytes);
}
#endif

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
  code->memory_ = writable_memory(bytes);
  if (code->memory_ == nullptr) return nullptr;
  code->bytes_ = bytes;
  std::memcpy(code->memory_, buffer.data(), bytes);
  return make_executable(code->memory_, bytes) ? code : nullptr;
}

bool MachineCode::is_available(Isa isa) {
  static const bool available = [] {
    const GateNetwork identity = {.gates = {}, .output = WindowTable::kCentre};
    return make(identity, Isa::avx2, Layout::words, false) != nullptr;
  }();
  return available && has(isa, feature("avx2"));
}

MachineCode::~MachineCode() {
  if (memory_ != nullptr) release(memory_, bytes_);
}

BoundScan MachineCode::scan() const {
#ifdef _WIN32
  return {&call_code, memory_};
#else
  return {reinterpret_cast<ScanFunction>(memory_), memory_};
#endif
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
BoundScan MachineCode::scan() const {
  return {};
}

}  // namespace thinbench::detail

#endif
