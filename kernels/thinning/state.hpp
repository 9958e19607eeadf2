// What a plan holds: the memory of one kind of engine, and the three steps on it.
#pragma once

#include "core/convert.hpp"
#include "core/planes.hpp"
#include "core/thread_team.hpp"

namespace thinbench {

struct ThinningState {
  virtual ~ThinningState() = default;
  virtual void load(const ConstByteView& source) = 0;
  virtual int thin() = 0;
  virtual void store(const ByteView& destination) const = 0;
  /// All three.
  virtual int run(const ConstByteView& source, const ByteView& destination) {
    load(source);
    const int passes = thin();
    store(destination);
    return passes;
  }
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

/// Rows [first, last) of any view.
template <class View>
[[nodiscard]] View rows_of_view(View view, Index first, Index last) {
  view.data = view.row(first);
  view.height = last - first;
  return view;
}

/// A state that keeps its planes in `planes`. Bands of rows of large images are converted on as
/// many threads as the rest runs on.
template <class T>
struct PlaneState : ThinningState {
  PlaneState(Isa isa, Index width, Index height, int threads = 1)
      : planes(isa, width, height),
        team(threads),
        shares_bands_(width * height >= kLeastPixelsForThreads) {}

  void load(const ConstByteView& view) override {
    for_bands(view.height, [&](Index first, Index last) {
      planes.conversion.read(rows_of_view(view, first, last),
                             rows_of_view(planes.source.view(), first, last));
    });
  }
  void store(const ByteView& view) const override {
    for_bands(view.height, [&](Index first, Index last) {
      planes.conversion.write(rows_of_view(source_of_result(), first, last),
                              rows_of_view(view, first, last));
    });
  }

  [[nodiscard]] bool margins_are_zero() const override {
    return planes.source.margin_is_zero() && planes.result.margin_is_zero();
  }

  [[nodiscard]] ConstPlaneView<T> source() const { return planes.source.view(); }

  Planes<T> planes;
  ThreadTeam team;

  /// Calls `body(first, last)` on ranges of [0, height), on all threads where the image is large.
  template <class Body>
  void for_bands(Index height, const Body& body) const {
    if (shares_bands_) {
      team.for_ranges(height, body);
    } else {
      body(Index{0}, height);
    }
  }

 private:
  [[nodiscard]] ConstPlaneView<T> source_of_result() const { return planes.result.view(); }

  bool shares_bands_;
};

}  // namespace thinbench
