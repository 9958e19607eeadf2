// The state of the row kernel.
#pragma once

#include "thinning/engines/row_kernel.hpp"
#include "thinning/iteration/plane_state.hpp"

namespace thinbench::detail {

class RowState final : public PlaneState<std::uint64_t> {
 public:
  RowState(RowKernel kernel, const ThinningSetting& setting)
      : PlaneState(setting),
        kernel_(kernel),
        rule_(setting.runtime_rule),
        options_{rule_.get(), setting.border, setting.max_iterations},
        scratch_(make_aligned<std::uint64_t>(
            static_cast<std::size_t>(row_kernel_scratch_words(setting.height)))) {}

  int thin() override { return kernel_(options_, source(), planes.result.view(), scratch_.get()); }

 private:
  RowKernel kernel_;
  std::shared_ptr<const RuntimeRule> rule_;
  RowKernelOptions options_;
  AlignedArray<std::uint64_t> scratch_;
};

}  // namespace thinbench::detail
