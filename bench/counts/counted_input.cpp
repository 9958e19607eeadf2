#include "counts/counted_input.hpp"

#include <algorithm>

namespace thinbench {
namespace {

constexpr Index kAcross = 5;
constexpr Index kDown = 16;

ByteImage small_copy_of(const ByteImage& image) {
  ByteImage few((image.width() + kAcross - 1) / kAcross, (image.height() + kDown - 1) / kDown);
  for (Index y = 0; y < few.height(); ++y) {
    for (Index x = 0; x < few.width(); ++x) few.at(x, y) = image.at(x * kAcross, y * kDown);
  }
  return few;
}

ByteImage rows_of(const ByteImage& image, Index first, Index count) {
  ConstImageView rows = image.view();
  rows.data += first * rows.stride;
  rows.height = count;
  return copy_of(rows);
}

}  // namespace

TimedInput small_copy(const TimedInput& input) {
  return {input.name + "_small", small_copy_of(input.binary), small_copy_of(input.grey)};
}

TimedInput middle_rows(const TimedInput& input, Index rows) {
  const Index count = std::min(rows, input.height());
  const Index first = (input.height() - count) / 2;
  return {input.name + "_" + std::to_string(count) + "_rows", rows_of(input.binary, first, count),
          rows_of(input.grey, first, count)};
}

}  // namespace thinbench
