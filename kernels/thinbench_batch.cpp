#include "thinbench_batch.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "image/check_stacks.hpp"
#include "image/checks.hpp"
#include "image/thread_team.hpp"

namespace thinbench {

/// Thins images on the threads of a team.
class ThinningBatch::Engine {
 public:
  explicit Engine(int threads) : team_(threads), passes_(static_cast<std::size_t>(threads)) {}
  virtual ~Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  [[nodiscard]] virtual bool one_by_one() const = 0;

  /// The stacks have pixels.
  int run(const ConstStackView& source, const StackView& destination) {
    const Index groups = (source.count + kGroup - 1) / kGroup;
    const Index workers = team_.threads();
    const auto first_of = [&](Index worker) {
      return std::min(groups * worker / workers * kGroup, source.count);
    };
    team_.for_ranges(workers, [&](Index first, Index last) {
      for (Index worker = first; worker < last; ++worker) {
        passes_[static_cast<std::size_t>(worker)] =
            thin(static_cast<std::size_t>(worker), source, destination, first_of(worker),
                 first_of(worker + 1));
      }
    });
    return *std::max_element(passes_.begin(), passes_.end());
  }

 protected:
  [[nodiscard]] std::size_t workers() const { return passes_.size(); }

 private:
  /// Threads share the images in units that fill the widest register.
  static constexpr Index kGroup = 16;

  /// Thins images [first, last) with what belongs to a worker and returns the most passes.
  virtual int thin(std::size_t worker, const ConstStackView& source, const StackView& destination,
                   Index first, Index last) = 0;

  ThreadTeam team_;
  std::vector<int> passes_;  // by worker
};

/// One image a lane.
class ThinningBatch::LaneEngine final : public Engine {
 public:
  LaneEngine(LaneKernel kernel, Index height, int max_iterations, bool keep_border, int threads)
      : Engine(threads), kernel_(kernel), most_passes_(max_iterations), keep_border_(keep_border) {
    for (std::size_t worker = 0; worker < workers(); ++worker) {
      scratch_.push_back(
          make_aligned<std::uint64_t>(static_cast<std::size_t>(lane_scratch_words(height))));
    }
  }

  [[nodiscard]] bool one_by_one() const override { return false; }

 private:
  int thin(std::size_t worker, const ConstStackView& source, const StackView& destination,
           Index first, Index last) override {
    return kernel_({source, destination, most_passes_, keep_border_}, first, last,
                   scratch_[worker].get());
  }

  LaneKernel kernel_;
  int most_passes_;
  bool keep_border_;
  std::vector<AlignedArray<std::uint64_t>> scratch_;  // by worker
};

/// A plan for one image, run for each.
class ThinningBatch::SingleEngine final : public Engine {
 public:
  explicit SingleEngine(std::vector<ThinningPlan> plans)
      : Engine(static_cast<int>(plans.size())), plans_(std::move(plans)) {}

  [[nodiscard]] bool one_by_one() const override { return true; }

 private:
  int thin(std::size_t worker, const ConstStackView& source, const StackView& destination,
           Index first, Index last) override {
    int most = 0;
    for (Index i = first; i < last; ++i) {
      most = std::max(most, plans_[worker].run(source.image(i), destination.image(i)));
    }
    return most;
  }

  std::vector<ThinningPlan> plans_;  // by worker
};

namespace {

const ThinningOperation& operation_named(std::string_view name) {
  const ThinningOperation* found = find_thinning_operation(name);
  if (found == nullptr) {
    throw std::invalid_argument("no operation is named " + std::string(name));
  }
  return *found;
}

}  // namespace

ThinningBatch::ThinningBatch(const ThinningOperation& operation, Index width, Index height,
                             const ThinningOptions& options)
    : width_(width), height_(height) {
  require_threads(options.threads);
  ThinningOptions single = options;
  single.threads = 1;
  const ThinningVariant& variant = choose_variant(operation, width, single);
  // A plan for one image refuses whatever does not fit together; lanes need it for that only.
  const auto plan = [&] {
    return ThinningPlan(operation, variant, width, height,
                        {1, options.model, options.border, options.directions});
  };
  std::vector<ThinningPlan> plans;
  plans.push_back(plan());
  const bool lanes =
      operation.lane_kernels != nullptr && !options.technique && width <= kMaxLaneWidth;
  if (lanes) {
    const auto level = static_cast<std::size_t>(options.isa.value_or(best_isa()));
    const bool keep = options.border.value_or(operation.border) == Border::keep;
    engine_ = std::make_unique<LaneEngine>(*(*operation.lane_kernels)[level], height,
                                           operation.max_iterations, keep, options.threads);
    return;
  }
  while (plans.size() < static_cast<std::size_t>(options.threads)) plans.push_back(plan());
  engine_ = std::make_unique<SingleEngine>(std::move(plans));
}

ThinningBatch::ThinningBatch(std::string_view operation, Index width, Index height,
                             const ThinningOptions& options)
    : ThinningBatch(operation_named(operation), width, height, options) {}

ThinningBatch::~ThinningBatch() = default;
ThinningBatch::ThinningBatch(ThinningBatch&&) noexcept = default;
ThinningBatch& ThinningBatch::operator=(ThinningBatch&&) noexcept = default;

int ThinningBatch::run(const ConstStackView& source, const StackView& destination) {
  check_stacks(source, destination);
  if (source.width != width_ || source.height != height_) {
    throw std::invalid_argument("the batch is for images of " + size_text(width_, height_) +
                                ", these are " + size_text(source.width, source.height));
  }
  if (source.count == 0) return 0;
  if (source.width == 0 || source.height == 0) return 1;
  return engine_->run(source, destination);
}

bool ThinningBatch::one_by_one() const {
  return engine_->one_by_one();
}

int thin_batch(std::string_view operation, const ConstStackView& source,
               const StackView& destination, const ThinningOptions& options) {
  const ThinningOperation& found = operation_named(operation);
  check_stacks(source, destination);
  return ThinningBatch(found, source.width, source.height, options).run(source, destination);
}

}  // namespace thinbench
