// The jobs of a batch, one after another: decoding, computing and encoding overlap.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "batch/manifest.hpp"
#include "images/binarise.hpp"
#include "images/overlay.hpp"
#include "support/byte_image.hpp"

namespace thinbench {

/// What an operation made of one page: an image of 0 and 255 or, where that has no pixels, a text,
/// and what is drawn over `ground` where the job has an overlay.
struct BatchResult {
  ByteImage image;
  std::string text = {};
  ByteImage ground = {};
  Overlay overlay = {};
};

/// Computes one page and describes it in the record. Owns memory, so that each thread needs its
/// own.
using BatchCompute = std::function<BatchResult(GreyImage grey, BatchRecord& record)>;

struct BatchOperation {
  std::string name;  // with the options that change its result
  std::function<BatchCompute()> make;
};

struct BatchSettings {
  std::string out;
  int threads = 1;
  bool stops_on_error = false;
  BinariseOptions reading;
};

struct BatchTotals {
  std::size_t done = 0;               // pages that were written
  std::size_t with_warning = 0;       // of these
  std::vector<std::string> failures;  // a text for each page that was not
  std::size_t not_started = 0;        // jobs
  double decode_seconds = 0;          // over all threads
  double compute_seconds = 0;
  double encode_seconds = 0;
};

/// Does all jobs, or those up to the first failure, on so many threads. The manifest gets a line
/// for each page in the order of the jobs, after its output was written. Memory is bounded: a few
/// images per thread. Throws FileError where the manifest cannot be written.
[[nodiscard]] BatchTotals run_jobs(const std::vector<BatchJob>& jobs,
                                   const BatchOperation& operation, const BatchSettings& settings,
                                   Manifest& manifest);

}  // namespace thinbench
