#include "graph/pruner.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace thinbench::detail {
namespace {

/// In the map of nodes: pixels that were parts of junctions and are parts of lines, before and
/// after these lines were looked at.
constexpr std::uint32_t kNewLine = 0;
constexpr std::uint32_t kKnownLine = std::numeric_limits<std::uint32_t>::max();

auto raster_order(Pixel p) {
  return std::tuple(p.y, p.x);
}

bool is_before(Pixel a, Pixel b) {
  return raster_order(a) < raster_order(b);
}

}  // namespace

bool Pruner::ByEnd::operator()(const Branch& a, const Branch& b) const {
  return std::tuple(a.length, raster_order(a.end)) < std::tuple(b.length, raster_order(b.end));
}

bool Pruner::ByStop::operator()(const Branch& a, const Branch& b) const {
  return std::tuple(a.length, raster_order(a.stop), a.direction) <
         std::tuple(b.length, raster_order(b.stop), b.direction);
}

Pruner::Pruner(const BitPlaneView& image, const ConstBitPlaneView& nodes, const NodeMap& node_at,
               const Graph& graph, const Pruning& pruning)
    : image_(image),
      nodes_(nodes),
      node_at_(node_at),
      graph_(graph),
      pruning_(pruning),
      junctions_(graph.nodes.size()) {
  for (std::size_t i = 0; i < junctions_.size(); ++i) {
    junctions_[i].pixels = graph.pixels_of(graph.nodes[i]);
  }
}

void Pruner::run() {
  start();
  while (remove_round()) {
  }
}

bool Pruner::is_junction(Pixel p) const {
  if (!foreground(p)) return false;
  const unsigned window = window_at(image_, p);
  return std::popcount(kJoined[window]) > 1 && !kIsLine[window];
}

double Pruner::limit_at(Pixel stop) const {
  if (pruning_.min_widths == 0) return pruning_.min_length;
  return std::max(pruning_.min_length,
                  pruning_.min_widths * 2 * pruning_.distances.row(stop.y)[stop.x]);
}

template <class Visit>
Pruner::Line Pruner::follow(Pixel from, Visit visit, int direction) const {
  Line line = {moved(from, direction), direction, {}};
  add_step(line.steps, direction);
  while (is_line(line.stop) && line.stop != from) {
    visit(line.stop);
    line.direction = direction_on(window_at(image_, line.stop), line.direction);
    add_step(line.steps, line.direction);
    line.stop = moved(line.stop, line.direction);
  }
  return line;
}

void Pruner::clear_line(Pixel end, bool with_stop) {
  std::vector<Pixel> pixels = {end};  // first all, as neighbours of cleared pixels are joined anew
  const auto note = [&](Pixel p) { pixels.push_back(p); };
  const Line line = follow(end, note, std::countr_zero(joined(end)));
  if (with_stop) note(line.stop);
  for (const Pixel p : pixels) clear_bit(image_, p);
}

/// Where the line from this end leads: notes a short branch, clears a short component.
void Pruner::look_at_end(Pixel end) {
  const Line line = follow(
      end, [](Pixel) {}, std::countr_zero(joined(end)));
  const double length = length_of(line.steps, pruning_.spacing);
  if (is_junction(line.stop)) {
    const Branch branch = {length, end, line.stop, opposite(line.direction)};
    if (length < limit_at(line.stop)) add(node_at_[line.stop], branch);
  } else if (pruning_.removes_components && length < pruning_.min_length) {
    clear_line(end, true);
  }
}

void Pruner::add(JunctionId id, const Branch& branch) {
  Junction& at = junction(id);
  if (is_before(branch.end, at.pixels.front())) {
    at.before.insert(branch);
  } else {
    at.after.insert(branch);
  }
  active_.push_back(id);
}

std::optional<Pruner::Branch> Pruner::take_shortest(JunctionId id) {
  const auto drop_left = [&](auto& branches) {
    while (!branches.empty() && !belongs(branches.begin()->stop, id)) {
      branches.erase(branches.begin());
    }
  };
  const auto take_first = [](auto& branches) {
    const Branch branch = *branches.begin();
    branches.erase(branches.begin());
    return branch;
  };
  auto& [pixels, before, after] = junction(id);
  drop_left(before);
  drop_left(after);
  if (before.empty() && after.empty()) return {};
  const bool take_before =
      after.empty() || (!before.empty() && before.begin()->length <= after.begin()->length);
  return take_before ? take_first(before) : take_first(after);
}

