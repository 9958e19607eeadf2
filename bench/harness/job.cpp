#include "harness/job.hpp"

#include <stdexcept>

namespace thinbench {
namespace {

[[noreturn]] void refuse_step() {
  throw std::logic_error("this job works on bytes: it has no steps of its own");
}

}  // namespace

void Job::load(const ConstImageView&) {
  refuse_step();
}

void Job::kernel() {
  refuse_step();
}

void Job::store(const ImageView&) const {
  refuse_step();
}

std::string Job::name_of_number(std::size_t index) const {
  return "number " + std::to_string(index);
}

Outcome outcome_of(Job& job, const ConstImageView& input) {
  Outcome outcome;
  if (job.gives_image()) outcome.image = ByteImage(input.width, input.height);
  job.run(input, outcome.image.view());
  outcome.numbers = job.numbers();
  return outcome;
}

}  // namespace thinbench
