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
  /// Threads take at least `piece` images each.
  Engine(MakeWorker make_worker, int max_workers, Index piece)
      : make_worker_(std::move(make_worker)), max_workers_(max_workers), piece_(piece) {}

  /// For stacks with pixels.
  int run(ConstStackView source, StackView destination) {
    const Index pieces = (source.count + piece_ - 1) / piece_;
    const Index count = std::min<Index>(max_workers_, pieces);
    make_workers(static_cast<std::size_t>(count));
    const auto first_of = [&](Index worker) {
      return std::min(pieces * worker / count * piece_, source.count);
    };
    team_->for_ranges(count, [&](Index first, Index last) {
      for (Index i = first; i < last; ++i) {
        const auto worker = static_cast<std::size_t>(i);
        iterations_[worker] = workers_[worker](source, destination, first_of(i), first_of(i + 1));
      }
    });
    return *std::max_element(iterations_.begin(), iterations_.begin() + count);
  }

 private:
  void make_workers(std::size_t count) {
    if (count <= workers_.size() && team_) return;
    while (workers_.size() < count) workers_.push_back(make_worker_());
    iterations_.resize(count);
    team_.emplace(static_cast<int>(count));
  }

  MakeWorker make_worker_;
  int max_workers_;
  Index piece_;
  std::vector<Worker> workers_;
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
    engine_ = std::make_unique<Engine>(single_workers(call, width, height), 1, 1);
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
