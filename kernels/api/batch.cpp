#include "thinbench/batch.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "api/catalogue.hpp"
#include "custom/compiled_rule.hpp"
#include "dispatch/exported.hpp"
#include "image/byte_image.hpp"
#include "image/checks.hpp"
#include "image/thread_team.hpp"
#include "thinning/engines/lane_kernels.hpp"

namespace thinbench {

namespace {

/// Thins images [first, last) in its own memory and returns the maximum number of iterations.
using Worker = std::function<int(const ConstStackView& source, const StackView& destination,
                                 Index first, Index last)>;

/// `job` has everything but the stacks. `rule` keeps what the job refers to alive.
Worker lane_worker(detail::LaneKernel kernel, Index height, detail::LaneJob job,
                   std::shared_ptr<const void> rule = nullptr) {
  const auto words = static_cast<std::size_t>(detail::lane_scratch_words(height));
  const std::shared_ptr<std::uint64_t[]> scratch = detail::make_aligned<std::uint64_t>(words);
  return [kernel, scratch, job, rule = std::move(rule)](const ConstStackView& source,
                                                        const StackView& destination, Index first,
                                                        Index last) mutable {
    job.source = source;
    job.target = destination;
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

ThinningBatch::ThinningBatch(Rule rule, Index width, Index height, const Options& options)
    : width_(width), height_(height) {
  const auto kernel = [&] {
    const Isa isa = options.isa.value_or(best_isa());
    return detail::kernels_of<detail::LaneKernels>(isa).by_rule[rule];
  };
  make_engine(
      options, [&] { return kernel() != nullptr; },
      [&](const Options& single) {
        detail::require_size(width, height);
        const detail::ThinningOperation& operation = detail::operation_of(rule);
        const auto& variant = detail::choose(operation, width, height, single);
        return detail::make_state(operation, variant, width, height, single);
      },
      [&] {
        return lane_worker(kernel(), height,
                           {.source = {},
                            .target = {},
                            .max_iterations = options.max_iterations,
                            .keep_border = options.border == Border::keep});
      });
}

ThinningBatch::ThinningBatch(const CustomRule& rule, Index width, Index height,
                             const Options& options)
    : width_(width), height_(height) {
  make_engine(
      options, [&] { return rule.options().border != Border::foreground; },
      [&](const Options& single) {
        const auto& variant = detail::choose_custom(rule, width, height, single);
        return detail::make_custom_state(rule, variant, width, height, single);
      },
      [&] {
        struct Owner {
          CustomRule rule;
          detail::BoundRule bound;
        };
        const Isa isa = options.isa.value_or(best_isa());
        const auto owner = std::make_shared<const Owner>(
            Owner{rule, rule.compiled()->bind(isa, detail::lane_layout(width), true)});
        return lane_worker(detail::kernels_of<detail::LaneKernels>(isa).custom, height,
                           {.source = {},
                            .target = {},
                            .max_iterations = rule.options().max_iterations,
                            .keep_border = rule.options().border == Border::keep,
                            .rule = &owner->bound},
                           owner);
      });
}

/// One worker per thread: in lanes where the kernels can, else image by image.
/// `make_state(options)` checks the options, too; the others are called after it.
template <class HasLanes, class MakeState, class MakeLanes>
void ThinningBatch::make_engine(const Options& options, const HasLanes& has_lanes,
                                const MakeState& make_state, const MakeLanes& make_lanes) {
  detail::require_threads(options.threads);
  Options single = options;
  single.threads = 1;
  auto state = make_state(single);  // with lanes, only for its checks
  const bool in_lanes = !options.technique && width_ <= detail::kMaxLaneWidth && has_lanes();
  std::vector<Worker> workers;
  for (int i = 0; i < options.threads; ++i) {
    if (in_lanes) {
      workers.push_back(make_lanes());
    } else {
      workers.push_back(single_worker(i == 0 ? std::move(state) : make_state(single)));
    }
  }
  engine_ = std::make_unique<Engine>(std::move(workers), !in_lanes);
}

ThinningBatch::~ThinningBatch() = default;
ThinningBatch::ThinningBatch(ThinningBatch&&) noexcept = default;
ThinningBatch& ThinningBatch::operator=(ThinningBatch&&) noexcept = default;

int ThinningBatch::operator()(const ConstStackView& source, const StackView& destination) {
  detail::check_stacks(source, destination);
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

int thin_batch(Rule rule, const ConstStackView& source, const StackView& destination,
               const Options& options) {
  detail::check_stacks(source, destination);
  return ThinningBatch(rule, source.width, source.height, options)(source, destination);
}

int apply(const CustomRule& rule, const ConstStackView& source, const StackView& destination,
          const Options& options) {
  detail::check_stacks(source, destination);
  return ThinningBatch(rule, source.width, source.height, options)(source, destination);
}

}  // namespace thinbench
