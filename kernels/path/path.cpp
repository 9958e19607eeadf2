#include "thinbench/path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/byte_image.hpp"
#include "core/checks.hpp"
#include "thinbench/distance.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

using detail::require;

std::string text_of(Pixel p) {
  return "row " + std::to_string(p.y) + ", column " + std::to_string(p.x);
}

class Search {
 public:
  Search(const ConstImageView& free, const PathRequest& request, const Execution& execution)
      : width_(free.width),
        height_(free.height),
        stride_(width_ + 2),
        request_(request),
        distances_(static_cast<std::size_t>(width_ * height_)) {
    check_place("start", request.start);
    check_place("goal", request.goal);
    const View<double> distances_of_free(distances_.data(), width_, height_);
    distances(free, distances_of_free, {}, execution);
    check_room("start", request.start);
    check_room("goal", request.goal);
    detail::ByteImage skeleton(width_, height_);
    thin(Rule::guo_hall, free, skeleton.view(), {}, execution);
    prune(skeleton.view(), skeleton.view(), {.min_widths = 1, .distances = distances_of_free},
          execution);
    set_cells(skeleton);
  }

  std::optional<FoundPath> run() {
    costs_.assign(cells_.size(), std::numeric_limits<double>::infinity());
    before_.resize(cells_.size());
    offer(index_of(request_.start), 0, 0);
    const double& goal_cost = costs_[index_of(request_.goal)];
    for (std::size_t cost = 0; pending_ > 0 && goal_cost >= static_cast<double>(cost); ++cost) {
      visit_bucket(cost);
    }
    if (std::isinf(goal_cost)) return std::nullopt;
    return traced();
  }

 private:
  struct Step {
    int x, y;
    double length;
  };
  static constexpr double kDiagonal = 1.41421356237309504880;
  static constexpr std::array<Step, 8> kSteps = {{{1, 0, 1},
                                                  {1, 1, kDiagonal},
                                                  {0, 1, 1},
                                                  {-1, 1, kDiagonal},
                                                  {-1, 0, 1},
                                                  {-1, -1, kDiagonal},
                                                  {0, -1, 1},
                                                  {1, -1, kDiagonal}}};
  static constexpr std::uint8_t kHasRoom = 1;
  static constexpr std::uint8_t kIsSkeleton = 2;
  static constexpr std::uint8_t kIsClear = 4;  // diagonal steps from or to here have room, too
  static constexpr std::uint8_t kIsVisited = 8;

  /// Of cells_, which have a border, so that no step leaves them.
  [[nodiscard]] std::size_t index_of(Pixel p) const {
    return static_cast<std::size_t>((p.y + 1) * stride_ + p.x + 1);
  }
  [[nodiscard]] Pixel pixel_at(std::size_t i) const {
    const auto at = static_cast<Index>(i);
    return {static_cast<std::int32_t>(at % stride_ - 1),
            static_cast<std::int32_t>(at / stride_ - 1)};
  }
  [[nodiscard]] bool is_inside(Index x, Index y) const {
    return x >= 0 && y >= 0 && x < width_ && y < height_;
  }
  [[nodiscard]] double distance_at(Pixel p) const {
    return distances_[static_cast<std::size_t>(p.y * width_ + p.x)];
  }
  [[nodiscard]] bool is_obstacle(Pixel p) const {
    return is_inside(p.x, p.y) && distance_at(p) == 0;
  }
  [[nodiscard]] bool has_room(double distance) const {
    return distance > 0 && 2 * distance >= request_.width;
  }

  void check_place(const char* name, Pixel p) const {
    require(is_inside(p.x, p.y), std::string(name) + ": " + text_of(p) + " is outside the map of " +
                                     detail::size_text(width_, height_) + " pixels");
  }
  void check_room(const char* name, Pixel p) const {
    const double distance = distance_at(p);
    require(distance > 0, std::string(name) + ": " + text_of(p) + " is inside an obstacle");
    require(has_room(distance), std::string(name) + ": at " + text_of(p) +
                                    " there is room for a width of " +
                                    detail::number_text(2 * distance) + ", not of " +
                                    detail::number_text(request_.width));
  }

  void set_cells(const detail::ByteImage& skeleton) {
    cells_.assign(static_cast<std::size_t>(stride_ * (height_ + 2)), 0);
    for (std::int32_t y = 0; y < height_; ++y) {
      for (std::int32_t x = 0; x < width_; ++x) {
        const double distance = distance_at({x, y});
        const double middle = std::sqrt(distance * distance - 0.5);  // not a number in obstacles
        const int has = has_room(distance) ? kHasRoom : 0;
        const int is_skeleton = skeleton.at(x, y) != 0 ? kIsSkeleton : 0;
        const int is_clear = distance > 1 && has_room(middle) ? kIsClear : 0;
        cells_[index_of({x, y})] = static_cast<std::uint8_t>(has | is_skeleton | is_clear);
      }
    }
  }

