// A row made ready: calling it is what the clock sees, nothing else.
#pragma once

#include <memory>

#include "timing/timed_row.hpp"

namespace thinbench {

/// Holds job, input and output of a row. Calling allocates nothing, unless the row is a reference
/// or a peer.
class TimedCall {
 public:
  explicit TimedCall(const TimedRow& row)
      : input_(row.input->view(row.operation->takes)),
        output_(input_.width, input_.height),
        job_(row.maker()(input_.width, input_.height, row.threads)),
        kernel_only_(row.scope == Scope::kKernel) {
    if (kernel_only_) job_->load(input_);
  }

  void operator()() {
    if (kernel_only_) {
      job_->kernel();
    } else {
      job_->run(input_, output_.view());
    }
  }

 private:
  ConstByteView input_;
  ByteImage output_;
  std::unique_ptr<Job> job_;
  bool kernel_only_;
};

}  // namespace thinbench
