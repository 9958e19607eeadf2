#include "harness/crosscheck.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace thinbench {
namespace {

/// A view into a buffer with guards round it, at an odd stride and alignment.
class Guarded {
 public:
  static constexpr std::uint8_t kGuard = 0xA5;

  Guarded(Index width, Index height, Index extra)
      : stride_(width + 2 * extra + 1),
        extra_(extra),
        width_(width),
        height_(height),
        bytes_(static_cast<std::size_t>(stride_ * (height + 2)), kGuard) {}

  [[nodiscard]] ByteView view() {
    return {bytes_.data() + stride_ + extra_, width_, height_, stride_};
  }

  void copy_from(const ConstByteView& image) {
    for (Index y = 0; y < height_; ++y) std::copy_n(image.row(y), width_, view().row(y));
  }

  /// True where every byte outside the view is as it was.
  [[nodiscard]] bool intact() const {
    for (Index i = 0; i < static_cast<Index>(bytes_.size()); ++i) {
      const Index y = i / stride_ - 1;
      const Index x = i % stride_ - extra_;
      const bool inside = x >= 0 && x < width_ && y >= 0 && y < height_;
      if (!inside && bytes_[static_cast<std::size_t>(i)] != kGuard) return false;
    }
    return true;
  }

 private:
  Index stride_;
  Index extra_;
  Index width_;
  Index height_;
  std::vector<std::uint8_t> bytes_;
};

std::optional<std::string> first_difference(const ConstByteView& expected,
                                            const ConstByteView& found) {
  for (Index y = 0; y < expected.height; ++y) {
    for (Index x = 0; x < expected.width; ++x) {
      if (expected.row(y)[x] == found.row(y)[x]) continue;
      return "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") is " +
             std::to_string(found.row(y)[x]) + " instead of " + std::to_string(expected.row(y)[x]) +
             "\nreference:\n" + window_text(expected, x, y) + "variant:\n" +
             window_text(found, x, y);
    }
  }
  return std::nullopt;
}

}  // namespace

std::string row_name(std::string_view operation, const ThinningVariant& variant, int threads) {
  return std::string(operation) + "/" + std::string(technique_name(variant.technique)) + "/" +
         std::string(isa_name(variant.isa)) + "/" + std::to_string(threads);
}

Expected expected_of(std::string_view operation, const ConstByteView& input) {
  const reference::Thinning function = reference::find_thinning(operation);
  if (function == nullptr) throw std::logic_error(std::string(operation) + " has no reference");
  Expected expected{ByteImage(input.width, input.height), 0};
  expected.passes = function(input, expected.skeleton.view());
  return expected;
}

std::optional<std::string> find_mismatch(ThinningPlan& plan, const ConstByteView& input,
                                         const Expected& expected) {
  Guarded source(input.width, input.height, 3);
  Guarded destination(input.width, input.height, 5);
  const ByteImage garbage = noise_image(input.width, input.height, 45, 1, 99);
  plan.run(garbage.view(), destination.view());
  source.copy_from(input);
  destination.copy_from(garbage.view());
  const int passes = plan.run(source.view(), destination.view());
  if (auto difference = first_difference(expected.skeleton.view(), destination.view())) {
    return difference;
  }
  if (passes != expected.passes) {
    return "passes: " + std::to_string(passes) + " instead of " + std::to_string(expected.passes);
  }
  if (!source.intact() || !equal(source.view(), input)) return "the input was changed";
  if (!destination.intact()) return "bytes beside the destination were changed";
  if (!plan.margins_are_zero()) return "the margin of a plane was changed";
  return std::nullopt;
}

std::string window_text(const ConstByteView& image, Index x, Index y) {
  constexpr Index reach = 4;
  std::string text;
  for (Index row = std::max<Index>(0, y - reach); row <= std::min(image.height - 1, y + reach);
       ++row) {
    text += "  ";
    for (Index column = std::max<Index>(0, x - reach);
         column <= std::min(image.width - 1, x + reach); ++column) {
      text += image.row(row)[column] != 0 ? '#' : '.';
    }
    text += '\n';
  }
  return text;
}

}  // namespace thinbench
