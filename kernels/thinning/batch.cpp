#include "thinbench/batch.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/byte_image.hpp"
#include "core/checks.hpp"
#include "core/exported.hpp"
#include "core/thread_team.hpp"
#include "engines/lanes.hpp"
#include "engines/variants.hpp"
#include "thinning/operations.hpp"

namespace thinbench {

namespace {

using detail::ThinningParameters;

/// Thins images [first, last) in its own memory and returns the maximum number of iterations.
using Worker = std::function<int(const ConstStackView& source, const StackView& destination,
                                 Index first, Index last)>;

/// Workers in lanes share a bound rule.
Worker lane_worker(const std::shared_ptr<const detail::BoundRule>& rule, Isa isa, Index height,
                   const ThinningParameters& parameters) {
  const auto words = static_cast<std::size_t>(detail::lane_scratch_words(height));
  const std::shared_ptr<std::uint64_t[]> scratch = detail::make_aligned<std::uint64_t>(words);
  const detail::LaneKernel kernel = detail::kernels_of<detail::LaneKernels>(isa).thin;
  return [=](const ConstStackView& source, const StackView& destination, Index first, Index last) {
    const detail::LaneJob job = {source,
                                 destination,
                                 parameters.max_iterations,
                                 parameters.border == Border::keep,
                                 parameters.complemented,
                                 rule.get()};
    return kernel(job, first, last, scratch.get());
  };
}

Worker single_worker(std::shared_ptr<detail::ThinningState> state) {
  return [state = std::move(state)](const ConstStackView& source, const StackView& destination,
                                    Index first, Index last) {
    int iterations = 0;
    for (Index i = first; i < last; ++i) {
      iterations = std::max(iterations, state->run(source.image(i), destination.image(i)));
    }
    return iterations;
  };
}

}  // namespace

/// Shares the images of a stack among threads.
class ThinningBatch::Engine {
 public:
  Engine(std::vector<Worker> workers, bool one_by_one)
      : team_(static_cast<int>(workers.size())),
        workers_(std::move(workers)),
        iterations_(workers_.size()),
        one_by_one_(one_by_one) {}

  [[nodiscard]] bool one_by_one() const { return one_by_one_; }

  /// For stacks with pixels.
  int run(const ConstStackView& source, const StackView& destination) {
    constexpr Index group = 16;  // fills the widest register
    const Index groups = (source.count + group - 1) / group;
    const auto count = static_cast<Index>(workers_.size());
    const auto first_of = [&](Index worker) {
      return std::min(groups * worker / count * group, source.count);
    };
    team_.for_ranges(count, [&](Index first, Index last) {
      for (Index i = first; i < last; ++i) {
        const auto worker = static_cast<std::size_t>(i);
        iterations_[worker] = workers_[worker](source, destination, first_of(i), first_of(i + 1));
      }
    });
    return *std::max_element(iterations_.begin(), iterations_.end());
  }

 private:
  detail::ThreadTeam team_;
  std::vector<Worker> workers_;
  std::vector<int> iterations_;  // by worker
  bool one_by_one_;
};

ThinningBatch::ThinningBatch(const Rule& rule, Index width, Index height, const Thinning& thinning,
                             const Execution& execution)
    : width_(width), height_(height) {
  detail::require_threads(execution.threads);
  const ThinningParameters parameters = detail::thinning_parameters(rule, thinning);
  const detail::ThinningVariant& variant =
      detail::choose_thinning(parameters, width, height, {.threads = 1, .isa = execution.isa});
  const bool in_lanes = width <= detail::kMaxLaneWidth;
  std::vector<Worker> workers;
  if (in_lanes) {
    const auto bound = std::make_shared<const detail::BoundRule>(
        detail::bind(parameters.rule, variant.isa, detail::lane_layout(width),
                     detail::has_fixed_pixels(parameters)));
    for (int i = 0; i < execution.threads; ++i) {
      workers.push_back(lane_worker(bound, variant.isa, width == 0 ? 0 : height, parameters));
    }
  }
  while (static_cast<int>(workers.size()) < execution.threads) {
    workers.push_back(single_worker(detail::make_state(variant, width, height, parameters, 1)));
  }
  engine_ = std::make_unique<Engine>(std::move(workers), !in_lanes);
}

ThinningBatch::~ThinningBatch() = default;
ThinningBatch::ThinningBatch(ThinningBatch&&) noexcept = default;
ThinningBatch& ThinningBatch::operator=(ThinningBatch&&) noexcept = default;

int ThinningBatch::operator()(const ConstStackView& source, const StackView& destination) {
  detail::check_views(source, destination, detail::InPlace::allowed);
  if (source.width != width_ || source.height != height_) {
    throw std::invalid_argument("expected images of " + detail::size_text(width_, height_) +
                                ", got " + detail::size_text(source.width, source.height));
  }
  if (source.count == 0) return 0;
  if (source.width == 0 || source.height == 0) return 1;
  return engine_->run(source, destination);
}

bool ThinningBatch::one_by_one() const {
  return engine_->one_by_one();
}

int thin_batch(const Rule& rule, const ConstStackView& source, const StackView& destination,
               const Thinning& thinning, const Execution& execution) {
  detail::check_views(source, destination, detail::InPlace::allowed);
  return ThinningBatch(rule, source.width, source.height, thinning, execution)(source, destination);
}

}  // namespace thinbench
