// Objects and holes from runs as bits and their contacts: what label images are painted from.
#pragma once

#include <optional>
#include <vector>

#include "core/planes.hpp"
#include "regions/label_kernels.hpp"
#include "thinbench/regions.hpp"

namespace thinbench::detail {

/// Labels alone, labels with the list of objects, and labels of objects and holes with both lists.
enum class LabelTask : std::uint8_t {
  image_eight,
  image_four,
  objects_eight,
  objects_four,
  regions
};

struct LabelParameters {
  LabelTask task;
  LabelOrder order = LabelOrder::pixels;  // of objects, in tasks without holes
};

/// Memory for the runs of images of one size. It grows on demand and is reused.
class RunForestMemory {
 public:
  explicit RunForestMemory(Index bands)
      : first_(make_aligned<Label>(static_cast<std::size_t>(bands + 1))), bands_(bands) {}

  [[nodiscard]] Label* first() { return first_.get(); }
  /// Room for the runs that `first` counts; contents are lost.
  RunForest with_room();

 private:
  AlignedArray<Label> first_;
  AlignedArray<Label> parents_;
  AlignedArray<Label> ids_;
  Index bands_;
  std::size_t capacity_ = 0;
};

/// The runs of the background, which is 4- or 8-connected.
class BackgroundRuns {
 public:
  BackgroundRuns(const HoleKernels& kernels, Index width, Index height)
      : kernels_(kernels), inverted_(width, height), memory_(height) {}

  /// Finds and unites the runs. Valid until the next call.
  Background of(const ConstBitPlaneView& image, Connectivity connectivity);

 private:
  HoleKernels kernels_;
  BitPlane inverted_;
  RunForestMemory memory_;
};

/// Works on images of one size. Memory for runs and regions grows on demand and is reused: 8 bytes
/// per run and, with holes, as many per run of single rows.
class ContactLabeller {
 public:
  ContactLabeller(const LabelParameters& parameters, Isa isa, Index width, Index height);

  /// Finds objects and what else the task asks for. Returns the number of objects; sets the lists
  /// that the task has. The image needs pixels.
  Label find(const ConstBitPlaneView& image, Regions& found);
  /// Paints the image that find() had.
  void paint(const ConstBitPlaneView& image, const LabelView& labels) const;

 private:
  void find_holes(const ConstBitPlaneView& image, Label objects, Regions& found);

  const LabelEngine& engine_;
  const LabelKernels& kernels_;
  LabelParameters parameters_;
  RunForestMemory memory_;
  RunForest runs_ = {};
  // With holes only:
  std::optional<BackgroundRuns> background_runs_;
  Background background_ = {};
  std::vector<Region> regions_;  // outside, objects, holes
  std::vector<Label> ids_;       // of all runs of rows, between kRunPadding elements
};

}  // namespace thinbench::detail
