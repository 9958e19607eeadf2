// Compiled without auto-vectorisation, as the other scalar techniques.
#include "custom/scalar_interpreter.hpp"

#include "custom/interpreter.hpp"

namespace thinbench::detail {
namespace {

struct ScalarRows {
  using Word = std::uint64_t;
  static RowTriple<Word> row(const std::uint64_t* at) { return load_row<Word>(at); }
};

}  // namespace

constinit const ScanFunction kScalarInterpreter = &interpret<ScalarRows>;

}  // namespace thinbench::detail
