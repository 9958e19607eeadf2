#include "graph/main_paths.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "graph/network.hpp"

namespace thinbench::detail {
namespace {

using Nodes = std::vector<std::uint32_t>;

/// Rounding does not decide which of two paths is longer.
constexpr double kRounding = 1e-12;

/// How far something is from both ends of a link, without the link itself.
struct EndDistances {
  double from;
  double to;
};

/// A link that has points.
struct Line {
  std::uint32_t number;
  Link link;
  std::vector<double> points;

  [[nodiscard]] double distance(const EndDistances& ends, double point) const {
    return std::min(ends.from + point, ends.to + link.length - point);
  }

  /// Of the point that is farthest from what has these distances: distances grow up to where both
  /// ways are equally long, and shrink beyond.
  [[nodiscard]] double farthest(const EndDistances& ends) const {
    const auto beyond =
        std::upper_bound(points.begin(), points.end(), (ends.to - ends.from + link.length) / 2);
    double distance_there = 0;
    if (beyond != points.end()) distance_there = distance(ends, *beyond);
    if (beyond == points.begin()) return distance_there;
    return std::max(distance_there, distance(ends, *(beyond - 1)));
  }

  /// As if there were a point where both ways are equally long.
  [[nodiscard]] double max_distance(const EndDistances& ends) const {
    return (ends.from + ends.to + link.length) / 2;
  }
};

using Lines = std::vector<const Line*>;  // in ascending order

/// The longest shortest path of a component. Each search narrows how far away the farthest node or
/// point of every node may be: from node u, whose farthest is e away, v's is at least max(d, e - d)
/// and at most e + d for the distance d between them. For a point of a line, that of both its ends
/// and the ways to them give a maximum.
class Diameter {
 public:
  Diameter(const Network& network, const PointsOf& points_of)
      : network_(network),
        points_of_(points_of),
        from_(network),
        to_(network),
        min_(network.nodes()),
        max_(network.nodes(), std::numeric_limits<double>::infinity()) {}

  /// Of the component of this node, which is its first.
  GraphPath path_of(std::uint32_t first, bool is_tree) {
    longest_ = 0;
    lines_.clear();
    from_.search(first);
    Nodes nodes = from_.reached();
    std::sort(nodes.begin(), nodes.end());
    if (!is_tree) add_lines(nodes);
    narrow(from_, first);
    search(from_, from_.reached().back());
    search(from_, from_.reached().back());
    if (is_tree) {
      // The farthest node is one of the two ends that were searched.
      for (const std::uint32_t node : nodes) max_[node] = min_[node];
    } else {
      rule_out(nodes);
      rule_out_lines();
    }
    return first_longest(nodes);
  }

 private:
  [[nodiscard]] bool is_longest(double distance) const {
    return distance >= longest_ * (1 - kRounding);
  }
  [[nodiscard]] bool is_longer(double distance) const {
    return distance > longest_ * (1 + kRounding);
  }

  void add_lines(const Nodes& nodes) {
    for (const std::uint32_t node : nodes) {
      for (const std::uint32_t number : network_.links_of(node)) {
        if (network_.link(number).from != node) continue;
        Line line = {number, network_.link(number), points_of_(number)};
        if (!line.points.empty()) lines_.push_back(std::move(line));
      }
    }
    std::sort(lines_.begin(), lines_.end(),
              [](const Line& a, const Line& b) { return a.number < b.number; });
  }

  [[nodiscard]] static EndDistances ends_of(const Line& line, const ShortestPaths& paths) {
    return {paths.distance(line.link.from), paths.distance(line.link.to)};
  }

  void search(ShortestPaths& paths, std::uint32_t from) {
    paths.search(from);
    narrow(paths, from);
  }

  /// By the paths that were found from this node.
  void narrow(const ShortestPaths& paths, std::uint32_t from) {
    double farthest = paths.distance(paths.reached().back());
    for (const Line& line : lines_) {
      const EndDistances ends = ends_of(line, paths);
      if (line.max_distance(ends) > farthest) farthest = std::max(farthest, line.farthest(ends));
    }
    longest_ = std::max(longest_, farthest);
    for (const std::uint32_t node : paths.reached()) {
      const double distance = paths.distance(node);
      min_[node] = std::max({min_[node], distance, farthest - distance});
      max_[node] = std::min(max_[node], farthest + distance);
    }
    min_[from] = max_[from] = farthest;
  }

