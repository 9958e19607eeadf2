// What a plan holds: the memory of one kind of engine, and the three steps on it.
#pragma once

#include "core/convert.hpp"
#include "core/planes.hpp"

namespace thinbench {

struct ThinningState {
  virtual ~ThinningState() = default;
  virtual void load(const ConstByteView& source) = 0;
  virtual int thin() = 0;
  virtual void store(const ByteView& destination) const = 0;
  [[nodiscard]] virtual bool margins_are_zero() const = 0;
};

/// Source and result planes with the conversions of one instruction-set level.
template <class T>
struct Planes {
  Planes(Isa isa, Index width, Index height)
      : conversion(plane_conversion<T>(isa)), source(width, height), result(width, height) {}
  const PlaneConversion<T>& conversion;
  Plane<T> source;
  Plane<T> result;
};

/// A state that keeps its planes in `planes`.
template <class T>
struct PlaneState : ThinningState {
  PlaneState(Isa isa, Index width, Index height) : planes(isa, width, height) {}

  void load(const ConstByteView& view) override {
    planes.conversion.read(view, planes.source.view());
  }
  void store(const ByteView& view) const override {
    planes.conversion.write(planes.result.view(), view);
  }
  [[nodiscard]] bool margins_are_zero() const override {
    return planes.source.margin_is_zero() && planes.result.margin_is_zero();
  }

  [[nodiscard]] ConstPlaneView<T> source() const { return planes.source.view(); }

  Planes<T> planes;
};

}  // namespace thinbench
