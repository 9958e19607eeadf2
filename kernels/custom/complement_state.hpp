// Exchanges foreground and background around another state.
#pragma once

#include <memory>
#include <utility>

#include "image/packed_rows.hpp"
#include "image/planes.hpp"
#include "thinning/state.hpp"

namespace thinbench::detail {

/// Gives the complement of its image to another state, and the complement of the result back: for
/// rules outside of whose image everything is foreground.
class ComplementState final : public ThinningState {
 public:
  ComplementState(std::unique_ptr<ThinningState> state, Index width, Index height)
      : state_(std::move(state)), plane_(width, height) {}

  void load(const ConstImageView& source) override {
    for_pixels([&](Index x, Index y, std::uint8_t& pixel) { pixel = source.row(y)[x] == 0; });
    state_->load(image());
  }
  void load(const ConstPackedView& source) override {
    read_packed(source, plane_.view());
    for_pixels([](Index, Index, std::uint8_t& pixel) { pixel ^= 1; });
    state_->load(image());
  }
  int thin() override { return state_->thin(); }
  void store(const ImageView& destination) const override {
    state_->store(image());
    for_pixels([&](Index x, Index y, std::uint8_t& pixel) {
      destination.row(y)[x] = pixel == 0 ? 255 : 0;
    });
  }
  void store(const PackedView& destination) const override {
    state_->store(image());
    for_pixels([](Index, Index, std::uint8_t& pixel) { pixel = pixel == 0; });
    write_packed(plane_.view(), destination);
  }

 private:
  [[nodiscard]] ImageView image() const {
    const BytePlaneView plane = plane_.view();
    return {plane.data, plane.width, plane.height, plane.stride};
  }
  template <class Body>
  void for_pixels(const Body& body) const {
    const BytePlaneView plane = plane_.view();
    for (Index y = 0; y < plane.height; ++y) {
      for (Index x = 0; x < plane.width; ++x) body(x, y, plane.row(y)[x]);
    }
  }

  std::unique_ptr<ThinningState> state_;
  mutable BytePlane plane_;  // a buffer
};

}  // namespace thinbench::detail
