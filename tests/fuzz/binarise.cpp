// Foreground of grey images and channels of colours: pixels by the plain formulas; a rejected call
// says why in one line and writes nothing.
#include "thinbench/binarise.hpp"

#include <cmath>
#include <stdexcept>

#include "drawn_image.hpp"

namespace thinbench {
namespace {

Binarisation draw_request(ByteSource& input) {
  constexpr std::array windows = {0, 3, 5, 15, 31, 65535, 65537, 4, 1, -3};
  Binarisation request;
  request.foreground = static_cast<Foreground>(input.number(0, input.once_in(32) ? 4 : 2));
  if (input.once_in(2)) request.threshold = static_cast<int>(input.number(-1, 256));
  if (input.once_in(request.threshold ? 32 : 2)) {
    request.local = {input.pick(windows), static_cast<int>(input.number(-1, 256))};
    if (input.once_in(4)) request.local->offset.reset();
  }
  return request;
}

/// Of the part of the window around a pixel that is in the image, by the sum and the number.
bool deviates(const ConstImageView& grey, Index x, Index y, const Binarised& found, int offset) {
  const Index reach = found.window / 2;
  Index sum = 0;
  Index count = 0;
  for (Index v = std::max<Index>(0, y - reach); v <= std::min(grey.height - 1, y + reach); ++v) {
    for (Index u = std::max<Index>(0, x - reach); u <= std::min(grey.width - 1, x + reach); ++u) {
      sum += grey.row(v)[u];
      ++count;
    }
  }
  const Index level = grey.row(y)[x] * count;
  return found.foreground == Foreground::bright ? level > sum + offset * count
                                                : level < sum - offset * count;
}

bool is_foreground(const ConstImageView& grey, Index x, Index y, const Binarised& found,
                   const Binarisation& request) {
  if (request.local) return deviates(grey, x, y, found, request.local->offset.value_or(10));
  return (grey.row(y)[x] >= found.threshold) == (found.foreground == Foreground::bright);
}

void check_summary(const Binarised& found, const Binarisation& request) {
  must(found.foreground != Foreground::automatic, "no side was chosen");
  must(request.foreground == Foreground::automatic || found.foreground == request.foreground,
       "another side than the one asked for");
  must(found.threshold == request.threshold.value_or(found.threshold), "another threshold");
  must(0 <= found.separation && found.separation <= 1 + 1e-9, "no share of the variance");
  must(0 <= found.undecided_share && found.undecided_share <= 1, "no share of the pixels");
}

/// Local thresholds of large images take the plain method too long.
DrawnSize draw_moderate_size(ByteSource& input) {
  const auto [width, height] = draw_size(input);
  return {std::min<Index>(width, 66), std::min<Index>(height, 40)};
}

/// `call` changes nothing, or does what it says.
template <class Call>
bool succeeds(const ImageView& destination, const Call& call) {
  const ByteImage before = copy_of(destination);
  bool done = false;
  must_succeed_or_explain<std::invalid_argument>([&] {
    call();
    done = true;
  });
  if (!done) must_be_equal(destination, before.view(), "the destination of a rejected call");
  return done;
}

void check_binarise(ByteSource& input) {
  const Binarisation request = draw_request(input);
  const ByteImage grey = draw_grey(input, draw_moderate_size(input));
  DrawnPair images(input, grey.view());
  Binarised found;
  const auto call = [&] { found = binarise(images.source.view(), images.to(), request); };
  if (!succeeds(images.to(), call)) return;
  check_summary(found, request);
  Index count = 0;
  for (Index y = 0; y < grey.height(); ++y) {
    for (Index x = 0; x < grey.width(); ++x) {
      const bool expected = is_foreground(grey.view(), x, y, found, request);
      must(images.to().row(y)[x] == (expected ? 255 : 0), "a pixel is on the other side");
      count += expected ? 1 : 0;
    }
  }
  const Index pixels = grey.width() * grey.height();
  must(pixels == 0 || found.foreground_share == double(count) / double(pixels), "another share");
  images.must_be_intact();
}

int level_of(const std::uint8_t* p, Channel channel) {
  const int max = std::max({p[0], p[1], p[2]});
  const int min = std::min({p[0], p[1], p[2]});
  switch (channel) {
    case Channel::grey:
      return static_cast<int>(std::floor(0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2] + 0.5));
    case Channel::saturation:
      return max == 0 ? 0 : static_cast<int>(std::floor(255.0 * (max - min) / max + 0.5));
    case Channel::value:
      return max;
    default:
      return p[static_cast<int>(channel) - 1];
  }
}

void check_channel(ByteSource& input) {
  const auto channel = static_cast<Channel>(input.number(0, input.once_in(32) ? 8 : 6));
  const int samples = static_cast<int>(input.once_in(32) ? input.byte() % 7 : input.number(3, 4));
  const DrawnSize size = draw_moderate_size(input);
  const ByteImage bytes = draw_grey(input, {samples * size.width, size.height});
  DrawnImage colours(input, {samples * size.width, size.height});
  colours.copy_from(bytes.view());
  const ImageView view = colours.view();
  DrawnImage levels(input, size);
  Channel chosen = Channel::automatic;
  const auto call = [&] {
    chosen = select_channel({view.data, size.width, size.height, view.stride, samples},
                            levels.view(), channel);
  };
  if (!succeeds(levels.view(), call)) return;
  must(chosen != Channel::automatic, "no channel was chosen");
  bool has_colours = false;
  for (Index y = 0; y < size.height; ++y) {
    for (Index x = 0; x < size.width; ++x) {
      const std::uint8_t* const p = bytes.view().row(y) + samples * x;
      const int difference = levels.view().row(y)[x] - level_of(p, chosen);
      must(std::abs(difference) <= (chosen == Channel::grey ? 1 : 0), "another level");
      has_colours = has_colours || p[0] != p[1] || p[1] != p[2];
    }
  }
  must(chosen == (has_colours ? channel : Channel::grey) ||
           (has_colours && channel == Channel::automatic),
       "another channel than the one asked for");
  levels.must_be_intact();
  colours.must_be_intact();
}

}  // namespace

void try_input(ByteSource& input) {
  if (input.once_in(2)) {
    check_channel(input);
  } else {
    check_binarise(input);
  }
}

}  // namespace thinbench
