// Checkpoints that earlier runs left.
#include <stdexcept>

#include "byte_source.hpp"
#include "memory_file.hpp"
#include "out_of_core/checkpoint.hpp"

namespace thinbench {
namespace {

constexpr CheckpointLimits kLimits{4, 100, 9};

void load(const MemoryFile& file) {
  must_succeed_or_explain<std::runtime_error>([&] {
    const auto found = load_checkpoint(file.path(), "run", kLimits);
    must(found && found->passes >= 1 && found->passes <= kLimits.max_passes &&
             found->foreground_after <= found->foreground_before &&
             found->unsettled.size() == static_cast<std::size_t>(kLimits.tiles),
         "a checkpoint that no run writes is accepted");
  });
}

/// Values of any size, with their checksum.
void save_and_load(const MemoryFile& file, ByteSource input) {
  Checkpoint checkpoint;
  checkpoint.passes = static_cast<int>(input.word());
  checkpoint.foreground_before = static_cast<Index>(input.word());
  checkpoint.foreground_after = static_cast<Index>(input.word());
  checkpoint.unsettled.resize(static_cast<std::size_t>(input.number(0, 6)));
  save_checkpoint(file.path(), "run", checkpoint);
  load(file);
}

}  // namespace

void try_input(ByteSource& input) {
  static const MemoryFile file;
  file.hold(ByteSource(input).take(SIZE_MAX));
  load(file);
  save_and_load(file, input);
}

}  // namespace thinbench
