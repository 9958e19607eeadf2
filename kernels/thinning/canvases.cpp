#include "thinning/canvases.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

#include "core/turns.hpp"
#include "thinbench/many.hpp"

namespace thinbench::detail {
namespace {

/// Canvases of one size.
using CanvasGroup = std::span<const Canvas>;

/// Groups that fit into the L2 cache, of canvases sorted by size.
std::vector<CanvasGroup> groups_of(const std::vector<Canvas>& canvases) {
  constexpr Index bytes = Index{1} << 18;
  std::vector<CanvasGroup> groups;
  const Canvas* const end = canvases.data() + canvases.size();
  for (const Canvas* first = canvases.data(); first != end;) {
    const Index room = std::max<Index>(1, bytes / (first->width * first->height));
    const Canvas* const last = end_of_size(first, first + std::min<Index>(room, end - first));
    groups.emplace_back(first, last);
    first = last;
  }
  return groups;
}

/// Thins groups in its own memory.
class CanvasThinner {
 public:
  CanvasThinner(const ThinningCall& call, const CanvasPainter& painter)
      : call_(call.on_one_thread()), painter_(painter) {}

  /// Returns the maximum number of iterations.
  int operator()(const CanvasGroup& group) {
    prepare(group);
    for (std::size_t i = 0; i < group.size(); ++i) {
      painter_.draw(group[i].item, images_.image(static_cast<Index>(i)));
    }
    const int iterations = (*thinner_)(images_, images_);
    for (std::size_t i = 0; i < group.size(); ++i) {
      painter_.take(group[i].item, images_.image(static_cast<Index>(i)));
    }
    return iterations;
  }

 private:
  /// Makes canvases of zeros.
  void prepare(const CanvasGroup& group) {
    const Canvas& first = group.front();
    const auto count = static_cast<Index>(group.size());
    if (!thinner_ || first.width != images_.width || first.height != images_.height) {
      thinner_.reset();
      thinner_.emplace(call_.rule, first.width, first.height, call_.thinning, call_.execution);
    }
    pixels_.assign(static_cast<std::size_t>(first.width * first.height * count), 0);
    images_ = {pixels_.data(), count, first.width, first.height};
  }

  ThinningCall call_;
  const CanvasPainter& painter_;
  std::optional<StackThinner> thinner_;
  std::vector<std::uint8_t> pixels_;
  StackView images_;
};

}  // namespace

Index canvas_width(Index width) {
  if (width <= 32) return 32;
  return width <= 64 ? 64 : (width + 63) / 64 * 64;
}

Index canvas_height(Index height) {
  const Index step = height <= 128 ? 8 : 64;
  return (height + step - 1) / step * step;
}

void sort_by_size(std::vector<Canvas>& canvases) {
  const auto is_larger = [](const Canvas& a, const Canvas& b) {
    return a.width != b.width ? a.width > b.width : a.height > b.height;
  };
  if (std::is_sorted(canvases.begin(), canvases.end(), is_larger)) return;
  std::stable_sort(canvases.begin(), canvases.end(), is_larger);
}

const Canvas* end_of_size(const Canvas* first, const Canvas* last) {
  return std::find_if(first, last, [first](const Canvas& other) {
    return other.width != first->width || other.height != first->height;
  });
}

int thin_canvases(const ThinningCall& call, std::vector<Canvas> canvases,
                  const CanvasPainter& painter, const ThreadTeam& team) {
  sort_by_size(canvases);
  const std::vector<CanvasGroup> groups = groups_of(canvases);
  return maximum_in_turns(team, groups.size(), [&] {
    return [&, thin_group = CanvasThinner(call, painter)](std::size_t i) mutable {
      return thin_group(groups[i]);
    };
  });
}

}  // namespace thinbench::detail
