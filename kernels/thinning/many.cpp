// Small images are drawn on canvases, which are thinned as stacks. Others are thinned one by one,
// each by the thread that is free, and large ones by all threads.
#include "thinning/many.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "core/checks.hpp"
#include "core/turns.hpp"
#include "engines/lanes.hpp"
#include "thinbench/batch.hpp"
#include "thinbench/thinning.hpp"
#include "thinning/canvases.hpp"

namespace thinbench {
namespace detail {
namespace {

/// Copies a row, ANDed with `mask`: words of 8 bytes, of which the last two may overlap.
void copy_row(const std::uint8_t* from, std::uint8_t* to, Index count, std::uint8_t mask) {
  constexpr Index step = sizeof(std::uint64_t);
  const std::uint64_t mask_word = mask * (~std::uint64_t{0} / 255);
  const auto copy_word = [&](Index x) {
    std::uint64_t word = 0;
    std::memcpy(&word, from + x, step);
    word &= mask_word;
    std::memcpy(to + x, &word, step);
  };
  if (count < step) {
    for (Index x = 0; x < count; ++x) to[x] = from[x] & mask;
    return;
  }
  for (Index x = 0; x + step < count; x += step) copy_word(x);
  copy_word(count - step);
}

/// Copies the upper left part of an image to that of another, ANDed with `mask`.
void copy_part(const ConstImageView& from, const ImageView& to, Index width, Index height,
               std::uint8_t mask) {
  if (from.stride == width && to.stride == width) width *= std::exchange(height, 1);
  if (height == 1 && mask == 255) {
    std::memcpy(to.data, from.data, static_cast<std::size_t>(width));
    return;
  }
  for (Index y = 0; y < height; ++y) copy_row(from.row(y), to.row(y), width, mask);
}

std::uint8_t foreground_of(const ImageList& images, std::size_t i) {
  return images.foregrounds.empty() ? 255 : images.foregrounds[i];
}

/// Replaces 255 by the foreground that image i shall have.
void set_foreground(const ImageList& images, std::size_t i) {
  const std::uint8_t foreground = foreground_of(images, i);
  const ImageView& written = images.destinations[i];
  if (foreground != 255) copy_part(written, written, written.width, written.height, foreground);
}

/// Whether all threads thin the image together, as thin() would.
bool is_large(const ConstImageView& image, const Execution& execution) {
  return execution.threads > 1 && image.width * image.height >= kMinPixelsForThreads;
}

/// Rejects what some image cannot be thinned with, before anything is written: the widest has the
/// fewest variants.
ThinningParameters validated(const ThinningCall& call, const ImageList& images) {
  require_threads(call.execution.threads);
  const ThinningParameters parameters = thinning_parameters(call.rule, call.thinning);
  Index widest = 0;
  for (const ConstImageView& image : images.sources) widest = std::max(widest, image.width);
  static_cast<void>(choose_thinning(parameters, widest, 1, call.execution));
  return parameters;
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
  std::vector<std::size_t> large;
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
    if (is_large(image, execution)) {
      plan.large.push_back(i);
    } else {
      const bool on_canvas = fits_lanes(image);
      (on_canvas ? plan.canvases : plan.singles).push_back({image.width, image.height, i});
    }
  }
  sort_by_size(plan.canvases);
  // What is drawn beside an image must remain background.
  choose_canvases(plan, parameters.border == Border::keep || parameters.complemented ||
                            parameters.rule->adds_pixels());
  sort_by_size(plan.singles);
  return plan;
}

CanvasPainter painter_of(const ImageList& images) {
  return {[&](std::size_t i, const ImageView& canvas) {
            const ConstImageView& source = images.sources[i];
            copy_part(source, canvas, source.width, source.height, 255);
          },
          [&](std::size_t i, const ConstImageView& canvas) {
            const ImageView& to = images.destinations[i];
            copy_part(canvas, to, to.width, to.height, foreground_of(images, i));
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
    const int iterations = (*thinner_)(images.sources[image.item], images.destinations[image.item]);
    set_foreground(images, image.item);
    return iterations;
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

int thin_list(const ThinningCall& call, const ImageList& images) {
  check_lists(images.sources, images.destinations);
  const ThinningParameters parameters = validated(call, images);
  const Plan plan = plan_for(parameters, images, call.execution);
  int iterations = 0;
  for (const std::size_t i : plan.large) {
    iterations = std::max(iterations, thin(call.rule, images.sources[i], images.destinations[i],
                                           call.thinning, call.execution));
    set_foreground(images, i);
  }
  const ThreadTeam team(call.execution.threads);
  iterations = std::max(iterations, thin_singles(call, images, plan.singles, team));
  return std::max(iterations, thin_canvases(call, plan.canvases, painter_of(images), team));
}

}  // namespace detail

int thin_many(const Rule& rule, std::span<const ConstImageView> sources,
              std::span<const ImageView> destinations, const Thinning& thinning,
              const Execution& execution) {
  return detail::thin_list({rule, thinning, execution}, {sources, destinations, {}});
}

}  // namespace thinbench
