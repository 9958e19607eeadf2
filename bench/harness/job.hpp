// What every operation family looks like to the harness: work on one input that ends in an image,
// in numbers, or in both.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/byte_image.hpp"

namespace thinbench {

enum class InputKind : std::uint8_t {
  binary,  // 0 and 255
  grey,    // all 256 levels
};

/// One way to compute one operation on inputs of one size. It owns whatever memory that needs, so
/// that load, kernel, store and run allocate nothing (references and peers may).
class Job {
 public:
  Job() = default;
  virtual ~Job() = default;
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  /// From input bytes to the result, by the steps where there is no shorter way. Jobs that give no
  /// image leave `output` alone.
  virtual void run(const ConstImageView& input, const ImageView& output) {
    load(input);
    kernel();
    if (gives_image()) store(output);
  }

  /// The three steps of run, for jobs whose representation differs from bytes: into it, the
  /// operation itself (the input is kept, so this may be repeated), and out of it. Others throw
  /// std::logic_error.
  virtual void load(const ConstImageView& /*input*/) { throw std::logic_error(kNoSteps); }
  virtual void kernel() { throw std::logic_error(kNoSteps); }
  virtual void store(const ImageView& /*output*/) const { throw std::logic_error(kNoSteps); }

  /// What the latest run or kernel gave beside the image, such as the number of iterations.
  [[nodiscard]] virtual std::vector<std::int64_t> numbers() const { return {}; }
  /// What number `index` is, in the words of a message: "iterations".
  [[nodiscard]] virtual std::string name_of_number(std::size_t index) const {
    return "number " + std::to_string(index);
  }

  [[nodiscard]] virtual bool gives_image() const { return true; }

 private:
  static constexpr const char* kNoSteps = "this job works on bytes: it has no steps of its own";
};

using JobMaker = std::function<std::unique_ptr<Job>(Index width, Index height, int threads)>;

/// A result in a form that can be compared.
struct Outcome {
  ByteImage image;  // 0 x 0 where the job gives none
  std::vector<std::int64_t> numbers;
};

/// What the job makes of an input.
[[nodiscard]] Outcome outcome_of(Job& job, const ConstImageView& input);

}  // namespace thinbench
