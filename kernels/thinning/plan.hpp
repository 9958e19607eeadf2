// A plan owns the memory that one variant needs for images of one size, so that running it
// allocates nothing; only load() may, the first time. This is the fast way into the library;
// thinbench.hpp has the convenient one.
#pragma once

#include <memory>
#include <optional>

#include "thinning/variant.hpp"

namespace thinbench::detail {

struct ThinningState;  // one implementation a kind of engine, in plan.cpp

struct PlanOptions {
  int threads = 1;                                      // counts for threaded variants only
  std::shared_ptr<const RuleModel> model = nullptr;     // instead of the operation's own
  std::optional<Border> border = std::nullopt;          // instead of the operation's own
  std::optional<Directions> directions = std::nullopt;  // of a scan; all where none are given
};

/// Runs one variant on images of one size. Not for use by two threads at once.
class ThinningPlan {
 public:
  /// Throws std::invalid_argument where the variant cannot run here, the size is negative or has
  /// more than 2^40 pixels, threads is not in [1, kMaxThreads], a model is given to an operation
  /// that takes none, directions to one that is no scan, or 8-bit sums cannot express the model;
  /// std::bad_alloc where memory is short.
  ThinningPlan(const ThinningOperation& operation, const ThinningVariant& variant, Index width,
               Index height, const PlanOptions& options = {});
  ~ThinningPlan();
  ThinningPlan(ThinningPlan&&) noexcept;
  ThinningPlan& operator=(ThinningPlan&&) noexcept;
  ThinningPlan(const ThinningPlan&) = delete;
  ThinningPlan& operator=(const ThinningPlan&) = delete;

  /// Thins `source` (0 is light, anything else dark) into `destination` (0 and 255) and returns how
  /// many passes it took, the last one, which changed nothing, included. The two may be the same
  /// image. Both must have the size of the plan; nothing is checked here.
  int run(ConstImageView source, ImageView destination);

  /// The three steps of run, for timing them apart: into the variant's own representation; passes
  /// until nothing changes (the input is kept, so this may be repeated); and back to bytes. The
  /// last two work on what load() took; run() need not leave anything for them.
  void load(ConstImageView source);
  int thin();
  void store(ImageView destination) const;

  /// For tests: whether everything outside the rows of the plan's planes is still zero.
  [[nodiscard]] bool margins_are_zero() const;

 private:
  std::unique_ptr<ThinningState> state_;
};

}  // namespace thinbench::detail
