// Small images are drawn on canvases, which are thinned as stacks. Others are thinned one by one,
// each by the thread that is free. Large ones that are fewer than threads are thinned by all of
// them.
#include "thinbench/many.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "core/checks.hpp"
#include "core/turns.hpp"
#include "engines/lanes.hpp"
#include "thinbench/thinning.hpp"
#include "thinning/canvases.hpp"

namespace thinbench {
namespace {

using namespace detail;

/// Image i is sources[i], and its skeleton goes to destinations[i].
struct ImageList {
  std::span<const ConstImageView> sources;
  std::span<const ImageView> destinations;
};

/// Copies a row: words of 8 bytes, of which the last two may overlap.
void copy_row(const std::uint8_t* from, std::uint8_t* to, Index count) {
  constexpr Index step = sizeof(std::uint64_t);
  const auto copy_word = [&](Index x) { std::memcpy(to + x, from + x, step); };
  if (count < step) {
    for (Index x = 0; x < count; ++x) to[x] = from[x];
    return;
  }
  for (Index x = 0; x + step < count; x += step) copy_word(x);
  copy_word(count - step);
}

/// Copies the upper left part of an image to that of another.
void copy_part(const ConstImageView& from, const ImageView& to, Index width, Index height) {
  if (from.stride == width && to.stride == width) {
    std::memcpy(to.data, from.data, static_cast<std::size_t>(width * height));
    return;
  }
  for (Index y = 0; y < height; ++y) copy_row(from.row(y), to.row(y), width);
}

/// Whether at least 16 images, which fill the widest register, fit into the L2 cache.
bool fits_lanes(const ConstImageView& image) {
  const Index pixels = image.width * image.height;
  return image.width <= kMaxLaneWidth && 0 < pixels && pixels <= Index{1} << 14;
}

/// The numbers of the images by how they are thinned.
struct Plan {
  std::vector<Canvas> canvases;  // in stacks, on canvases
  std::vector<Canvas> singles;   // each by one thread; the canvas is the image
  std::vector<Canvas> large;     // each by all threads
};

Canvas next_larger(const Canvas& canvas) {
  return {canvas_width(canvas.width), canvas_height(canvas.height), canvas.item};
}

/// Canvases of images sorted by size: of their own size where that recurs, else of one of few
/// sizes. Where `same_size`, canvas and image must have the same border, so that other images
/// become single.
void choose_canvases(Plan& plan, bool same_size) {
  constexpr Index enough = 16;  // images of one size
  const std::vector<Canvas> images = std::exchange(plan.canvases, {});
  const Canvas* const end = images.data() + images.size();
  for (const Canvas* first = images.data(); first != end;) {
    const Canvas* const last = end_of_size(first, end);
    if (last - first >= enough) {
      plan.canvases.insert(plan.canvases.end(), first, last);
    } else if (same_size) {
      plan.singles.insert(plan.singles.end(), first, last);
    } else {
      std::transform(first, last, std::back_inserter(plan.canvases), next_larger);
    }
    first = last;
  }
}

Plan plan_for(const ThinningParameters& parameters, const ImageList& images,
              const Execution& execution) {
  Plan plan;
  for (std::size_t i = 0; i < images.sources.size(); ++i) {
    const ConstImageView& image = images.sources[i];
    const Canvas canvas = {image.width, image.height, i};
    if (use_threads(image.width, image.height, execution)) {
      plan.large.push_back(canvas);
    } else {
      (fits_lanes(image) ? plan.canvases : plan.singles).push_back(canvas);
    }
  }
  sort_by_size(plan.canvases);
  // What is drawn beside an image must remain background.
  choose_canvases(plan, parameters.border == Border::keep || parameters.complemented ||
                            parameters.rule->adds_pixels());
  sort_by_size(plan.large);
  const std::size_t count = plan.large.size();
  const auto threads = static_cast<std::size_t>(available_threads(execution.threads));
  const auto shared = plan.large.end() - static_cast<std::ptrdiff_t>(count % threads);
  plan.singles.insert(plan.singles.end(), plan.large.begin(), shared);
  plan.large.erase(plan.large.begin(), shared);
  sort_by_size(plan.singles);
  return plan;
}

CanvasPainter painter_of(const ImageList& images) {
  return {[&](std::size_t i, const ImageView& canvas) {
            const ConstImageView& source = images.sources[i];
            copy_part(source, canvas, source.width, source.height);
          },
          [&](std::size_t i, const ConstImageView& canvas) {
            const ImageView& to = images.destinations[i];
            copy_part(canvas, to, to.width, to.height);
          }};
}

/// Thins images one after another, with a thinner for those of one size.
class SingleThinner {
 public:
  explicit SingleThinner(const ThinningCall& call) : call_(call.on_one_thread()) {}

  /// Returns the number of iterations.
  int operator()(const ImageList& images, const Canvas& image) {
    if (!thinner_ || image.width != width_ || image.height != height_) {
      thinner_.reset();
      thinner_.emplace(call_.rule, image.width, image.height, call_.thinning, call_.execution);
      width_ = image.width;
      height_ = image.height;
    }
    return (*thinner_)(images.sources[image.item], images.destinations[image.item]);
  }

 private:
  ThinningCall call_;
  std::optional<Thinner> thinner_;
  Index width_ = 0;
  Index height_ = 0;
};

int thin_singles(const ThinningCall& call, const ImageList& images,
                 const std::vector<Canvas>& singles, const ThreadTeam& team) {
  return maximum_in_turns(team, singles.size(), [&] {
    return [&, thin_image = SingleThinner(call)](std::size_t i) mutable {
      return thin_image(images, singles[i]);
    };
  });
}

}  // namespace

int thin_many(const Rule& rule, std::span<const ConstImageView> sources,
              std::span<const ImageView> destinations, const Thinning& thinning,
              const Execution& execution) {
  check_lists(sources, destinations);
  require_execution(execution);
  const ThinningParameters parameters = thinning_parameters(rule, thinning);
  const ThinningCall call = {rule, thinning, execution};
  const ImageList images = {sources, destinations};
  const Plan plan = plan_for(parameters, images, execution);
  int iterations = 0;
  for (const Canvas& image : plan.large) {
    iterations = std::max(
        iterations, thin(rule, sources[image.item], destinations[image.item], thinning, execution));
  }
  const std::size_t most = std::max(plan.singles.size(), plan.canvases.size());
  const ThreadTeam team(static_cast<int>(
      std::clamp<std::size_t>(most, 1, static_cast<std::size_t>(execution.threads))));
  iterations = std::max(iterations, thin_singles(call, images, plan.singles, team));
  return std::max(iterations, thin_canvases(call, plan.canvases, painter_of(images), team));
}

}  // namespace thinbench
