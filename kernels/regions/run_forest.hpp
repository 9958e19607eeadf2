// Memory for runs as bits.
#pragma once

#include "core/byte_image.hpp"
#include "regions/label_kernels.hpp"

namespace thinbench::detail {

/// Memory for the runs of images of one size. It grows on demand and is reused.
class RunForestMemory {
 public:
  explicit RunForestMemory(Index bands)
      : first_(make_aligned<Label>(static_cast<std::size_t>(bands + 1))), bands_(bands) {}

  [[nodiscard]] Label* first() { return first_.get(); }
  /// Room for the runs that `first` counts; contents are lost.
  RunForest with_room() {
    const Label runs = first_[static_cast<std::size_t>(bands_)];
    if (runs >= capacity_) {
      const std::size_t larger = std::size_t{runs} + runs / 2 + 1;
      capacity_ = 0;  // in case that memory is short
      parents_ = make_aligned<Label>(larger);
      ids_ = make_aligned<Label>(larger + 2 * std::size_t{kRunPadding});
      capacity_ = larger;
    }
    return {parents_.get(), ids_.get() + kRunPadding, first_.get()};
  }

 private:
  AlignedArray<Label> first_;
  AlignedArray<Label> parents_;
  AlignedArray<Label> ids_;
  Index bands_;
  std::size_t capacity_ = 0;
};

}  // namespace thinbench::detail
