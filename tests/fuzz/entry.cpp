// Where libFuzzer begins.
#include "byte_source.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  thinbench::ByteSource input(data, size);
  thinbench::try_input(input);
  return 0;
}
