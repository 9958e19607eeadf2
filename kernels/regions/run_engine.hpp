// The kernels that label the runs of a band of rows.
#pragma once

#include "thinbench/isa.hpp"
#include "regions/run_rows.hpp"

namespace thinbench::detail {

/// What simd_runs sums up for run i while the runs of neighbouring rows match one to one. Sums are
/// unsigned; it empties them before any reaches 2^32.
struct RunSlots {
  Key* length = nullptr;   // sum of lengths
  Key* squares = nullptr;  // sum of end^2 - begin^2, columns counted from 1
  Key* rows = nullptr;     // sum of lengths times rows since the slots were started
  Key* least = nullptr;    // least first key
  Key* largest = nullptr;  // largest last key
};

/// Everything a kernel works on; all memory is the caller's. Rows of runs and slots have room for
/// every possible row and two paddings.
struct RunLabelling {
  LabelTables tables;
  RunRow above;  // the last row that was labelled and summed up
  RunRow here;   // memory for the next one
  RunSlots slots;
};

/// Labels and sums up rows [first, last), given `above`, and returns the first row that was not
/// done: `last`, or one before which the tables need room for (width + 1) / 2 labels more.
using LabelRows = Index (*)(const ConstBitPlaneView& image, Index first, Index last,
                            RunLabelling& labelling);

/// With holes (background runs are labelled too) and for objects alone. `simd_runs` exports one for
/// every ISA.
struct RunEngine {
  LabelRows holes;
  LabelRows components;
};

/// The kernel `bitpacked_runs`.
extern const RunEngine kBitpackedRunEngine;

/// Labels row y, of which the row above is not known: every run that does not reach the frame gets
/// a label of its own.
void label_first_row(const ConstBitPlaneView& image, Index y, RunLabelling& labelling);

}  // namespace thinbench::detail
