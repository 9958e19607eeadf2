// Thinning by Leptonica's pixThinConnected, with the sets of structuring elements that it takes by
// default. No operation here gives the same pixels: it stands beside thin_guo_hall, which keeps
// topology as it does, and is compared with itself, on fresh memory.
#include <algorithm>
#include <memory>
#include <stdexcept>

#include <leptonica/allheaders.h>

#include "peers/peers.hpp"

namespace thinbench {
namespace {

struct DestroyPix {
  void operator()(PIX* pix) const { pixDestroy(&pix); }
};
using OwnedPix = std::unique_ptr<PIX, DestroyPix>;

constexpr Index kWordPixels = 32;  // the first pixel is the highest bit

l_uint32 packed(const std::uint8_t* pixels, Index count) {
  l_uint32 word = 0;
  for (Index i = 0; i < count; ++i) word |= l_uint32{pixels[i] != 0} << (kWordPixels - 1 - i);
  return word;
}

void unpack(l_uint32 word, Index count, std::uint8_t* pixels) {
  for (Index i = 0; i < count; ++i) {
    pixels[i] = (word >> (kWordPixels - 1 - i) & 1) != 0 ? 255 : 0;
  }
}

class ThinConnectedJob final : public Job {
 public:
  ThinConnectedJob(Index width, Index height, int connectivity)
      : connectivity_(connectivity),
        source_(pixCreate(static_cast<int>(width), static_cast<int>(height), 1)) {}

  void load(const ConstImageView& input) override {
    if (!source_) return;
    for (Index y = 0; y < input.height; ++y) {
      l_uint32* words = row(*source_, y);
      for (Index x = 0; x < input.width; x += kWordPixels) {
        *words++ = packed(input.row(y) + x, std::min(kWordPixels, input.width - x));
      }
    }
  }
  void kernel() override {
    if (!source_) return;
    skeleton_.reset(pixThinConnected(source_.get(), L_THIN_FG, connectivity_, 0));
    if (!skeleton_) throw std::runtime_error("Leptonica gave no skeleton");
  }
  void store(const ImageView& output) const override {
    if (!skeleton_) return;
    for (Index y = 0; y < output.height; ++y) {
      const l_uint32* words = row(*skeleton_, y);
      for (Index x = 0; x < output.width; x += kWordPixels) {
        unpack(*words++, std::min(kWordPixels, output.width - x), output.row(y) + x);
      }
    }
  }

 private:
  static l_uint32* row(PIX& pix, Index y) { return pixGetData(&pix) + y * pixGetWpl(&pix); }

  int connectivity_;
  OwnedPix source_;  // none where there are no pixels
  OwnedPix skeleton_;
};

Variant thinning_peer(std::string_view technique, std::string_view description, int connectivity) {
  const JobMaker make_job = [connectivity](Index width, Index height, int) {
    return std::make_unique<ThinConnectedJob>(width, height, connectivity);
  };
  Variant peer = peer_variant(technique, description, make_job, make_job);
  peer.has_kernel_scope = true;
  return peer;
}

}  // namespace

std::vector<Variant> leptonica_peers(const Operation& operation) {
  if (operation.name != "thin_guo_hall") return {};
  setMsgSeverity(L_SEVERITY_NONE);  // it has words for images without pixels
  return {thinning_peer("leptonica_4", "Leptonica: pixThinConnected, 4-connected objects", 4),
          thinning_peer("leptonica_8", "Leptonica: pixThinConnected, 8-connected objects", 8)};
}

std::string leptonica_description() {
  const std::unique_ptr<char, void (*)(void*)> version(getLeptonicaVersion(), &lept_free);
  return std::string(version.get()) +
         ", 1 thread, 32-bit words, the instruction sets of its package; another skeleton than any "
         "operation's, not comparable pixel by pixel and compared with itself only";
}

}  // namespace thinbench
