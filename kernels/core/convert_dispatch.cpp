#include <array>

#include "core/convert.hpp"

namespace thinbench {
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
      conversion_of<T, Isa::kBaseline>(), conversion_of<T, Isa::kSse42>(),
      conversion_of<T, Isa::kAvx2>(), conversion_of<T, Isa::kAvx512>(),
      conversion_of<T, Isa::kAvx512Icl>()};
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

}  // namespace thinbench
