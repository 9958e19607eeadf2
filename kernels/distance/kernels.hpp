// Kernels of the distance transform: columns first, then rows.
#pragma once

#include <cstdint>
#include <vector>

#include "thinbench/distance.hpp"

namespace thinbench::detail {

/// Vertical distances of at least this stand for "no background in this column". Real ones are
/// below, as a column has at most 32,767 pixels.
inline constexpr std::uint16_t kFarVertically = 0x8000;

/// How far a search goes along a row before it leaves the row to `envelope_row`.
inline constexpr int kMaxSearch = 64;

/// From here on vertical distances are taken for this one where rows are searched. Its square is
/// more than a search finds, and that of kMaxSearch may be added to it.
inline constexpr std::uint16_t kTooFar = 2 * kMaxSearch;
inline constexpr std::int16_t kFarSquared = kTooFar * kTooFar;
static_assert(kFarSquared <= INT16_MAX - kMaxSearch * kMaxSearch);

/// The vertical distances of all pixels.
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
        found_(static_cast<std::size_t>(width)) {}

  /// One per pixel, between margins that searches and whole registers may read.
  [[nodiscard]] std::int16_t* squares() { return squares_.data() + kMargin; }
  /// For the lower envelope: the columns of its parabolas, and where each becomes the lowest.
  [[nodiscard]] std::int32_t* sites() { return sites_.data(); }
  [[nodiscard]] std::int32_t* starts() { return starts_.data(); }
  /// The squared distances of a row that is wanted in another form.
  [[nodiscard]] std::int32_t* found() { return found_.data(); }

  static constexpr Index kMargin = kMaxSearch + 64;

 private:
  std::vector<std::int16_t> squares_;
  std::vector<std::int32_t> sites_;
  std::vector<std::int32_t> starts_;
  std::vector<std::int32_t> found_;
};

/// The vertical distances of columns [first, last).
using DistanceColumns = void (*)(const ConstImageView& source, const VerticalDistances& vertical,
                                 Index first, Index last);
/// The squared distances of a row from its vertical distances.
using DistanceOfRow = void (*)(const std::uint16_t* vertical, DistanceRow& memory,
                               std::int32_t* distances, Index width);

/// Distances from their squares.
using RootsOfRow = void (*)(const std::int32_t* squares, double spacing, double* distances,
                            Index width);

/// Compiled for every ISA.
struct DistanceKernels {
  DistanceColumns columns;
  DistanceOfRow row;
  RootsOfRow roots;
};

/// On any machine, in time linear in the width.
void envelope_row(const std::uint16_t* vertical, DistanceRow& memory, std::int32_t* distances,
                  Index width);

/// Distances where rows and columns are not equally far apart.
void spaced_row(const std::uint16_t* vertical, DistanceRow& memory, const Spacing& spacing,
                double* distances, Index width);

}  // namespace thinbench::detail
