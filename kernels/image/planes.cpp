#include "image/planes.hpp"

#include "image/layout.hpp"

namespace thinbench::detail {
namespace {

template <class T>
constexpr Index kElementsPerBlock = static_cast<Index>(kAlignment / sizeof(T));

template <class T>
constexpr Index row_elements_for(Index width) {
  constexpr Index pixels_per_element = sizeof(T) == 1 ? 1 : kWordBits;
  return round_up(round_up(width, pixels_per_element) / pixels_per_element, kElementsPerBlock<T>);
}

}  // namespace

template <class T>
Plane<T>::Plane(Index width, Index height) {
  // One block between rows is the margin after one row and before the next.
  constexpr Index block = kElementsPerBlock<T>;
  const Index row_elements = row_elements_for<T>(width);
  constexpr Index element_bytes = static_cast<Index>(sizeof(T));
  const Index stride = padded_row_bytes((row_elements + block) * element_bytes) / element_bytes;
  const Index storage = block + (height + 2 * kMarginRows) * stride;
  data_ = make_aligned<T>(static_cast<std::size_t>(storage));
  view_ = {data_.get() + block + kMarginRows * stride, width, height, stride, row_elements};
}

template class Plane<std::uint8_t>;
template class Plane<std::uint64_t>;

}  // namespace thinbench::detail
