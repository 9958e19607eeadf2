#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "core/byte_image.hpp"
#include "core/checks.hpp"
#include "core/exported.hpp"
#include "core/thread_team.hpp"
#include "engines/lanes.hpp"
#include "engines/variants.hpp"
#include "thinbench/many.hpp"
#include "thinning/operations.hpp"

namespace thinbench {

namespace {

using detail::available_threads;
using detail::ThinningCall;
using detail::ThinningParameters;

/// Thins images [first, last) in its own memory and returns the maximum number of iterations.
using Worker =
    std::function<int(ConstStackView source, StackView destination, Index first, Index last)>;
using MakeWorker = std::function<Worker()>;

/// Workers in lanes share a bound rule.
MakeWorker lane_workers(const ThinningParameters& parameters, Isa isa, Index width, Index height) {
  const std::shared_ptr<const detail::BoundRule> rule =
      std::make_shared<detail::BoundRule>(detail::bind(
          parameters.rule, isa, detail::lane_layout(width), detail::has_fixed_pixels(parameters)));
  const auto words = static_cast<std::size_t>(detail::lane_scratch_words(height));
  const detail::LaneKernel kernel = detail::kernels_of<detail::LaneKernels>(isa).thin;
  return [=]() -> Worker {
    const std::shared_ptr<std::uint64_t[]> scratch = detail::make_aligned<std::uint64_t>(words);
    return [=](ConstStackView source, StackView destination, Index first, Index last) {
      const detail::LaneJob job = {source,
                                   destination,
                                   parameters.max_iterations,
                                   parameters.border == Border::keep,
                                   parameters.complemented,
                                   rule.get()};
      return kernel(job, first, last, scratch.get());
    };
  };
}

MakeWorker single_workers(const ThinningCall& call, Index width, Index height) {
  return [=]() -> Worker {
    const std::shared_ptr<detail::ThinningState> state = make_thinning(call, width, height);
    return [=](ConstStackView source, StackView destination, Index first, Index last) {
      int iterations = 0;
      for (Index i = first; i < last; ++i) {
        iterations = std::max(iterations, state->run(source.image(i), destination.image(i)));
      }
      return iterations;
    };
  };
}

}  // namespace

/// Shares the images of a stack among workers, which it makes when there is work for them.
class StackThinner::Engine {
 public:
  /// Threads take at least `piece` images each. Where there is a `make_shared`, its worker has all
  /// threads, and takes what is left after the same number of images for each other worker.
  Engine(MakeWorker make_worker, int max_workers, Index piece, MakeWorker make_shared = nullptr)
      : make_worker_(std::move(make_worker)),
        make_shared_(std::move(make_shared)),
        max_workers_(max_workers),
        piece_(piece) {}

  /// For stacks with pixels.
  int run(ConstStackView source, StackView destination) {
    if (!make_shared_) return run_in_parallel(source, destination, source.count);
    const Index threads = available_threads(max_workers_);
    const Index alone = source.count / threads * threads;
    int iterations = alone > 0 ? run_in_parallel(source, destination, alone) : 0;
    if (alone == source.count) return iterations;
    if (!shared_) shared_ = make_shared_();
    return std::max(iterations, shared_(source, destination, alone, source.count));
  }

 private:
  /// Images [0, last).
  int run_in_parallel(ConstStackView source, StackView destination, Index last) {
    const Index pieces = (last + piece_ - 1) / piece_;
    const Index count = make_workers(std::min<Index>(max_workers_, pieces));
    const auto first_of = [&](Index worker) {
      return std::min(pieces * worker / count * piece_, last);
    };
    team_->for_ranges(count, [&](Index first, Index end) {
      for (Index i = first; i < end; ++i) {
        const auto worker = static_cast<std::size_t>(i);
        iterations_[worker] = workers_[worker](source, destination, first_of(i), first_of(i + 1));
      }
    });
    return *std::max_element(iterations_.begin(), iterations_.begin() + count);
  }

  /// Makes at most `wanted` workers, as many as there are threads, and returns their number.
  Index make_workers(Index wanted) {
    if (!team_ || wanted > wanted_) {
      team_.emplace(static_cast<int>(wanted));
      wanted_ = wanted;
    }
    const Index count = std::min<Index>(wanted, team_->threads());
    while (std::ssize(workers_) < count) workers_.push_back(make_worker_());
    iterations_.resize(workers_.size());
    return count;
  }

  MakeWorker make_worker_;
  MakeWorker make_shared_;
  int max_workers_;
  Index piece_;
  Index wanted_ = 0;  // threads of the team
  std::vector<Worker> workers_;
  Worker shared_;
  std::vector<int> iterations_;  // by worker
  std::optional<detail::ThreadTeam> team_;
};

StackThinner::StackThinner(const Rule& rule, Index width, Index height, const Thinning& thinning,
                           const Execution& execution)
    : width_(width), height_(height) {
  constexpr Index lanes = 16;              // fill the widest register
  constexpr Index piece = Index{1} << 14;  // pixels, for which a thread is worth waking
  const ThinningCall call = {rule, thinning, execution};
  const ThinningParameters parameters = detail::thinning_parameters(rule, thinning);
  detail::require_size(width, height);
  detail::require_max_pixels(width, height);
  detail::require_execution(execution);
  const Index images = piece / std::max<Index>(1, width * height);
  if (detail::use_threads(width, height, execution)) {
    engine_ = std::make_unique<Engine>(single_workers(call.on_one_thread(), width, height),
                                       execution.threads, 1, single_workers(call, width, height));
  } else if (width <= detail::kMaxLaneWidth) {
    const Isa isa = choose_variant(detail::thinning_variants(*parameters.rule), width, height,
                                   {.threads = 1, .isa = execution.isa})
                        .isa;
    engine_ =
        std::make_unique<Engine>(lane_workers(parameters, isa, width, width == 0 ? 0 : height),
                                 execution.threads, std::max(images, lanes));
  } else {
    engine_ = std::make_unique<Engine>(single_workers(call.on_one_thread(), width, height),
                                       execution.threads, std::max<Index>(images, 1));
  }
}

StackThinner::~StackThinner() = default;
StackThinner::StackThinner(StackThinner&&) noexcept = default;
StackThinner& StackThinner::operator=(StackThinner&&) noexcept = default;

int StackThinner::operator()(ConstStackView source, StackView destination) {
  detail::check_views(source, destination, detail::InPlace::allowed);
  detail::require(source.width == width_ && source.height == height_, [&] {
    return "expected images of " + detail::size_text(width_, height_) + ", got " +
           detail::size_text(source.width, source.height);
  });
  if (source.count == 0) return 0;
  if (source.width == 0 || source.height == 0) return 1;
  return engine_->run(source, destination);
}

int thin_stack(const Rule& rule, ConstStackView source, StackView destination,
               const Thinning& thinning, const Execution& execution) {
  detail::check_views(source, destination, detail::InPlace::allowed);
  return StackThinner(rule, source.width, source.height, thinning, execution)(source, destination);
}

}  // namespace thinbench
