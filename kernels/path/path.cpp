#include "thinbench/path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <string>
#include <utility>

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
        request_(request),
        distances_(static_cast<std::size_t>(free.width * free.height)),
        skeleton_(free.width, free.height) {
    check_place("start", request.start);
    check_place("goal", request.goal);
    const View<double> distances_of_free(distances_.data(), width_, height_);
    distances(free, distances_of_free, {}, execution);
    check_room("start", request.start);
    check_room("goal", request.goal);
    thin(Rule::guo_hall, free, skeleton_.view(), {}, execution);
    prune(skeleton_.view(), skeleton_.view(), {.min_widths = 1, .distances = distances_of_free},
          execution);
  }

  std::optional<FoundPath> run() {
    costs_.assign(distances_.size(), std::numeric_limits<double>::infinity());
    before_.assign(distances_.size(), 8);
    offer(index_of(request_.start), 0, 8);
    while (!open_.empty()) {
      const auto [cost, at] = open_.top();
      open_.pop();
      if (at == index_of(request_.goal)) return traced();
      if (cost == costs_[at]) visit(at);
    }
    return std::nullopt;
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

  [[nodiscard]] std::size_t index_of(Pixel p) const {
    return static_cast<std::size_t>(p.y * width_ + p.x);
  }
  [[nodiscard]] Pixel pixel_at(std::size_t i) const {
    const auto at = static_cast<Index>(i);
    return {static_cast<std::int32_t>(at % width_), static_cast<std::int32_t>(at / width_)};
  }
  [[nodiscard]] bool is_inside(Index x, Index y) const {
    return x >= 0 && y >= 0 && x < width_ && y < height_;
  }
  [[nodiscard]] bool is_skeleton(Pixel p) const { return skeleton_.at(p.x, p.y) != 0; }
  [[nodiscard]] double room_at(std::size_t i) const { return 2 * distances_[i]; }
  [[nodiscard]] bool has_room(std::size_t i) const {
    return distances_[i] > 0 && room_at(i) >= request_.width;
  }

  void check_place(const char* name, Pixel p) const {
    require(is_inside(p.x, p.y), std::string(name) + ": " + text_of(p) + " is outside the map of " +
                                     detail::size_text(width_, height_) + " pixels");
  }
  void check_room(const char* name, Pixel p) const {
    const std::size_t at = index_of(p);
    require(distances_[at] > 0, std::string(name) + ": " + text_of(p) + " is inside an obstacle");
    require(has_room(at), std::string(name) + ": at " + text_of(p) +
                              " there is room for a width of " + detail::number_text(room_at(at)) +
                              ", not of " + detail::number_text(request_.width));
  }

  void offer(std::size_t at, double cost, std::uint8_t step) {
    if (cost >= costs_[at]) return;
    costs_[at] = cost;
    before_[at] = step;
    open_.emplace(cost, at);
  }

  void visit(std::size_t at) {
    const Pixel p = pixel_at(at);
    for (std::uint8_t k = 0; k < kSteps.size(); ++k) {
      const Step& step = kSteps[k];
      if (!is_inside(p.x + step.x, p.y + step.y)) continue;
      const Pixel next = {p.x + step.x, p.y + step.y};
      const std::size_t to = index_of(next);
      if (!has_room(to)) continue;
      const bool on_skeleton = is_skeleton(p) && is_skeleton(next);
      offer(to, costs_[at] + step.length * (on_skeleton ? 1 : kPathOffSkeletonCost), k);
    }
  }

  [[nodiscard]] FoundPath traced() const {
    FoundPath path = {{request_.goal}, 0, room_at(index_of(request_.goal))};
    while (!(path.pixels.back() == request_.start)) {
      const Pixel p = path.pixels.back();
      const Step& step = kSteps[before_[index_of(p)]];
      path.length += step.length;
      path.pixels.push_back({p.x - step.x, p.y - step.y});
      path.min_width = std::min(path.min_width, room_at(index_of(path.pixels.back())));
    }
    std::reverse(path.pixels.begin(), path.pixels.end());
    return path;
  }

  using Entry = std::pair<double, std::size_t>;  // the cost first

  Index width_;
  Index height_;
  PathRequest request_;
  std::vector<double> distances_;
  detail::ByteImage skeleton_;
  std::vector<double> costs_;
  std::vector<std::uint8_t> before_;  // the step by which a pixel was reached
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace

std::optional<FoundPath> find_path(ConstImageView free, const PathRequest& request,
                                   const Execution& execution) {
  detail::check_views(free, free, detail::InPlace::allowed);
  require(request.width >= 0 && std::isfinite(request.width),
          "width: expected a finite number from 0 up, got " + detail::number_text(request.width));
  require(std::max(free.width, free.height) <= kMaxDistanceSide,
          "map: expected sides of at most " + std::to_string(kMaxDistanceSide) + ", got " +
              detail::size_text(free.width, free.height));
  return Search(free, request, execution).run();
}

}  // namespace thinbench