/// Of a junction that lost a pixel.
void Pruner::drop_first_pixels(JunctionId id) {
  Junction& at = junction(id);
  while (!at.pixels.empty() && !belongs(at.pixels.front(), id)) at.pixels = at.pixels.subspan(1);
  if (at.pixels.empty()) {
    at = {};
    return;
  }
  for (auto branch = at.after.begin(); branch != at.after.end();) {
    const bool moves = is_before(branch->end, at.pixels.front());
    if (moves) at.before.insert(*branch);
    branch = moves ? at.after.erase(branch) : std::next(branch);
  }
}

void Pruner::start() {
  const bool removes_points = pruning_.removes_components && pruning_.min_length > 0;
  for (const GraphNode& node : graph_.nodes) {
    const Pixel p = graph_.pixels_of(node).front();
    if (node.kind == NodeKind::end && foreground(p)) look_at_end(p);
    if (node.kind == NodeKind::isolated && removes_points) clear_bit(image_, p);
  }
}

/// Removes the shortest branch of every junction that has one, then looks at what changed.
bool Pruner::remove_round() {
  std::sort(active_.begin(), active_.end());
  active_.erase(std::unique(active_.begin(), active_.end()), active_.end());
  std::vector<std::pair<JunctionId, Branch>> removed;
  for (const JunctionId id : active_) {
    if (const auto branch = take_shortest(id)) removed.emplace_back(id, *branch);
  }
  active_.clear();
  for (const auto& [id, branch] : removed) clear_line(branch.end, false);
  for (const auto& [id, branch] : removed) {
    active_.push_back(id);
    if (!is_line(branch.stop)) continue;
    node_at_[branch.stop] = kNewLine;
    split(id, branch.stop);
    drop_first_pixels(id);
  }
  for (const auto& [id, branch] : removed) join_lines_at(branch.stop);
  return !active_.empty();
}

/// Makes two junctions of one where it is in two parts without this pixel. Both parts are
/// searched in turn, so that the smaller one decides how long it takes.
void Pruner::split(JunctionId id, Pixel gone) {
  std::vector<Part> parts;
  for_directions(joined(gone), [&](int direction) {
    const Pixel p = moved(gone, direction);
    const auto next = static_cast<JunctionId>(junctions_.size() + parts.size() + 1);
    if (belongs(p, id)) parts.push_back({next, {p}});
  });
  if (parts.size() < 2) return;
  for (const Part& part : parts) rename(part, part.id);
  for (std::size_t turn = 0;; turn ^= 1) {
    Part& part = parts[turn];
    Part& other = parts[turn ^ 1];
    if (part.visited == part.pixels.size()) {
      rename(other, id);
      add_junction(part);
      return;
    }
    if (grow(part, id, other.id)) {
      rename(part, id);
      rename(other, id);
      return;
    }
  }
}

/// Whether the next pixel of a part is joined to the other part. Otherwise takes what is joined to
/// it from the junction.
bool Pruner::grow(Part& part, JunctionId from, JunctionId other) {
  const Pixel p = part.pixels[part.visited++];
  bool met = false;
  for_directions(joined(p), [&](int direction) {
    const Pixel q = moved(p, direction);
    met = met || belongs(q, other);
    if (!belongs(q, from)) return;
    node_at_[q] = part.id;
    part.pixels.push_back(q);
  });
  return met;
}

void Pruner::rename(const Part& part, JunctionId id) {
  for (const Pixel p : part.pixels) node_at_[p] = id;
}

void Pruner::add_junction(Part& part) {
  const auto id = static_cast<JunctionId>(junctions_.size() + 1);
  rename(part, id);
  std::sort(part.pixels.begin(), part.pixels.end(), is_before);
  junctions_.push_back({parts_.emplace_back(std::move(part.pixels)), {}, {}});
  for (const Pixel p : parts_.back()) {
    for_directions(joined(p), [&](int direction) {
      const Pixel last = follow(
                             p, [](Pixel) {}, direction)
                             .stop;
      if (!is_junction(last)) look_at_end(last);
    });
  }
}

/// The lines on both sides of a junction pixel that became a line pixel may be a branch now.
void Pruner::join_lines_at(Pixel p) {
  const bool is_new = foreground(p) && is_line(p) && node_at_[p] == kNewLine;
  if (!is_new) return;
  const auto mark = [&](Pixel q) {
    if (bit_at(nodes_, q)) node_at_[q] = kKnownLine;
  };
  mark(p);
  Pixel end = p;
  for_directions(joined(p), [&](int direction) {
    const Pixel last = follow(p, mark, direction).stop;
    if (last != p && !is_junction(last)) end = last;
  });
  if (end != p) look_at_end(end);
}

}  // namespace thinbench::detail