  /// How far the middle of a diagonal step is from the obstacles that are nearer to it than to its
  /// ends. These lie on the other diagonal, equally far from both ends, so they are the nearest of
  /// the end that is farther from obstacles.
  [[nodiscard]] double distance_in_middle(Pixel p, const Step& step) const {
    const double end = std::max(distance_at(p), distance_at({p.x + step.x, p.y + step.y}));
    if (std::isinf(end)) return end;
    const double across = std::sqrt(end * end - 0.5);
    const auto k = static_cast<int>(std::lround(across * kDiagonal + 1)) / 2;
    const bool is_nearest = std::abs((2 * k - 1) / kDiagonal - across) < 1e-6;
    const bool is_met = is_obstacle({p.x + k * step.x, p.y + (1 - k) * step.y}) ||
                        is_obstacle({p.x + (1 - k) * step.x, p.y + k * step.y});
    return is_nearest && is_met ? across : std::numeric_limits<double>::infinity();
  }

  /// Whether there is room all along a diagonal step between two pixels that have it.
  [[nodiscard]] bool may_cross(Pixel p, const Step& step) const {
    if (is_obstacle({p.x + step.x, p.y}) && is_obstacle({p.x, p.y + step.y})) return false;
    return has_room(distance_in_middle(p, step));
  }

  void offer(std::size_t at, double cost, std::uint8_t step) {
    if (cost >= costs_[at]) return;
    costs_[at] = cost;
    before_[at] = step;
    buckets_[static_cast<std::size_t>(cost) % buckets_.size()].push_back(
        static_cast<std::uint32_t>(at));
    ++pending_;
  }

  /// Pixels whose cost rounds down to this. As a step costs at least 1, none changes the cost of
  /// another of them.
  void visit_bucket(std::size_t cost) {
    std::vector<std::uint32_t>& bucket = buckets_[cost % buckets_.size()];
    pending_ -= bucket.size();
    for (const std::uint32_t at : bucket) {
      if ((cells_[at] & kIsVisited) == 0) visit(at);
      cells_[at] |= kIsVisited;
    }
    bucket.clear();
  }

  void visit(std::size_t at) {
    const std::uint8_t cell = cells_[at];
    for (std::size_t k = 0; k < kSteps.size(); ++k) {
      const Step& step = kSteps[k];
      const std::size_t to = at + static_cast<std::size_t>(step.y * stride_ + step.x);
      if ((cells_[to] & kHasRoom) == 0) continue;
      const bool needs_check = k % 2 == 1 && ((cell | cells_[to]) & kIsClear) == 0;
      if (needs_check && !may_cross(pixel_at(at), step)) continue;
      const bool on_skeleton = (cell & cells_[to] & kIsSkeleton) != 0;
      offer(to, costs_[at] + step.length * (on_skeleton ? 1 : kPathOffSkeletonCost),
            static_cast<std::uint8_t>(k));
    }
  }

  [[nodiscard]] FoundPath traced() const {
    FoundPath path = {{request_.goal}, 0, 2 * distance_at(request_.goal)};
    while (!(path.pixels.back() == request_.start)) {
      const Pixel p = path.pixels.back();
      const Step& step = kSteps[before_[index_of(p)]];
      const Pixel before = {p.x - step.x, p.y - step.y};
      double distance = distance_at(before);
      if (step.length > 1) distance = std::min(distance, distance_in_middle(before, step));
      path.length += step.length;
      path.pixels.push_back(before);
      path.min_width = std::min(path.min_width, 2 * distance);
    }
    std::reverse(path.pixels.begin(), path.pixels.end());
    return path;
  }

  Index width_;
  Index height_;
  Index stride_;
  PathRequest request_;
  std::vector<double> distances_;
  std::vector<std::uint8_t> cells_;
  std::vector<double> costs_;
  std::vector<std::uint8_t> before_;                   // the step by which a pixel was reached
  std::array<std::vector<std::uint32_t>, 8> buckets_;  // by cost, in turn: a step costs less than 6
  std::size_t pending_ = 0;                            // entries of the buckets
};

}  // namespace

std::optional<FoundPath> find_path(ConstImageView free, const PathRequest& request,
                                   const Execution& execution) {
  detail::check(detail::memory_of("free", free));
  require(request.width >= 0 && std::isfinite(request.width),
          "width: expected a finite number from 0 up, got " + detail::number_text(request.width));
  require(std::max(free.width, free.height) <= kMaxDistanceSide,
          "map: expected sides of at most " + std::to_string(kMaxDistanceSide) + ", got " +
              detail::size_text(free.width, free.height));
  return Search(free, request, execution).run();
}

}  // namespace thinbench
