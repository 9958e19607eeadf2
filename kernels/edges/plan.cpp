#include "edges/plan.hpp"

#include <optional>
#include <stdexcept>
#include <string>

#include "image/packing.hpp"
#include "image/checks.hpp"
#include "image/planes.hpp"
#include "image/thread_team.hpp"
#include "edges/tables.hpp"

namespace thinbench::detail {
namespace {

void check_threshold(const char* name, int value) {
  require(value >= 0 && value <= kLargestThreshold,
          std::string(name) + " is " + std::to_string(value) + "; it must be in 0..255");
}

void check(const EdgeVariant& variant, Index width, Index height, const EdgePlanOptions& options) {
  require_size(width, height);
  require_max_pixels(width, height);
  check_threshold("p1", options.thresholds.p1);
  check_threshold("p2", options.thresholds.p2);
  require_threads(options.threads);
  require_available(variant.facts, width);
}

}  // namespace

struct EdgePlan::State {
  State(const EdgeOperation& operation, const EdgeVariant& chosen, Index plan_width,
        Index plan_height, const EdgePlanOptions& options)
      : variant(chosen),
        width(plan_width),
        height(plan_height),
        team(chosen.facts.threaded ? options.threads : 1) {
    if (chosen.facts.technique == Technique::lut) {
      tables = std::make_unique<EdgeTables>(operation.op, options.thresholds);
    }
    if (chosen.writes_bits()) bits = BitPlane(width, height);
    setting = {options.thresholds, tables.get()};
  }

  template <class Kernel, class Target>
  void sweep(Kernel kernel, const ConstImageView& source, const Target& target) {
    if (width == 0) return;
    team.for_ranges(height, [&](Index first, Index last) {
      kernel(setting, source, target, EdgeRows{first, last});
    });
  }

  EdgeVariant variant;
  Index width;
  Index height;
  ThreadTeam team;
  std::unique_ptr<EdgeTables> tables;
  EdgeSetting setting;
  BitPlane bits;  // 0 x 0 for variants that write bytes
};

EdgePlan::EdgePlan(const EdgeOperation& operation, const EdgeVariant& variant, Index width,
                   Index height, const EdgePlanOptions& options) {
  check(variant, width, height, options);
  state_ = std::make_unique<State>(operation, variant, width, height, options);
}

EdgePlan::~EdgePlan() = default;
EdgePlan::EdgePlan(EdgePlan&&) noexcept = default;
EdgePlan& EdgePlan::operator=(EdgePlan&&) noexcept = default;

void EdgePlan::run(ConstImageView source, ImageView destination) {
  if (const auto* kernel = std::get_if<EdgesToBytes>(&state_->variant.kernel)) {
    state_->sweep(*kernel, source, destination);
  } else {
    run_to_bits(source);
    store(destination);
  }
}

ConstBitPlaneView EdgePlan::run_to_bits(ConstImageView source) {
  const auto* kernel = std::get_if<EdgesToBits>(&state_->variant.kernel);
  if (kernel == nullptr) throw std::logic_error("this variant writes bytes");
  state_->sweep(*kernel, source, state_->bits.view());
  return state_->bits.view();
}

void EdgePlan::store(ImageView destination) const {
  if (!state_->variant.writes_bits()) throw std::logic_error("this variant writes bytes");
  const BitPlane& bits = state_->bits;
  plane_conversion<std::uint64_t>(state_->variant.facts.isa).write(bits.view(), destination);
}

bool EdgePlan::margins_are_zero() const {
  return state_->bits.margin_is_zero();
}

}  // namespace thinbench::detail
