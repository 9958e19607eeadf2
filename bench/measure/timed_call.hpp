// A row made ready: calling it is what the clock sees, nothing else.
#pragma once

#include <memory>
#include <utility>

#include "measure/timed_row.hpp"

namespace thinbench {

/// Holds the job of a row. Calling allocates nothing, unless the row is a reference or a peer.
class TimedCall {
 public:
  explicit TimedCall(const TimedRow& row)
      : TimedCall(row, row.input->view(*row.operation),
                  ByteImage(row.input->width(), row.input->height())) {}

  /// For who lays out input and output: copies of the row's input and somewhere to write.
  TimedCall(const TimedRow& row, const ConstImageView& input, const ImageView& output)
      : input_(input),
        output_(output),
        job_(row.maker()(input.width, input.height, row.threads)),
        kernel_only_(row.scope == Scope::kernel) {
    if (kernel_only_) job_->load(input_);
  }

  void operator()() {
    if (kernel_only_) {
      job_->kernel();
    } else {
      job_->run(input_, output_);
    }
  }

  /// What the latest call gave.
  [[nodiscard]] Outcome outcome() const {
    if (kernel_only_ && job_->gives_image()) job_->store(output_);
    return {job_->gives_image() ? copy_of(output_) : ByteImage(), job_->numbers()};
  }

 private:
  TimedCall(const TimedRow& row, const ConstImageView& input, ByteImage own)
      : TimedCall(row, input, own.view()) {
    own_output_ = std::move(own);
  }

  ConstImageView input_;
  ImageView output_;
  ByteImage own_output_;  // empty where the output is somebody else's
  std::unique_ptr<Job> job_;
  bool kernel_only_;
};

}  // namespace thinbench
