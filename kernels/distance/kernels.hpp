// Kernels of the distance transform: columns first, then rows.
#pragma once

#include <cstdint>
#include <vector>

#include "core/exported.hpp"
#include "thinbench/distance.hpp"

namespace thinbench::detail {

/// Vertical distances of at least this stand for "no background in this column". Real ones are
/// below, as a column has at most 32,767 pixels.
inline constexpr std::uint16_t kFarVertically = 0x8000;

/// How far a search goes along a row before another takes over.
inline constexpr int kMaxSearch = 64;

/// From here on vertical distances are taken for this one where rows are searched. Its square is
/// more than a search finds, and that of kMaxSearch may be added to it.
inline constexpr std::uint16_t kTooFar = 2 * kMaxSearch;
inline constexpr std::int16_t kFarSquared = kTooFar * kTooFar;
static_assert(kFarSquared <= INT16_MAX - kMaxSearch * kMaxSearch);

/// Results of at least this many bytes are written with non-temporal stores.
inline constexpr Index kNonTemporalDistanceBytes = Index{4} << 20;

/// The vertical distances of a strip of rows.
struct VerticalDistances {
  std::uint16_t* data;
  Index stride;  // in numbers

  [[nodiscard]] std::uint16_t* row(Index y) const { return data + y * stride; }
};

/// Memory for one row; a thread has its own.
class DistanceRow {
 public:
  explicit DistanceRow(Index width)
      : squares_(static_cast<std::size_t>(width + 2 * kMargin)),
        sites_(static_cast<std::size_t>(width)),
        starts_(static_cast<std::size_t>(width)),
        costs_(static_cast<std::size_t>(width)),
        nearest_(static_cast<std::size_t>(width / kRunBlock + 2)),
        found_(static_cast<std::size_t>(width)),
        roots_(static_cast<std::size_t>(width)) {}

  /// One per pixel, between margins that searches and whole registers may read.
  [[nodiscard]] std::int16_t* squares() { return squares_.data() + kMargin; }
  /// For the lower envelope: the columns of its parabolas, and where each becomes the lowest.
  [[nodiscard]] std::int32_t* sites() { return sites_.data(); }
  [[nodiscard]] std::int32_t* starts() { return starts_.data(); }
  /// For a long search: what columns cost, and the nearest ones of some pixels.
  [[nodiscard]] std::uint32_t* costs() { return costs_.data(); }
  [[nodiscard]] std::int32_t* nearest() { return nearest_.data(); }
  /// The distances of a row that is wanted in another form or place.
  [[nodiscard]] std::int32_t* squared_distances() { return found_.data(); }
  [[nodiscard]] double* distances() { return roots_.data(); }

  static constexpr Index kMargin = kMaxSearch + 64;
  static constexpr Index kRunBlock = 16;  // pixels between those

 private:
  std::vector<std::int16_t> squares_;
  std::vector<std::int32_t> sites_;
  std::vector<std::int32_t> starts_;
  std::vector<std::uint32_t> costs_;
  std::vector<std::int32_t> nearest_;
  std::vector<std::int32_t> found_;
  std::vector<double> roots_;
};

/// What a strip of rows needs to know of others: for each column, how far background is above from
/// the row above the strip, and how far it is below from the row below.
struct StripEdges {
  std::uint16_t* above;
  std::uint16_t* below;
};
/// Stands for a column of a strip without background.
inline constexpr std::uint16_t kNoneInStrip = 0xffff;

/// For each column of a strip, how far its last background pixel is from the last row (what `above`
/// of the strip below needs), and its first one from the first row; else kNoneInStrip.
using DistanceEdges = void (*)(const ConstImageView& strip, const StripEdges& found);
/// The vertical distances of a strip.
using DistanceColumns = void (*)(const ConstImageView& strip, const StripEdges& edges,
                                 const VerticalDistances& vertical);
/// The squared distances of a row from its vertical distances.
using DistanceOfRow = void (*)(const std::uint16_t* vertical, DistanceRow& memory,
                               std::int32_t* distances, Index width);

/// Distances from their squares.
using RootsOfRow = void (*)(const std::int32_t* squares, double spacing, double* distances,
                            Index width);

/// Copies with non-temporal stores.
using DistanceCopy = void (*)(const void* from, void* to, Index bytes);

struct DistanceKernels {
  DistanceEdges edges;
  DistanceColumns columns;
  DistanceOfRow row;
  RootsOfRow roots;
  DistanceCopy copy;
};
template <>
inline constexpr Features kGainsFrom<DistanceKernels> = feature("sse4.2") | feature("avx2") |
                                                        feature("avx512bw");

/// By the lower envelope, in time linear in the width.
void envelope_row(const std::uint16_t* vertical, DistanceRow& memory, std::int32_t* distances,
                  Index width);

/// Distances where rows and columns are not equally far apart.
void spaced_row(const std::uint16_t* vertical, DistanceRow& memory, const Spacing& spacing,
                double* distances, Index width);

}  // namespace thinbench::detail
