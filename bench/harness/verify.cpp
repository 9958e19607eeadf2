#include "harness/verify.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "harness/test_images.hpp"

namespace thinbench {
namespace {

/// A view into a buffer with guards around it, at an odd stride and alignment.
class Guarded {
 public:
  static constexpr std::uint8_t kGuard = 0xA5;

  Guarded(Index width, Index height, Index extra)
      : stride_(width + 2 * extra + 1),
        extra_(extra),
        width_(width),
        height_(height),
        bytes_(static_cast<std::size_t>(stride_ * (height + 2)), kGuard) {}

  [[nodiscard]] ImageView view() {
    return {bytes_.data() + stride_ + extra_, width_, height_, stride_};
  }

  void copy_from(const ConstImageView& image) {
    for (Index y = 0; y < height_; ++y) std::copy_n(image.row(y), width_, view().row(y));
  }

  /// True where every byte outside the view is as it was.
  [[nodiscard]] bool intact() const {
    for (Index y = -1; y <= height_; ++y) {
      const std::uint8_t* row = bytes_.data() + (y + 1) * stride_;
      const bool inside = y >= 0 && y < height_;
      const Index from = inside ? extra_ + width_ : 0;
      if (!all_guard(row + from, row + stride_)) return false;
      if (inside && !all_guard(row, row + extra_)) return false;
    }
    return true;
  }

 private:
  static bool all_guard(const std::uint8_t* first, const std::uint8_t* last) {
    return std::all_of(first, last, [](std::uint8_t byte) { return byte == kGuard; });
  }

  Index stride_;
  Index extra_;
  Index width_;
  Index height_;
  std::vector<std::uint8_t> bytes_;
};

/// Noise for the job to work on first. Its rows repeat: big images would take long to draw. Valid
/// until the thread asks for another size.
ConstImageView earlier_work(Index width, Index height) {
  constexpr Index kRows = 64;
  thread_local ByteImage image;
  if (image.view().width == width && image.view().height == height) return image.view();
  const ByteImage noise = noise_image(width, std::min(height, kRows), 45, 1, 99);
  image = image_by(width, height, [&](Index x, Index y) { return noise.at(x, y % kRows); });
  return image.view();
}

std::optional<std::string> image_difference(const ConstImageView& expected,
                                            const ConstImageView& found) {
  for (Index y = 0; y < expected.height; ++y) {
    if (std::equal(expected.row(y), expected.row(y) + expected.width, found.row(y))) continue;
    for (Index x = 0; x < expected.width; ++x) {
      if (expected.row(y)[x] == found.row(y)[x]) continue;
      return "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") is " +
             std::to_string(found.row(y)[x]) + " instead of " + std::to_string(expected.row(y)[x]) +
             "\nreference:\n" + window_text(expected, x, y) + "variant:\n" +
             window_text(found, x, y);
    }
  }
  return std::nullopt;
}

std::optional<std::string> number_difference(const Job& job,
                                             const std::vector<std::int64_t>& expected) {
  const std::vector<std::int64_t> found = job.numbers();
  const auto [first, other] =
      std::mismatch(expected.begin(), expected.end(), found.begin(), found.end());
  if (first != expected.end() && other != found.end()) {
    return job.name_of_number(static_cast<std::size_t>(first - expected.begin())) + ": " +
           std::to_string(*other) + " instead of " + std::to_string(*first);
  }
  if (expected.size() == found.size()) return std::nullopt;
  return std::to_string(found.size()) + " numbers instead of " + std::to_string(expected.size());
}

/// The first difference between what is in `found` and in the job, and what is expected.
std::optional<std::string> first_difference(const Job& job, const Outcome& expected,
                                            const ConstImageView& found) {
  if (job.gives_image()) {
    if (auto difference = image_difference(expected.image.view(), found)) return difference;
  }
  return number_difference(job, expected.numbers);
}

}  // namespace

std::optional<std::string> find_mismatch(Job& job, const ConstImageView& input,
                                         const Outcome& expected) {
  Guarded source(input.width, input.height, 3);
  Guarded destination(input.width, input.height, 5);
  const ConstImageView garbage = earlier_work(input.width, input.height);
  job.run(garbage, destination.view());
  source.copy_from(input);
  destination.copy_from(garbage);
  job.run(source.view(), destination.view());
  if (auto difference = first_difference(job, expected, destination.view())) return difference;
  if (!source.intact() || !equal(source.view(), input)) return "the input was changed";
  if (!destination.intact()) return "bytes beside the destination were changed";
  return std::nullopt;
}

std::optional<std::string> find_kernel_mismatch(Job& job, const ConstImageView& input,
                                                const Outcome& expected) {
  ByteImage found(input.width, input.height);
  job.load(input);
  job.kernel();
  job.kernel();
  if (job.gives_image()) job.store(found.view());
  return first_difference(job, expected, found.view());
}

std::string window_text(const ConstImageView& image, Index x, Index y) {
  constexpr Index reach = 4;
  std::string text;
  for (Index row = std::max<Index>(0, y - reach); row <= std::min(image.height - 1, y + reach);
       ++row) {
    text += "  ";
    for (Index column = std::max<Index>(0, x - reach);
         column <= std::min(image.width - 1, x + reach); ++column) {
      text += image.row(row)[column] != 0 ? '#' : '.';
    }
    text += '\n';
  }
  return text;
}

Verifier::Verifier(std::vector<Row> rows)
    : rows_(std::move(rows)), verdicts_(rows_.size()), jobs_(rows_.size()) {}

void Verifier::show(const TestImage& image) {
  const ConstImageView view = image.image.view();
  if (view.width != width_ || view.height != height_) {
    for (auto& job : jobs_) job.reset();
    width_ = view.width;
    height_ = view.height;
  }
  std::map<const void*, Outcome> expected;  // by operation, or by a variant with its own reference
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    if (!verdicts_[row].first_mismatch.empty()) continue;
    const auto& [operation, variant, threads, name] = rows_[row];
    if (operation->takes != image.kind || !variant->unavailable_reason(width_).empty()) continue;
    const void* key = variant->own_reference ? static_cast<const void*>(variant) : operation;
    auto found = expected.find(key);
    if (found == expected.end()) {
      found = expected.emplace(key, expected_of(*operation, *variant, view)).first;
    }
    compare(row, image, found->second);
  }
}

void Verifier::compare(std::size_t row, const TestImage& image, const Outcome& expected) {
  std::unique_ptr<Job>& job = jobs_[row];
  if (!job) job = rows_[row].variant->make_job(width_, height_, rows_[row].threads);
  ++verdicts_[row].compared;
  if (const auto mismatch = find_mismatch(*job, image.image.view(), expected)) {
    verdicts_[row].first_mismatch = rows_[row].name + ": " + image.name + ": " + *mismatch;
  }
}

VerifySummary summary_of(const Verifier& verifier) {
  VerifySummary summary;
  for (std::size_t row = 0; row < verifier.rows().size(); ++row) {
    const VerificationResult& verdict = verifier.verdict(row);
    if (!verdict.first_mismatch.empty()) {
      ++summary.failed;
    } else if (verdict.compared > 0) {
      ++summary.passed;
    } else {
      ++summary.skipped;
    }
  }
  return summary;
}

}  // namespace thinbench
