// A file with noise, to which commands apply rules.
#pragma once

#include "harness/test_images.hpp"
#include "support/made_image.hpp"
#include "typed.hpp"

namespace thinbench {

class NoiseImage : public Commands {
 protected:
  NoiseImage() { write_grey("in.png", noise().view()); }

  /// 0 and 255.
  static ByteImage noise() {
    return mapped(noise_image(203, 70, 50, 4, 7), [](int pixel) { return pixel != 0 ? 255 : 0; });
  }
  static ByteImage applied(const Rule& rule, const Thinning& thinning = {}) {
    return thinned(rule, noise(), thinning);
  }
  /// Foreground is bright, so that nothing is remarked.
  static std::string run(const std::string& rule_and_options) {
    return output_of("run " + rule_and_options + " in.png out.png --foreground bright");
  }
};

}  // namespace thinbench
