// Each label is drawn on a canvas of its own and thinned there. A label is a chain of runs, so
// memory does not grow with its box, and a pixel is written by the thread that thins its label
// alone.
#include "thinbench/labels.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "core/checks.hpp"
#include "core/thread_team.hpp"
#include "thinning/canvases.hpp"

namespace thinbench {
namespace {

using detail::ThreadTeam;

/// Pixels [first, last) of a row, all with one label.
struct Run {
  std::int32_t label;  // its value, later its index in the list of labels
  std::int32_t y;
  std::int32_t first;
  std::int32_t last;
};

/// One axis of a canvas, and where the label's box begins on it.
struct CanvasSide {
  Index size;
  Index offset;
};

/// A label that is thinned: its runs and its canvas.
struct ThinnedLabel {
  std::int32_t value;
  Index left, top, right, bottom;  // the box; right and bottom are exclusive
  Index first_run, run_count;      // first_run: among runs that are grouped by label
  CanvasSide columns, rows;
};

/// The end of the run of equal labels that begins at x.
Index end_of_run(const std::int32_t* row, Index x, Index width) {
  constexpr Index step = 8;
  const std::int32_t value = row[x];
  for (; x + step <= width; x += step) {
    std::int32_t differs = 0;
    for (Index i = 0; i < step; ++i) differs |= row[x + i] ^ value;
    if (differs != 0) break;
  }
  while (x < width && row[x] == value) ++x;
  return x;
}

[[noreturn]] void reject_label(std::int32_t label, Index x, Index y) {
  throw std::invalid_argument("labels: expected 0 or more, got " + std::to_string(label) +
                              " in row " + std::to_string(y) + ", column " + std::to_string(x));
}

void append_runs(const ConstLabelView& source, Index y, std::vector<Run>& runs) {
  const std::int32_t* row = source.row(y);
  for (Index x = 0, last = 0; x < source.width; x = last) {
    last = end_of_run(row, x, source.width);
    if (row[x] < 0) reject_label(row[x], x, y);
    if (row[x] == 0) continue;
    runs.push_back({row[x], static_cast<std::int32_t>(y), static_cast<std::int32_t>(x),
                    static_cast<std::int32_t>(last)});
  }
}

/// All runs, in raster order.
std::vector<Run> find_runs(const ConstLabelView& source, const ThreadTeam& team) {
  const Index count = team.threads();
  std::vector<std::vector<Run>> parts(static_cast<std::size_t>(count));
  team.for_ranges(count, [&](Index first, Index last) {
    for (Index i = first; i < last; ++i) {
      for (Index y = source.height * i / count; y < source.height * (i + 1) / count; ++y) {
        append_runs(source, y, parts[static_cast<std::size_t>(i)]);
      }
    }
  });
  std::size_t found = 0;
  for (const auto& part : parts) found += part.size();
  std::vector<Run> runs = std::move(parts.front());
  runs.reserve(found);
  for (auto part = parts.begin() + 1; part != parts.end(); ++part) {
    runs.insert(runs.end(), part->begin(), part->end());
  }
  return runs;
}

/// The labels in raster order of their first pixels; in the runs, their indices replace values.
std::vector<ThinnedLabel> find_labels(std::vector<Run>& runs) {
  std::vector<ThinnedLabel> labels;
  std::unordered_map<std::int32_t, std::int32_t> index_of;
  for (Run& run : runs) {
    const auto next = static_cast<std::int32_t>(labels.size());
    const auto [found, is_new] = index_of.try_emplace(run.label, next);
    if (is_new) labels.push_back({run.label, run.first, run.y, 0, 0, 0, 0, {}, {}});
    run.label = found->second;
    ThinnedLabel& label = labels[static_cast<std::size_t>(run.label)];
    label.left = std::min<Index>(label.left, run.first);
    label.right = std::max<Index>(label.right, run.last);
    label.bottom = run.y + 1;
    ++label.run_count;
  }
  return labels;
}

/// The runs grouped by label, so that those of a label lie side by side in memory.
std::vector<Run> grouped_runs(const std::vector<Run>& runs, std::vector<ThinnedLabel>& labels) {
  std::vector<Index> next;
  Index count = 0;
  for (ThinnedLabel& label : labels) {
    label.first_run = count;
    next.push_back(count);
    count += label.run_count;
  }
  std::vector<Run> grouped(runs.size());
  for (const Run& run : runs) {
    grouped[static_cast<std::size_t>(next[static_cast<std::size_t>(run.label)]++)] = run;
  }
  return grouped;
}

/// The canvas for pixels [first, last) of a side of the image. Its ends are those of the image
/// where the border is kept and the label touches it; elsewhere background follows, which
/// Border::keep does not change.
CanvasSide canvas_side(Index first, Index last, Index image, bool keep_border,
                       Index (*rounded)(Index)) {
  const bool at_start = keep_border && first == 0;
  const bool at_end = keep_border && last == image;
  const Index length = last - first;
  const Index margin = keep_border ? 1 : 0;
  if (at_start && at_end) return {length, 0};
  const Index size = rounded(length + 2 * margin);
  if (at_start) return {size, 0};
  return {size, at_end ? size - length : margin};
}

void choose_canvases(std::vector<ThinnedLabel>& labels, const ConstLabelView& source,
                     bool keep_border) {
  using detail::canvas_height, detail::canvas_width;
  for (ThinnedLabel& label : labels) {
    label.columns = canvas_side(label.left, label.right, source.width, keep_border, canvas_width);
    label.rows = canvas_side(label.top, label.bottom, source.height, keep_border, canvas_height);
  }
}

std::vector<detail::Canvas> canvases_of(const std::vector<ThinnedLabel>& labels) {
  std::vector<detail::Canvas> canvases;
  canvases.reserve(labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    canvases.push_back({labels[i].columns.size, labels[i].rows.size, i});
  }
  return canvases;
}

/// Writes the label where `skeleton` is foreground, which is in few places.
void write_skeleton(const std::uint8_t* skeleton, Index count, std::int32_t label,
                    std::int32_t* to) {
  constexpr Index step = sizeof(std::uint64_t);
  for (Index x = 0; x < count; x += step) {
    const Index size = std::min(step, count - x);
    std::uint64_t pixels = 0;
    std::memcpy(&pixels, skeleton + x, static_cast<std::size_t>(size));
    if (pixels == 0) continue;
    for (Index i = x; i < x + size; ++i) {
      if (skeleton[i] != 0) to[i] = label;
    }
  }
}

/// Draws labels on canvases, and writes what is left of them.
class LabelPainter {
 public:
  LabelPainter(const std::vector<ThinnedLabel>& labels, const std::vector<Run>& runs,
               const LabelView& destination, bool in_place)
      : labels_(labels), runs_(runs), destination_(destination), in_place_(in_place) {}

