#include "regions/contact_labeller.hpp"

#include <algorithm>
#include <numeric>

#include "core/exported.hpp"
#include "regions/run_numbers.hpp"

namespace thinbench::detail {
namespace {

constexpr Region kNoPixels = {0, 0, 0, INT32_MAX, 0, -1, 0, 0};

constexpr bool is_four_connected(LabelTask task) {
  return task == LabelTask::image_four || task == LabelTask::objects_four;
}

constexpr BandKind band_of(LabelTask task) {
  return is_four_connected(task) ? BandKind::row : BandKind::pair;
}

/// A band of a strip, the ids of its runs, and the offset of the strip's labels.
struct SeamBand {
  ConstBitPlaneView rows;
  Index number;
  const Label* ids;
  Label offset;
};

SeamBand seam_band(const ConstBitPlaneView& rows, const RunForest& runs, Index number,
                   Label offset) {
  return {rows, number, runs.ids + runs.first[number], offset};
}

/// Unites the labels of runs that touch.
template <BandKind band>
void join_bands(const SeamBand& upper, const SeamBand& lower, Label* parents) {
  BandBits<band> above(upper.rows, upper.number);
  BandBits<band> here(lower.rows, lower.number);
  Contacts<band> contacts;
  Follow in_both;
  const Label* ids_above = upper.ids - 1;  // of the last run before the word
  const Label* ids_here = lower.ids - 1;
  for (Index word = 0; word < words_of(upper.rows); ++word) {
    const std::uint64_t starts_above = above.starts(word);
    const std::uint64_t starts_here = here.starts(word);
    const std::uint64_t all = contacts(above.bottom(word), here.top(word));
    const std::uint64_t distinct = all & ~in_both(all, starts_above | starts_here);
    for (std::uint64_t left = distinct; left != 0; left &= left - 1) {
      const std::uint64_t upto = left ^ (left - 1);
      unite(parents, upper.offset + ids_above[count_bits(starts_above & upto)],
            lower.offset + ids_here[count_bits(starts_here & upto)]);
    }
    ids_above += count_bits(starts_above);
    ids_here += count_bits(starts_here);
  }
}

void move_down(Region& region, Index rows) {
  const auto distance = static_cast<std::int32_t>(rows);
  region.sum_y += rows * region.area;
  region.top += distance;
  region.bottom += distance;
}

/// Appends a region, or adds to it where it is in the list.
void add_to_list(std::vector<Region>& regions, Label index, const Region& part) {
  if (index == regions.size()) {
    regions.push_back(part);
  } else {
    add_region(regions[index], part);
  }
}

}  // namespace

RunForest RunForestMemory::with_room() {
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

Background BackgroundRuns::of(const ConstBitPlaneView& rows, Connectivity connectivity,
                              const StripEnds& ends) {
  kernels_.invert(rows, inverted_.view());
  kernels_.count(inverted_.view(), memory_.first());
  const Background background = {inverted_.view(), memory_.with_room(), ends};
  const bool with_corners = connectivity == Connectivity::eight;
  (with_corners ? kernels_.unite_with_corners : kernels_.unite)(background);
  return background;
}

ContactStrip::ContactStrip(const LabelParameters& parameters, Isa isa, Index width, Index height)
    : engine_(kernels_of<LabelEngine>(isa)),
      kernels_(is_four_connected(parameters.task) ? engine_.four : engine_.eight),
      parameters_(parameters),
      memory_(bands_of(band_of(parameters.task), height)) {
  if (parameters.task == LabelTask::regions) background_runs_.emplace(engine_.holes, width, height);
}

void ContactStrip::find(const ConstBitPlaneView& rows, const StripEnds& ends) {
  rows_ = rows;
  kernels_.count(rows, memory_.first());
  runs_ = memory_.with_room();
  kernels_.unite(rows, runs_);
  const Label count = runs_.first[bands_of(band_of(parameters_.task), rows.height)];
  // OpenCV's blocks: no two runs of a pair of rows share one, so they are in the same order.
  objects_ = parameters_.order == LabelOrder::opencv ? number_in_order(runs_, 0, count, 0)
                                                     : kernels_.number(rows, runs_);
  labels_ = objects_;
  if (!background_runs_) return;
  background_ = background_runs_->of(rows, Connectivity::four, ends);
  labels_ = engine_.holes.number(background_, objects_);
}

void ContactStrip::sum(Region* regions) {
  if (!background_runs_) return kernels_.sum(rows_, runs_, regions);
  // Between two runs of a row in the foreground is one in the background.
  const auto rows = static_cast<std::size_t>(rows_.height);
  ids_.resize(2 * std::size_t{background_.runs.first[rows]} + rows + 2 * std::size_t{kRunPadding});
  ids_end_ =
      engine_.holes.sum({rows_, runs_, objects_}, background_, regions, ids_.data() + kRunPadding);
}

void ContactStrip::join(const ContactStrip& above, Label offset_above, Label offset,
                        Label* parents) const {
  const BandKind band = band_of(parameters_.task);
  const Index last = bands_of(band, above.rows_.height) - 1;
  const SeamBand upper = seam_band(above.rows_, above.runs_, last, offset_above);
  const SeamBand lower = seam_band(rows_, runs_, 0, offset);
  (band == BandKind::pair ? join_bands<BandKind::pair> : join_bands<BandKind::row>)(upper, lower,
                                                                                    parents);
  if (!background_runs_) return;
  const Background& background = above.background_;
  join_bands<BandKind::row>(
      seam_band(background.image, background.runs, above.rows_.height - 1, offset_above),
      seam_band(background_.image, background_.runs, 0, offset), parents);
}

void ContactStrip::renumber(const Label* numbers) {
  Label* const first = background_runs_ ? ids_.data() + kRunPadding : runs_.ids;
  Label* const last =
      background_runs_ ? ids_end_
                       : runs_.ids + runs_.first[bands_of(band_of(parameters_.task), rows_.height)];
  for (Label* id = first; id < last; ++id) *id = numbers[*id];
}

void ContactStrip::paint(const LabelView& labels) const {
  if (background_runs_) {
    engine_.holes.paint(rows_, background_.image, ids_.data() + kRunPadding, labels);
  } else {
    kernels_.paint(rows_, runs_, labels);
  }
}

ContactLabeller::ContactLabeller(const LabelParameters& parameters, Isa isa, Index width,
                                 Index height, const ThreadTeam& team)
    : task_(parameters.task), team_(team) {
  // Whole pairs of rows, as runs may be those of pairs.
  const Index count = std::clamp<Index>((height + 1) / 2, 1, team.threads());
  for (Index i = 0; i <= count; ++i) {
    first_rows_.push_back(std::min(height, (height + 1) / 2 * i / count * 2));
  }
  for (std::size_t i = 0; i + 1 < first_rows_.size(); ++i) {
    strips_.emplace_back(parameters, isa, width, first_rows_[i + 1] - first_rows_[i]);
  }
}

template <class Body>
void ContactLabeller::for_strips(const Body& body) {
  team_.for_ranges(static_cast<Index>(strips_.size()), [&](Index first, Index last) {
    for (Index i = first; i < last; ++i) body(static_cast<std::size_t>(i));
  });
}

Label ContactLabeller::find(const ConstBitPlaneView& image, Regions& found) {
  for_strips([&](std::size_t i) {
    strips_[i].find(rows_of_view(image, first_rows_[i], first_rows_[i + 1]),
                    {i == 0, i + 1 == strips_.size()});
  });
  offsets_.assign(1, 0);
  for (const ContactStrip& strip : strips_) {
    offsets_.push_back(offsets_.back() + strip.labels() + 1);
  }
  const bool has_holes = task_ == LabelTask::regions;
  if (has_holes) sum_strips(regions_);
  if (!has_holes && task_ >= LabelTask::objects_eight) sum_strips(found.objects);
  const Count count = strips_.size() > 1
                          ? join_strips()
                          : Count{strips_.front().objects(), strips_.front().labels()};
  if (has_holes) list_regions(count, found);
  if (!has_holes && task_ >= LabelTask::objects_eight) list_objects(count.objects, found.objects);
  return count.objects;
}

void ContactLabeller::sum_strips(std::vector<Region>& regions) {
  regions.assign(offsets_.back(), kNoPixels);
  for_strips([&](std::size_t i) {
    Region* const first = regions.data() + offsets_[i];
    strips_[i].sum(first);
    for (Label label = 0; i > 0 && label <= strips_[i].labels(); ++label) {
      move_down(first[label], first_rows_[i]);
    }
  });
}

ContactLabeller::Count ContactLabeller::join_strips() {
  numbers_.resize(offsets_.back());
  std::iota(numbers_.begin(), numbers_.end(), Label{0});
  for (std::size_t i = 1; i < strips_.size(); ++i) {
    numbers_[offsets_[i]] = 0;  // there is one outside
    strips_[i].join(strips_[i - 1], offsets_[i - 1], offsets_[i], numbers_.data());
  }
  return number_labels();
}

/// Objects first. A parent precedes its label, so it has its number when the label is visited.
ContactLabeller::Count ContactLabeller::number_labels() {
  Label count = 0;
  const auto number = [&](Label first, Label last) {
    for (Label label = first; label < last; ++label) {
      Label& parent = numbers_[label];
      parent = parent == label ? ++count : numbers_[parent];
    }
  };
  for (std::size_t i = 0; i < strips_.size(); ++i) {
    number(offsets_[i] + 1, offsets_[i] + strips_[i].objects() + 1);
  }
  const Label objects = count;
  for (std::size_t i = 0; i < strips_.size(); ++i) {
    number(offsets_[i] + strips_[i].objects() + 1, offsets_[i] + strips_[i].labels() + 1);
  }
  return {objects, count};
}

/// In place: a number is not above its label.
void ContactLabeller::list_objects(Label objects, std::vector<Region>& regions) const {
  Label count = 0;
  const std::size_t joined = strips_.size() > 1 ? strips_.size() : 0;
  for (std::size_t i = 0; i < joined; ++i) {
    for (Label label = 1; label <= strips_[i].labels(); ++label) {
      const Label number = numbers_[offsets_[i] + label];
      const Region& part = regions[offsets_[i] + label - 1];
      if (number > count) {
        regions[count++] = part;
      } else {
        add_region(regions[number - 1], part);
      }
    }
  }
  regions.resize(objects);
}

void ContactLabeller::list_regions(const Count& count, Regions& found) const {
  if (strips_.size() == 1) {
    const auto first_hole = regions_.begin() + 1 + static_cast<std::ptrdiff_t>(count.objects);
    found.objects.assign(regions_.begin() + 1, first_hole);
    found.holes.assign(first_hole, regions_.end());
    return;
  }
  found.objects.clear();
  found.holes.clear();
  found.objects.reserve(count.objects);
  found.holes.reserve(count.labels - count.objects);
  for (std::size_t i = 0; i < strips_.size(); ++i) {
    const Label* const numbers = numbers_.data() + offsets_[i];
    for (Label label = 1; label <= strips_[i].labels(); ++label) {
      const Label number = numbers[label];
      if (number == 0) continue;
      Region part = regions_[offsets_[i] + label];
      part.enclosing_object = numbers[part.enclosing_object];
      if (number <= count.objects) {
        add_to_list(found.objects, number - 1, part);
      } else {
        add_to_list(found.holes, number - count.objects - 1, part);
      }
    }
  }
}

void ContactLabeller::paint(const LabelView& labels) {
  for_strips([&](std::size_t i) {
    if (strips_.size() > 1) strips_[i].renumber(numbers_.data() + offsets_[i]);
    strips_[i].paint(rows_of_view(labels, first_rows_[i], first_rows_[i + 1]));
  });
}

}  // namespace thinbench::detail
