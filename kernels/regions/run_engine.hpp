// The kernels that label the runs of a band of rows.
#pragma once

#include "regions/run_rows.hpp"
#include "thinbench/isa.hpp"

namespace thinbench::detail {

/// Accumulators of simd_runs: one of each kind per run, used while the runs of adjacent rows match
/// one to one. Sums are unsigned; the kernel adds them to the regions before any reaches 2^32.
struct RunAccumulators {
  Key* length = nullptr;     // sum of lengths
  Key* squares = nullptr;    // sum of end^2 - begin^2, columns counted from 1
  Key* rows = nullptr;       // sum of length * (row - first row)
  Key* min_begin = nullptr;  // minimum of first keys
  Key* max_end = nullptr;    // maximum of last keys
};

/// By so many more rows than others may suit a kernel badly before it gives up; see
/// RunLabelling::patience.
inline constexpr Index kPatience = 32;
inline constexpr Index kEndlessPatience = Index{1} << 40;

/// The working data of a kernel, in the caller's memory. Rows of runs and accumulators have room
/// for any row plus 2 * kKeyPadding.
struct RunLabelling {
  LabelTables tables;
  RunRow above;  // the last row that was labelled and summed
  RunRow here;   // memory for the next one
  RunAccumulators accumulators;
  /// A kernel may count here the rows on which contacts of runs are faster, and give up below 0.
  Index patience = kPatience;
};

/// Labels and sums rows [first, last), given `above`. Returns `last`, or the first row not
/// processed because the tables need room for (width + 1) / 2 more labels, or patience is at an
/// end.
using LabelRows = Index (*)(const ConstBitPlaneView& image, Index first, Index last,
                            RunLabelling& labelling);

/// `holes` labels background runs too, `components` only foreground. Compiled for every ISA.
struct RunEngine {
  LabelRows holes;
  LabelRows components;
};

/// The kernels of bitpacked_runs.
extern const RunEngine kBitpackedRunEngine;

/// Labels row y as the first of a band: every run gets a new label, except the background runs at
/// either end, which get 0.
void label_first_row(const ConstBitPlaneView& image, Index y, RunLabelling& labelling);

}  // namespace thinbench::detail
