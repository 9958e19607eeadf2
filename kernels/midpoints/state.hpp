// The memory of the scanning skeleton on packed words.
#pragma once

#include <array>
#include <vector>

#include "image/thread_team.hpp"
#include "midpoints/work.hpp"
#include "thinning/iteration/plane_state.hpp"

namespace thinbench::detail {

/// Sheets for the chosen directions and no more. Threads share groups of rows and batches of
/// columns.
class ScanState final : public PlaneState<std::uint64_t> {
 public:
  ScanState(const ScanKernels& kernels, const ThinningSetting& setting);
  int thin() override;

 private:
  struct Task {
    Direction direction;
    Index first_word;
  };
  using Words = AlignedArray<std::uint64_t>;

  void turn(Direction direction, Index rows, Index words, Index longest);
  [[nodiscard]] Sheet make_sheet(Index rows, Index words);
  [[nodiscard]] std::uint64_t* make_words(Index count);
  void add_direction(Direction direction, const ThinningSetting& setting);

  const ScanKernels& kernels_;
  ScanWork work_;
  Border border_;
  std::vector<Words> memory_;
  std::vector<Task> tasks_;
};

/// With the border kept, the outermost pixels of `target` become those of `source`.
template <class T>
void apply_border(Border border, const ConstPlaneView<T>& source, const PlaneView<T>& target);

}  // namespace thinbench::detail
