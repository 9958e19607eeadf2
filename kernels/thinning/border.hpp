// What thinning takes for granted beyond the image.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace thinbench::detail {

enum class Border : std::uint8_t {
  background,  // everything outside the image is light
  keep,        // as OpenCV: the outermost rows and columns never change
};

inline constexpr std::array<std::string_view, 2> kBorderNames = {"background", "keep"};

[[nodiscard]] constexpr std::string_view border_name(Border border) {
  return kBorderNames[static_cast<std::size_t>(border)];
}

}  // namespace thinbench::detail
