// Files that earlier runs left: counts, which are compared with themselves, and checkpoints.
#include <stdexcept>

#include "counts/comparison.hpp"
#include "memory_file.hpp"
#include "out_of_core/checkpoint.hpp"

namespace thinbench {
namespace {

void read_counts_file(const std::string& path) {
  const nlohmann::json counts = read_counts(path);
  const Comparison comparison = compare(counts, counts);
  must(!comparison.fails() && !to_text(comparison).empty(), "counts differ from themselves");
}

template <class Read>
void must_read_or_explain(const Read& read) {
  try {
    read();
  } catch (const std::runtime_error& error) {
    must_be_one_line(error.what());
  }
}

}  // namespace
}  // namespace thinbench

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace thinbench;
  static const MemoryFile file;
  file.hold({data, size});
  must_read_or_explain([] { read_counts_file(file.path()); });
  must_read_or_explain([] { static_cast<void>(load_checkpoint(file.path(), "run", 4)); });
  return 0;
}