  /// Until nothing may be farther from a node than the longest path found: alternately from the
  /// node that may have the farthest and from the one that is most central.
  void rule_out(Nodes open) {
    for (bool central = true;; central = !central) {
      std::erase_if(open, [&](std::uint32_t node) { return !is_longer(max_[node]); });
      if (open.empty()) return;
      const auto by = [](const std::vector<double>& bounds) {
        return [&bounds](auto a, auto b) { return bounds[a] < bounds[b]; };
      };
      search(from_, central ? *std::min_element(open.begin(), open.end(), by(min_))
                            : *std::max_element(open.begin(), open.end(), by(max_)));
    }
  }

  /// How far away the farthest point of any point of the line may be.
  [[nodiscard]] double max_of(const Line& line) const {
    return line.farthest({max_[line.link.from], max_[line.link.to]});
  }

  /// The same for points of lines, whose farthest are points of lines, too: alternately from the
  /// most central of their ends and from the line that may have the farthest.
  void rule_out_lines() {
    Lines open;
    for (const Line& line : lines_) open.push_back(&line);
    for (bool central = true;; central = !central) {
      std::erase_if(open, [&](const Line* line) { return !is_longer(max_of(*line)); });
      if (open.empty()) return;
      if (central) {
        search_centre(open);
        continue;
      }
      const auto widest =
          std::max_element(open.begin(), open.end(),
                           [&](const Line* a, const Line* b) { return max_of(*a) < max_of(*b); });
      search_from_points(**widest, open);
      open.erase(widest);
    }
  }

  /// From the most central end of these lines that was not searched, if there is one.
  void search_centre(const Lines& lines) {
    std::uint32_t centre = kNoLink;
    for (const Line* line : lines) {
      for (const std::uint32_t node : {line->link.from, line->link.to}) {
        const bool is_open = min_[node] < max_[node];
        if (is_open && (centre == kNoLink || min_[node] < min_[centre])) centre = node;
      }
    }
    if (centre != kNoLink) search(from_, centre);
  }

  void search_both_ends(const Line& line) {
    search(from_, line.link.from);
    search(to_, line.link.to);
  }

  /// From a point of a line whose ends were searched. On that line itself, only points beyond it
  /// count.
  [[nodiscard]] EndDistances ends_from(const Line& line, double point, const Line& other) const {
    if (&line == &other) return {-point, point + from_.distance(line.link.to)};
    const auto distance = [&](std::uint32_t node) {
      return std::min(point + from_.distance(node), line.link.length - point + to_.distance(node));
    };
    return {distance(other.link.from), distance(other.link.to)};
  }

  /// How far any points of two lines may be apart. From a point of the first line, distances to
  /// both ends of the other grow, then one grows while the other shrinks, then both shrink.
  [[nodiscard]] double max_distance(const Line& line, const Line& other) const {
    const std::uint32_t end = other.link.from;
    const double middle = (line.link.length + to_.distance(end) - from_.distance(end)) / 2;
    return other.max_distance(ends_from(line, middle, other));
  }

  void search_from_points(const Line& line, const Lines& others) {
    search_both_ends(line);
    for (const Line* other : others) {
      if (!is_longer(max_distance(line, *other))) continue;
      for (const double point : line.points) {
        const EndDistances ends = ends_from(line, point, *other);
        if (is_longer(other->max_distance(ends))) {
          longest_ = std::max(longest_, other->farthest(ends));
        }
      }
    }
  }

  GraphPath first_longest(const Nodes& nodes) {
    for (const std::uint32_t node : nodes) {
      if (!is_longest(max_[node])) continue;
      if (!is_longest(min_[node])) search(from_, node);
      if (is_longest(min_[node])) return longest_from(node, nodes);
    }
    for (const Line& line : lines_) {
      if (!is_longest(max_of(line))) continue;
      search_both_ends(line);
      const GraphPath path = longest_from(line);
      if (!path.edges.empty()) return path;
    }
    return {0, {nodes.front()}, {}};
  }

