// The verification that precedes every measurement: jobs against references on one input, and rows
// over sets of test images.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/job.hpp"
#include "harness/operation.hpp"
#include "harness/test_images.hpp"

namespace thinbench {

/// Runs the job on `input` inside larger buffers: strides exceed the width, the destination is
/// filled with garbage first, and the job has worked on another image of the same size. Returns
/// what is wrong: first differing pixel with a window around it, first differing number, bytes
/// written beside the destination, a changed input. Nothing where all is as it should be.
[[nodiscard]] std::optional<std::string> find_mismatch(Job& job, const ConstImageView& input,
                                                       const Outcome& expected);

/// The same for the three steps of a job that has a representation of its own: the kernel is called
/// twice, as when it is timed.
[[nodiscard]] std::optional<std::string> find_kernel_mismatch(Job& job, const ConstImageView& input,
                                                              const Outcome& expected);

/// A window of the image around (x, y), '#' foreground and '.' background.
[[nodiscard]] std::string window_text(const ConstImageView& image, Index x, Index y);

/// How one variant compared with the reference over all images that were shown to it.
struct VerificationResult {
  long compared = 0;           // images
  std::string first_mismatch;  // empty where all were equal
};

/// Compares rows with the references, image by image.
class Verifier {
 public:
  explicit Verifier(std::vector<Row> rows);

  /// Rows that take another kind of image or cannot run on one of this width are skipped; a row
  /// with a mismatch is not tried again.
  void show(const TestImage& image);

  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
  [[nodiscard]] const VerificationResult& verdict(std::size_t row) const { return verdicts_[row]; }

 private:
  void compare(std::size_t row, const TestImage& image, const Outcome& expected);

  std::vector<Row> rows_;
  std::vector<VerificationResult> verdicts_;
  std::vector<std::unique_ptr<Job>> jobs_;  // for images of the latest size
  Index width_ = -1;
  Index height_ = -1;
};

/// The sum over rows: passed where compared at least once without mismatch, skipped where never.
struct VerifySummary {
  int passed = 0;
  int failed = 0;
  int skipped = 0;
};

[[nodiscard]] VerifySummary summary_of(const Verifier& verifier);

}  // namespace thinbench
