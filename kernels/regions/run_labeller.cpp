#include "regions/run_labeller.hpp"

#include <algorithm>
#include <atomic>

#include "core/layout.hpp"

namespace thinbench::detail {
namespace {

/// Elements for the keys, labels or accumulators of a row: one key precedes the first, and the keys
/// of a whole word plus padding may be written after the last.
Index elements_of_row(Index width) {
  return round_up(width + 2 + kWordBits + 2 * kKeyPadding, kKeyPadding);
}

constexpr Index kArrays = 11;  // keys and labels of three rows, five accumulators

/// Merges all runs that touch across two rows labelled in the same tables.
void join_rows(LabelTables& tables, const RunRow& above, const RunRow& below) {
  Index next = 0;
  for (Index i = 0; i <= below.count; ++i) {
    while (above.keys[next] < below.keys[i - 1]) ++next;
    Label* const parents = tables.of_colour[i % 2].parents;
    for (Index touching = next + (i + next) % 2; above.keys[touching - 1] < below.keys[i];
         touching += 2) {
      unite(parents, above.labels[touching], below.labels[i]);
    }
  }
}

/// Appends the labels of `lower` to `labels`, renumbers the rows of `lower`, and joins the rows at
/// the seam.
void join_bands(LabelStore& labels, const RunRow& last_above, RunBand& lower) {
  const LabelStore::Offsets offsets = labels.append(lower.labels().tables());
  for (RunRow* row : {&lower.first_row(), &lower.last_row()}) {
    for (Index i = 0; i <= row->count; ++i) {
      Label& label = row->labels[i];
      if (i % 2 == 1 || label != 0) label += offsets.of_colour[i % 2];
    }
  }
  join_rows(labels.tables(), last_above, lower.first_row());
}

/// Joins all background runs of a row at the image border with the outside.
void join_border(LabelTables& tables, const RunRow& row) {
  Label* const parents = tables.of_colour[0].parents;
  for (Index i = 0; i <= row.count; i += 2) unite(parents, 0, row.labels[i]);
}

/// Labels row y as the first of a band: every run gets a new label, except the background runs at
/// either end, which get 0.
void label_first_row(const ConstBitPlaneView& image, Index y, RunLabelling& labelling) {
  RunRow& row = labelling.above;
  row.count = find_keys(image.row(y), words_with_boundaries(image.width), row.keys);
  row.labels[0] = 0;
  for (Index i = 1; i < row.count; ++i) {
    const Label enclosing_object = i % 2 == 0 ? row.labels[i - 1] : 0;
    row.labels[i] = new_label(labelling.tables.of_colour[i % 2], y, enclosing_object);
  }
  row.labels[row.count] = 0;
  add_runs(labelling.tables, row, y);
}

}  // namespace

RunBand::RunBand(Index width)
    : memory_(make_aligned<Key>(static_cast<std::size_t>(kArrays * elements_of_row(width)))),
      labels_(width) {
  Key* next = memory_.get();
  const auto take = [&] {
    Key* const taken = next + kKeyPadding;  // one key before the first, on a cache line
    next += elements_of_row(width);
    return taken;
  };
  for (RunRow* row : {&first_row_, &labelling_.above, &labelling_.here}) {
    row->keys = take();
    row->keys[-1] = kFirstKey;
    row->labels = reinterpret_cast<Label*>(take());
  }
  RunAccumulators& sums = labelling_.accumulators;
  for (Key** sum : {&sums.length, &sums.squares, &sums.rows, &sums.min_begin, &sums.max_end}) {
    *sum = take();
  }
}

bool RunBand::label(LabelRows label_rows, const ConstBitPlaneView& image, Index first, Index last) {
  labels_.clear();
  labelling_.tables = labels_.tables();
  labelling_.patience = kPatience;
  label_first_row(image, first, labelling_);
  const RunRow& row = labelling_.above;
  first_row_.count = row.count;
  std::copy_n(row.keys, row.count + kKeyPadding, first_row_.keys);
  std::copy_n(row.labels, row.count + 1, first_row_.labels);
  for (Index y = first + 1;;) {
    y = label_rows(image, y, last, labelling_);
    labels_.tables() = labelling_.tables;
    if (labelling_.patience < 0) return false;
    if (y == last) return true;
    labels_.make_room((image.width + 1) / 2);
    labelling_.tables = labels_.tables();
  }
}

RunLabeller::RunLabeller(const RunEngine& engine, bool with_holes, Isa isa, Index width,
                         Index height, const ThreadTeam& team)
    : label_rows_(with_holes ? engine.holes : engine.objects),
      with_holes_(with_holes),
      isa_(isa),
      team_(team) {
  const Index bands = std::min<Index>(team.threads(), height);
  for (Index band = 0; band < bands; ++band) bands_.emplace_back(width);
}

void RunLabeller::find(const ConstBitPlaneView& image, Regions& found) {
  if (bands_.empty()) return;
  if (!label_bands(image)) {
    const LabelTask task = with_holes_ ? LabelTask::regions : LabelTask::objects_eight;
    if (!contacts_) {
      contacts_.emplace(LabelParameters{task}, isa_, image.width, image.height, team_);
    }
    contacts_->find(image, found);
    return;
  }
  LabelStore& labels = bands_.front().labels();
  for (std::size_t i = 1; i < bands_.size(); ++i) {
    join_bands(labels, bands_[i - 1].last_row(), bands_[i]);
  }
  labels.list_objects(found.objects);
  if (!with_holes_) return;
  join_border(labels.tables(), bands_.front().first_row());
  join_border(labels.tables(), bands_.back().last_row());
  labels.list_holes(found.holes);
}

bool RunLabeller::label_bands(const ConstBitPlaneView& image) {
  std::atomic<bool> is_done = true;
  const auto count = static_cast<Index>(bands_.size());
  team_.for_ranges(count, [&](Index first, Index last) {
    for (Index band = first; band < last; ++band) {
      RunBand& rows = bands_[static_cast<std::size_t>(band)];
      if (!rows.label(label_rows_, image, image.height * band / count,
                      image.height * (band + 1) / count)) {
        is_done = false;
      }
    }
  });
  return is_done;
}

}  // namespace thinbench::detail