  GraphPath longest_from(std::uint32_t node, const Nodes& nodes) {
    from_.search(node);
    const auto last = std::find_if(nodes.begin(), nodes.end(), [&](std::uint32_t other) {
      return is_longest(from_.distance(other));
    });
    if (last != nodes.end()) return from_.path_to(*last);
    for (const Line& line : lines_) {
      const EndDistances ends = ends_of(line, from_);
      if (!is_longest(line.farthest(ends))) continue;
      const std::uint32_t point = first_point(line, ends);
      const bool by_from =
          ends.from + line.points[point] <= ends.to + line.link.length - line.points[point];
      GraphPath path = from_.path_to(by_from ? line.link.from : line.link.to);
      path.length = line.distance(ends, line.points[point]);
      path.edges.push_back(line.number);
      path.last_point = point;
      return path;
    }
    return {0, {node}, {}};
  }

  /// The first that is farthest away.
  [[nodiscard]] std::uint32_t first_point(const Line& line, const EndDistances& ends) const {
    const auto first = std::find_if(line.points.begin(), line.points.end(), [&](double point) {
      return is_longest(line.distance(ends, point));
    });
    return static_cast<std::uint32_t>(first - line.points.begin());
  }

  /// From the first point of a line, whose ends were searched, that has one; without edges if none
  /// has.
  [[nodiscard]] GraphPath longest_from(const Line& line) const {
    Lines others;  // those before the line have no such points
    for (const Line& other : lines_) {
      if (other.number < line.number) continue;
      if (is_longest(max_of(other)) && is_longest(max_distance(line, other))) {
        others.push_back(&other);
      }
    }
    for (std::uint32_t i = 0; i < line.points.size(); ++i) {
      for (const Line* other : others) {
        const EndDistances ends = ends_from(line, line.points[i], *other);
        if (is_longest(other->farthest(ends))) {
          return path_between(line, i, *other, first_point(*other, ends));
        }
      }
    }
    return {};
  }

  /// The ends of the first line were searched.
  [[nodiscard]] GraphPath path_between(const Line& line, std::uint32_t first, const Line& other,
                                       std::uint32_t last) const {
    const double point = line.points[first], stop = other.points[last];
    GraphPath best = {std::numeric_limits<double>::infinity(), {}, {line.number}};
    if (&line == &other) best.length = stop - point;
    const auto offer = [&](const ShortestPaths& paths, double start, std::uint32_t node,
                           double rest) {
      const double length = start + paths.distance(node) + rest;
      if (length >= best.length) return;
      best = paths.path_to(node);
      best.length = length;
      best.edges.insert(best.edges.begin(), line.number);
      best.edges.push_back(other.number);
    };
    for (const bool from_start : {true, false}) {
      const ShortestPaths& paths = from_start ? from_ : to_;
      const double start = from_start ? point : line.link.length - point;
      offer(paths, start, other.link.from, stop);
      offer(paths, start, other.link.to, other.link.length - stop);
    }
    best.first_point = first;
    best.last_point = last;
    return best;
  }

  const Network& network_;
  const PointsOf& points_of_;
  std::vector<Line> lines_;  // of the component
  ShortestPaths from_;       // from one end of a line
  ShortestPaths to_;         // from the other
  std::vector<double> min_;  // of the distances of the farthest nodes or points
  std::vector<double> max_;
  double longest_ = 0;
};

}  // namespace

std::vector<GraphPath> main_paths(std::uint32_t nodes, std::span<const Link> links,
                                  const PointsOf& points_of) {
  const Network network(nodes, links);
  const Nodes components = components_of(nodes, links);
  const std::uint32_t count =
      components.empty() ? 0 : *std::max_element(components.begin(), components.end()) + 1;
  std::vector<std::size_t> cycles(count, 1);  // links - nodes + 1
  for (const Link& link : links) ++cycles[components[link.from]];
  for (const std::uint32_t component : components) --cycles[component];
  Diameter diameter(network, points_of);
  std::vector<GraphPath> found;
  for (std::uint32_t node = 0; node < nodes; ++node) {
    if (components[node] != found.size()) continue;
    found.push_back(diameter.path_of(node, cycles[components[node]] == 0));
  }
  return found;
}

}  // namespace thinbench::detail
