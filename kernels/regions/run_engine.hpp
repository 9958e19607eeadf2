// The kernels that label the runs of a band of rows.
#pragma once

#include "regions/run_rows.hpp"
#include "thinbench/isa.hpp"

namespace thinbench::detail {

/// Accumulators of simd_runs, one of each kind per run, while the runs of neighbouring rows match
/// one to one. Sums are unsigned; the kernel adds them to the regions before any reaches 2^32.
struct RunSlots {
  Key* length = nullptr;   // sum of lengths
  Key* squares = nullptr;  // sum of end^2 - begin^2, columns counted from 1
  Key* rows = nullptr;     // sum of lengths times rows since the start
  Key* least = nullptr;    // minimum of first keys
  Key* largest = nullptr;  // maximum of last keys
};

/// The working data of a kernel, in the caller's memory. Rows of runs and accumulators have room
/// for every possible row and two paddings.
struct RunLabelling {
  LabelTables tables;
  RunRow above;  // the last row that was labelled and summed up
  RunRow here;   // memory for the next one
  RunSlots slots;
};

/// Labels and sums up rows [first, last), given `above`. Returns `last`, or the first row that was
/// not processed because the tables need room for (width + 1) / 2 labels more.
using LabelRows = Index (*)(const ConstBitPlaneView& image, Index first, Index last,
                            RunLabelling& labelling);

/// With holes (background runs are labelled too) and for objects alone. Compiled for every ISA by
/// simd_runs.
struct RunEngine {
  LabelRows holes;
  LabelRows components;
};

/// The kernel `bitpacked_runs`.
extern const RunEngine kBitpackedRunEngine;

/// Labels row y without a row above: every run that does not reach the image border gets a new
/// label.
void label_first_row(const ConstBitPlaneView& image, Index y, RunLabelling& labelling);

}  // namespace thinbench::detail
