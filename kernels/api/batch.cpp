#include "thinbench/batch.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "api/catalogue.hpp"
#include "dispatch/exported.hpp"
#include "image/byte_image.hpp"
#include "image/checks.hpp"
#include "image/thread_team.hpp"
#include "thinning/engines/lane_kernels.hpp"

namespace thinbench {

using detail::LaneKernel;
using detail::ThinningState;

/// Shares the images of a stack among threads, the workers.
class ThinningBatch::Engine {
 public:
  explicit Engine(int threads) : team_(threads), iterations_(static_cast<std::size_t>(threads)) {}
  virtual ~Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  [[nodiscard]] virtual bool one_by_one() const = 0;

  /// For stacks with pixels.
  int run(const ConstStackView& source, const StackView& destination) {
    const Index groups = (source.count + kGroup - 1) / kGroup;
    const Index workers = team_.threads();
    const auto first_of = [&](Index worker) {
      return std::min(groups * worker / workers * kGroup, source.count);
    };
    team_.for_ranges(workers, [&](Index first, Index last) {
      for (Index worker = first; worker < last; ++worker) {
        iterations_[static_cast<std::size_t>(worker)] =
            thin(static_cast<std::size_t>(worker), source, destination, first_of(worker),
                 first_of(worker + 1));
      }
    });
    return *std::max_element(iterations_.begin(), iterations_.end());
  }

 protected:
  [[nodiscard]] std::size_t workers() const { return iterations_.size(); }

 private:
  /// Workers get multiples of so many images, which fill the widest register.
  static constexpr Index kGroup = 16;

  /// Thins images [first, last) in the memory of a worker and returns the largest number of
  /// iterations.
  virtual int thin(std::size_t worker, const ConstStackView& source, const StackView& destination,
                   Index first, Index last) = 0;

  detail::ThreadTeam team_;
  std::vector<int> iterations_;  // by worker
};

/// One image per lane.
class ThinningBatch::LaneEngine final : public Engine {
 public:
  LaneEngine(LaneKernel kernel, Index height, int max_iterations, bool keep_border, int threads)
      : Engine(threads),
        kernel_(kernel),
        max_iterations_(max_iterations),
        keep_border_(keep_border) {
    for (std::size_t worker = 0; worker < workers(); ++worker) {
      scratch_.push_back(detail::make_aligned<std::uint64_t>(
          static_cast<std::size_t>(detail::lane_scratch_words(height))));
    }
  }

  [[nodiscard]] bool one_by_one() const override { return false; }

 private:
  int thin(std::size_t worker, const ConstStackView& source, const StackView& destination,
           Index first, Index last) override {
    return kernel_({source, destination, max_iterations_, keep_border_}, first, last,
                   scratch_[worker].get());
  }

  LaneKernel kernel_;
  int max_iterations_;
  bool keep_border_;
  std::vector<detail::AlignedArray<std::uint64_t>> scratch_;  // by worker
};

/// One image after another.
class ThinningBatch::SingleEngine final : public Engine {
 public:
  explicit SingleEngine(std::vector<std::unique_ptr<ThinningState>> states)
      : Engine(static_cast<int>(states.size())), states_(std::move(states)) {}

  [[nodiscard]] bool one_by_one() const override { return true; }

 private:
  int thin(std::size_t worker, const ConstStackView& source, const StackView& destination,
           Index first, Index last) override {
    int iterations = 0;
    for (Index i = first; i < last; ++i) {
      iterations =
          std::max(iterations, states_[worker]->run(source.image(i), destination.image(i)));
    }
    return iterations;
  }

  std::vector<std::unique_ptr<ThinningState>> states_;  // by worker
};

ThinningBatch::ThinningBatch(Rule rule, Index width, Index height, const Options& options)
    : width_(width), height_(height) {
  detail::require_threads(options.threads);
  Options single = options;
  single.threads = 1;
  const detail::ThinningOperation& operation = detail::operation_of(rule);
  // Lanes need the state for one image only for its checks.
  const auto make_state = [&] {
    detail::require_size(width, height);
    const auto& variant = detail::choose(operation, width, height, single);
    return detail::make_state(operation, variant, width, height, single);
  };
  std::vector<std::unique_ptr<ThinningState>> states;
  states.push_back(make_state());
  const Isa isa = options.isa.value_or(best_isa());
  const LaneKernel kernel = detail::kernels_of<detail::LaneKernels>(isa).by_rule[rule];
  if (kernel != nullptr && !options.technique && width <= detail::kMaxLaneWidth) {
    engine_ = std::make_unique<LaneEngine>(kernel, height, options.max_iterations,
                                           options.border == Border::keep, options.threads);
    return;
  }
  while (states.size() < static_cast<std::size_t>(options.threads)) states.push_back(make_state());
  engine_ = std::make_unique<SingleEngine>(std::move(states));
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

}  // namespace thinbench