  void draw(std::size_t item, const ImageView& canvas) const {
    for_runs(labels_[item], [&](Index y, Index x, const Run& run) {
      std::fill_n(canvas.row(y) + x, run.last - run.first, std::uint8_t{1});
    });
  }

  /// Unless in place, the destination must be zero.
  void take(std::size_t item, const ConstImageView& canvas) const {
    const ThinnedLabel& label = labels_[item];
    for_runs(label, [&](Index y, Index x, const Run& run) {
      std::int32_t* to = destination_.row(run.y) + run.first;
      if (in_place_) std::fill_n(to, run.last - run.first, 0);
      write_skeleton(canvas.row(y) + x, run.last - run.first, label.value, to);
    });
  }

 private:
  /// Calls `body(y, x, run)` for each run, which begins at (x, y) of the canvas.
  template <class Body>
  void for_runs(const ThinnedLabel& label, const Body& body) const {
    const Run* runs = &runs_[static_cast<std::size_t>(label.first_run)];
    for (Index i = 0; i < label.run_count; ++i) {
      body(runs[i].y - label.top + label.rows.offset,
           runs[i].first - label.left + label.columns.offset, runs[i]);
    }
  }

  const std::vector<ThinnedLabel>& labels_;
  const std::vector<Run>& runs_;
  LabelView destination_;
  bool in_place_;
};

/// Rejects what labels cannot be thinned with.
void check(const detail::ThinningCall& call) {
  using detail::require;
  const auto parameters = detail::thinning_parameters(call.rule, call.thinning);
  const std::string name(call.rule.name());
  require(!parameters.complemented,
          name + ": border: expected background or keep for labels, got foreground");
  require(!parameters.rule->adds_pixels(),
          name + " adds pixels, which would belong to no label; apply it to an image");
}

void clear(const LabelView& labels, const ThreadTeam& team) {
  team.for_ranges(labels.height, [&](Index first, Index last) {
    for (Index y = first; y < last; ++y) std::fill_n(labels.row(y), labels.width, 0);
  });
}

}  // namespace

int thin_labels(const Rule& rule, ConstLabelView source, LabelView destination,
                const Thinning& thinning, const Execution& execution) {
  detail::require_label_size(source.width, source.height);
  detail::check_views(source, destination, detail::InPlace::allowed);
  detail::require_execution(execution);
  const detail::ThinningCall call = {rule, thinning, execution};
  check(call);
  const ThreadTeam team(execution.threads);
  std::vector<Run> runs = find_runs(source, team);
  std::vector<ThinnedLabel> labels = find_labels(runs);
  runs = grouped_runs(runs, labels);
  const bool keep_border = thinning.border.value_or(rule.border()) == Border::keep;
  choose_canvases(labels, source, keep_border);
  const bool in_place = source.data == destination.data;
  if (!in_place) clear(destination, team);
  const LabelPainter painter(labels, runs, destination, in_place);
  return detail::thin_canvases(
      call, canvases_of(labels),
      {[&](std::size_t item, const ImageView& canvas) { painter.draw(item, canvas); },
       [&](std::size_t item, const ConstImageView& canvas) { painter.take(item, canvas); }},
      team);
}

}  // namespace thinbench
