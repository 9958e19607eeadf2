// Objects and holes from runs as bits and their contacts: what label images are painted from.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "core/planes.hpp"
#include "core/thread_team.hpp"
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
  Background of(const ConstBitPlaneView& rows, Connectivity connectivity,
                const StripEnds& ends = {});

 private:
  HoleKernels kernels_;
  BitPlane inverted_;
  RunForestMemory memory_;
};

/// Labels a strip of rows as if it were alone, but that background at its ends is outside only
/// where the image ends, too. Memory for runs grows on demand, by half more than needed, and is
/// reused: 12 bytes per run and, with holes, 20 per run of the background, which is of single rows.
class ContactStrip {
 public:
  ContactStrip(const LabelParameters& parameters, Isa isa, Index width, Index height);

  /// Numbers objects from 1 on, then holes, in the order of the whole image. `rows` needs pixels.
  void find(const ConstBitPlaneView& rows, const StripEnds& ends);
  [[nodiscard]] Label objects() const { return objects_; }
  /// Objects and holes.
  [[nodiscard]] Label labels() const { return labels_; }
  /// Adds all pixels to the regions of the labels, in tasks with lists: label 1 is the first of
  /// those, or with holes the second after what is outside. Rows count from the first of the strip.
  void sum(Region* regions);

  /// Unites the labels of what touches across the seam with the strip above. In `parents` label 0
  /// of each strip is at its offset.
  void join(const ContactStrip& above, Label offset_above, Label offset, Label* parents) const;
  /// Label i becomes numbers[i].
  void renumber(const Label* numbers);
  void paint(const LabelView& labels) const;

 private:
  const LabelEngine& engine_;
  const LabelKernels& kernels_;
  LabelParameters parameters_;
  RunForestMemory memory_;
  ConstBitPlaneView rows_ = {};
  RunForest runs_ = {};
  Label objects_ = 0;
  Label labels_ = 0;
  // With holes only:
  std::optional<BackgroundRuns> background_runs_;
  Background background_ = {};
  std::vector<Label> ids_;  // of all runs of rows, between kRunPadding elements
  Label* ids_end_ = nullptr;
};

/// Labels images of one size. Threads share strips of rows, which are labelled alone and joined at
/// the seams.
class ContactLabeller {
 public:
  /// The team must outlive this.
  ContactLabeller(const LabelParameters& parameters, Isa isa, Index width, Index height,
                  const ThreadTeam& team);

  /// Finds objects and what else the task asks for. Returns the number of objects; sets the lists
  /// that the task has. The image needs pixels, and must remain until it is painted.
  Label find(const ConstBitPlaneView& image, Regions& found);
  /// Paints the image that find() had; once.
  void paint(const LabelView& labels);

 private:
  /// Calls `body(number of the strip)`; threads share the strips.
  template <class Body>
  void for_strips(const Body& body);
  struct Count {
    Label objects;
    Label labels;  // with holes
  };
  Count join_strips();
  Count number_labels();
  /// The sums of all strips, from label 0 of the first on.
  void sum_strips(std::vector<Region>& regions);
  void list_objects(Label objects, std::vector<Region>& regions) const;
  void list_regions(const Count& count, Regions& found) const;

  LabelTask task_;
  const ThreadTeam& team_;
  std::deque<ContactStrip> strips_;
  std::vector<Index> first_rows_;  // of each strip, then the height
  // With several strips: for each label of each strip an earlier one or the same, then its number.
  std::vector<Label> numbers_;
  std::vector<Label> offsets_;   // of each strip's label 0, which is outside
  std::vector<Region> regions_;  // with holes: of all labels
};

}  // namespace thinbench::detail
