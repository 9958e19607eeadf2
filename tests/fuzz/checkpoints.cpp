// Checkpoints that earlier runs left.
#include <stdexcept>

#include "memory_file.hpp"
#include "out_of_core/checkpoint.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace thinbench;
  static const MemoryFile file;
  file.hold({data, size});
  try {
    static_cast<void>(load_checkpoint(file.path(), "run", 4));
  } catch (const std::runtime_error& error) {
    must_be_one_line(error.what());
  }
  return 0;
}
