// States that hold the image in a plane. They pack and unpack it by bands of rows.
#pragma once

#include <utility>

#include "core/packed_rows.hpp"
#include "core/packing.hpp"
#include "core/planes.hpp"
#include "core/thread_team.hpp"
#include "engines/state.hpp"

namespace thinbench::detail {

/// The source and result planes, and the conversions of one ISA.
template <class T>
struct Planes {
  Planes(Isa isa, Plane<T> source_plane, Plane<T> result_plane)
      : conversion(plane_conversion<T>(isa)),
        source(std::move(source_plane)),
        result(std::move(result_plane)) {}
  Planes(Isa isa, Index width, Index height)
      : Planes(isa, Plane<T>(width, height), Plane<T>(width, height)) {}
  const PlaneConversion<T>& conversion;
  Plane<T> source;
  Plane<T> result;
};

/// Divides the rows of large images among threads.
class BandTeam {
 public:
  BandTeam(Index width, Index height, int threads)
      : team_(threads), is_large_(width * height >= kMinPixelsForThreads) {}

  [[nodiscard]] ThreadTeam& threads() { return team_; }

  [[nodiscard]] bool is_large() const { return is_large_; }

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

/// Exchanges foreground and background: bits up to the width, the padding remains zero.
inline void complement(const BitPlaneView& rows) {
  const Index words = rows.width / kWordBits;
  const std::uint64_t tail = (std::uint64_t{1} << (rows.width % kWordBits)) - 1;
  for (Index y = 0; y < rows.height; ++y) {
    std::uint64_t* const row = rows.row(y);
    for (Index i = 0; i < words; ++i) row[i] = ~row[i];
    if (tail != 0) row[words] ^= tail;
  }
}

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

/// Converts to planes and back; derived classes implement compute() with the same threads.
template <class T>
struct PlaneState : ThinningState {
  explicit PlaneState(const ThinningSetting& setting)
      : PlaneState(setting, {setting.isa, setting.width, setting.height}) {}
  PlaneState(const ThinningSetting& setting, Planes<T> own_planes)
      : planes(std::move(own_planes)),
        bands(setting.width, setting.height, setting.threads),
        team(bands.threads()),
        complemented(setting.complemented) {}

  int run(const ConstImageView& from, const ImageView& to) final { return run_planes(from, to); }
  int run(const ConstPackedView& from, const PackedView& to) final { return run_planes(from, to); }

  /// Thins source() into the result plane, all of which it writes; returns the number of
  /// iterations.
  virtual int compute() = 0;

  [[nodiscard]] ConstPlaneView<T> source() const { return planes.source.view(); }

  Planes<T> planes;
  BandTeam bands;
  ThreadTeam& team;
  bool complemented;

 private:
  template <class Source, class Destination>
  int run_planes(const Source& from, const Destination& to) {
    read_planes(bands, from, planes);
    if (complemented) complement(planes.source.view());
    const int iterations = compute();
    if (complemented) complement(planes.result.view());
    write_planes(bands, planes, to);
    return iterations;
  }
};

}  // namespace thinbench::detail
