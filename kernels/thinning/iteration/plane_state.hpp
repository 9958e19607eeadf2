// States that hold the image in a plane. They pack and unpack it by bands of rows.
#pragma once

#include "image/packed_rows.hpp"
#include "image/packing.hpp"
#include "image/planes.hpp"
#include "image/thread_team.hpp"
#include "thinning/state.hpp"

namespace thinbench::detail {

/// The source and result planes, and the conversions of one ISA.
template <class T>
struct Planes {
  Planes(Isa isa, Index width, Index height)
      : conversion(plane_conversion<T>(isa)), source(width, height), result(width, height) {}
  const PlaneConversion<T>& conversion;
  Plane<T> source;
  Plane<T> result;
};

/// Rows [first, last) of a view.
template <class View>
[[nodiscard]] View rows_of_view(View view, Index first, Index last) {
  view.data = view.row(first);
  view.height = last - first;
  return view;
}

/// Divides the rows of large images among threads.
class BandTeam {
 public:
  BandTeam(Index width, Index height, int threads)
      : team_(threads), is_large_(width * height >= kMinPixelsForThreads) {}

  [[nodiscard]] ThreadTeam& threads() { return team_; }

  /// Calls `body(first, last)` on ranges that partition [0, count): one per thread for large
  /// images, else one.
  template <class Body>
  void for_bands(Index count, const Body& body) const {
    if (is_large_) {
      team_.for_ranges(count, body);
    } else {
      body(Index{0}, count);
    }
  }

 private:
  ThreadTeam team_;
  bool is_large_;
};

template <class T>
void read_planes(const BandTeam& team, const ConstImageView& view, Planes<T>& planes) {
  team.for_bands(view.height, [&](Index first, Index last) {
    planes.conversion.read(rows_of_view(view, first, last),
                           rows_of_view(planes.source.view(), first, last));
  });
}

template <class T>
void read_planes(const BandTeam& team, const ConstPackedView& view, Planes<T>& planes) {
  team.for_bands(view.height, [&](Index first, Index last) {
    read_packed(rows_of_view(view, first, last), rows_of_view(planes.source.view(), first, last));
  });
}

/// The function that writes rows of an image with `pixels` pixels. Large images use non-temporal
/// stores.
template <class T>
[[nodiscard]] auto row_writer(const PlaneConversion<T>& conversion, Index pixels) {
  return pixels >= kNonTemporalBytes ? conversion.write_non_temporal : conversion.write;
}

template <class T>
void write_planes(const BandTeam& team, const Planes<T>& planes, const ImageView& view) {
  const auto write = row_writer(planes.conversion, view.width * view.height);
  team.for_bands(view.height, [&](Index first, Index last) {
    write(rows_of_view(planes.result.view(), first, last), rows_of_view(view, first, last));
  });
}

template <class T>
void write_planes(const BandTeam& team, const Planes<T>& planes, const PackedView& view) {
  team.for_bands(view.height, [&](Index first, Index last) {
    write_packed(rows_of_view(planes.result.view(), first, last), rows_of_view(view, first, last));
  });
}

/// Implements load() and store(); derived classes implement thin() with the same threads.
template <class T>
struct PlaneState : ThinningState {
  explicit PlaneState(const ThinningSetting& setting)
      : planes(setting.isa, setting.width, setting.height),
        bands(setting.width, setting.height, setting.threads),
        team(bands.threads()) {}

  void load(const ConstImageView& view) override { read_planes(bands, view, planes); }
  void load(const ConstPackedView& view) override { read_planes(bands, view, planes); }
  void store(const ImageView& view) const override { write_planes(bands, planes, view); }
  void store(const PackedView& view) const override { write_planes(bands, planes, view); }

  /// The loaded image.
  [[nodiscard]] ConstPlaneView<T> source() const { return planes.source.view(); }

  Planes<T> planes;
  BandTeam bands;
  ThreadTeam& team;
};

}  // namespace thinbench::detail
