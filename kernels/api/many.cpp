// Small images are drawn on canvases, which are thinned as stacks. Others are thinned one by one,
// each by the thread that is free, and large ones by all threads.
#include "api/many.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "api/canvases.hpp"
#include "api/catalogue.hpp"
#include "api/turns.hpp"
#include "image/checks.hpp"
#include "thinbench/batch.hpp"
#include "thinbench/thinning.hpp"
#include "thinning/engines/lane_kernels.hpp"

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
bool is_large(const ConstImageView& image, const Options& options) {
  return options.threads > 1 && !options.technique &&
         image.width * image.height >= kMinPixelsForThreads;
}

/// Rejects options: the widest image has the fewest techniques.
void check_options(Rule rule, const ImageList& images, const Options& options) {
  require_threads(options.threads);
  Index widest = 0;
  for (const ConstImageView& image : images.sources) {
    if (is_large(image, options)) {
      static_cast<void>(choose(operation_of(rule), image.width, image.height, options));
    }
    widest = std::max(widest, image.width);
  }
  Options single = options;
  single.threads = 1;
  const Thinner checked(rule, widest, 1, single);
}

/// Whether images of the rule can be thinned in lanes.
bool has_lanes(Rule rule, const Options& options) {
  Options single = options;
  single.threads = 1;
  return !ThinningBatch(rule, 1, 1, single).one_by_one();
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
/// sizes. Where the border is kept, canvas and image must have the same border, so that other
/// images become single.
void choose_canvases(Plan& plan, bool keep_border) {
  constexpr Index enough = 16;  // images of one size
  const std::vector<Canvas> images = std::exchange(plan.canvases, {});
  const Canvas* const end = images.data() + images.size();
  for (const Canvas* first = images.data(); first != end;) {
    const Canvas* const last = end_of_size(first, end);
    if (last - first >= enough) {
      plan.canvases.insert(plan.canvases.end(), first, last);
    } else if (keep_border) {
      plan.singles.insert(plan.singles.end(), first, last);
    } else {
      std::transform(first, last, std::back_inserter(plan.canvases), next_larger);
    }
    first = last;
  }
}

Plan plan_for(Rule rule, const ImageList& images, const Options& options) {
  const bool lanes = has_lanes(rule, options);
  Plan plan;
  for (std::size_t i = 0; i < images.sources.size(); ++i) {
    const ConstImageView& image = images.sources[i];
    if (is_large(image, options)) {
      plan.large.push_back(i);
    } else {
      const bool on_canvas = lanes && fits_lanes(image);
      (on_canvas ? plan.canvases : plan.singles).push_back({image.width, image.height, i});
    }
  }
  sort_by_size(plan.canvases);
  choose_canvases(plan, options.border == Border::keep);
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
  SingleThinner(Rule rule, const Options& options) : rule_(rule), options_(options) {
    options_.threads = 1;
  }

  /// Returns the number of iterations.
  int operator()(const ImageList& images, const Canvas& image) {
    if (!thinner_ || image.width != width_ || image.height != height_) {
      thinner_.reset();
      thinner_.emplace(rule_, image.width, image.height, options_);
      width_ = image.width;
      height_ = image.height;
    }
    const int iterations = (*thinner_)(images.sources[image.item], images.destinations[image.item]);
    set_foreground(images, image.item);
    return iterations;
  }

 private:
  Rule rule_;
  Options options_;
  std::optional<Thinner> thinner_;
  Index width_ = 0;
  Index height_ = 0;
};

int thin_singles(Rule rule, const ImageList& images, const std::vector<Canvas>& singles,
                 const Options& options, const ThreadTeam& team) {
  return maximum_in_turns(team, singles.size(), [&] {
    return [&, thin_image = SingleThinner(rule, options)](std::size_t i) mutable {
      return thin_image(images, singles[i]);
    };
  });
}

}  // namespace

int thin_list(Rule rule, const ImageList& images, const Options& options) {
  check_lists(images.sources, images.destinations);
  check_options(rule, images, options);
  const Plan plan = plan_for(rule, images, options);
  int iterations = 0;
  for (const std::size_t i : plan.large) {
    iterations =
        std::max(iterations, thin(rule, images.sources[i], images.destinations[i], options));
    set_foreground(images, i);
  }
  const ThreadTeam team(options.threads);
  iterations = std::max(iterations, thin_singles(rule, images, plan.singles, options, team));
  return std::max(iterations,
                  thin_canvases(rule, plan.canvases, options, painter_of(images), team));
}

}  // namespace detail

int thin_many(Rule rule, std::span<const ConstImageView> sources,
              std::span<const ImageView> destinations, const Options& options) {
  return detail::thin_list(rule, {sources, destinations, {}}, options);
}

}  // namespace thinbench
