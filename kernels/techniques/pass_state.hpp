// States of passes.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "engines/iterate.hpp"
#include "engines/plane_state.hpp"
#include "techniques/passes.hpp"

namespace thinbench::detail {

/// Iterates passes over planes of bytes.
class PassState final : public PlaneState<std::uint8_t> {
 public:
  /// `passes` must refer to static storage. `table`: see Pass.
  PassState(std::span<const BytePass> passes, const ThinningSetting& setting,
            std::shared_ptr<const TableRule> table = nullptr);

  int compute() override;

 private:
  std::span<const BytePass> passes_;
  std::shared_ptr<const TableRule> table_;
  IterationPlan plan_;
  BandActivity activity_;
  BytePlane fixed_;
  BytePlane scratch_;
};

/// Iterates a ChangePass.
class ChangeState final : public PlaneState<std::uint64_t> {
 public:
  ChangeState(ChangePass pass, const ThinningSetting& setting,
              std::shared_ptr<const TableRule> table);

  int compute() override;

 private:
  ChangePass pass_;
  std::shared_ptr<const TableRule> table_;
  IterationPlan plan_;
  BandActivity activity_;
  BitPlane fixed_;
  std::array<BitPlane, 2> scratch_;
};

}  // namespace thinbench::detail
