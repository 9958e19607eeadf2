#include <array>

#include "image/packing.hpp"

namespace thinbench::detail {
namespace {

template <class T, Isa isa>
constexpr const PlaneConversion<T>* conversion_of() {
  if constexpr (sizeof(T) == 1) {
    return &IsaConversions<isa>::kBytes;
  } else {
    return &IsaConversions<isa>::kBits;
  }
}

template <class T>
const PlaneConversion<T>& choose(Isa isa) {
  static constexpr std::array kByLevel = {
      conversion_of<T, Isa::baseline>(), conversion_of<T, Isa::sse42>(),
      conversion_of<T, Isa::avx2>(), conversion_of<T, Isa::avx512>(),
      conversion_of<T, Isa::avx512icl>()};
  return *kByLevel.at(static_cast<std::size_t>(isa));
}

}  // namespace

template <>
const PlaneConversion<std::uint8_t>& plane_conversion<std::uint8_t>(Isa isa) {
  return choose<std::uint8_t>(isa);
}

template <>
const PlaneConversion<std::uint64_t>& plane_conversion<std::uint64_t>(Isa isa) {
  return choose<std::uint64_t>(isa);
}

}  // namespace thinbench::detail
