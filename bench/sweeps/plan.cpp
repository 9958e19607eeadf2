#include "sweeps/plan.hpp"

#include <algorithm>
#include <array>
#include <regex>

#include "harness/rows.hpp"
#include "support/text.hpp"
#include "sweeps/variants.hpp"

namespace thinbench {
namespace {

constexpr std::array kSweeps = {
    SweepInfo{"density", "percent of noise that is foreground, side of its blocks"},
    SweepInfo{"size", "side of a square of the scene, awkward ones too"},
    SweepInfo{"threads", "1 to all, on the scene and on 10 x 10 of it"},
    SweepInfo{"depth", "side of foreground squares, which iterations have to erode"},
    SweepInfo{"enlarged", "times that the scene is enlarged, strokes to 580 pixels"},
    SweepInfo{"isa", "ISA, every technique, on the scene"},
};

constexpr Index kSceneWidth = 510;
constexpr Index kSceneHeight = 412;

constexpr std::array kAwkwardSides = {33, 63, 65, 100, 127, 511, 513, 1000, 1023, 1025, 2049, 4095};

using Names = std::vector<std::string_view>;

/// With zero padding and without a limit: their cases have the plain names.
const Names& drawn_operations() {
  static const Names names = {"thin_guo_hall", "thin_naccache_shinghal",
                              "skeleton_scan", "edges_sobel",
                              "holes",         "localise_objects"};
  return names;
}

/// Collects the points of one sweep after another.
class Planner {
 public:
  Planner(const SweepPlanOptions& options, const std::vector<Operation>& operations)
      : options_(options), operations_(operations) {
    // Rejects a malformed filter in words of its own.
    static_cast<void>(matching_rows(options.filter, {1}, operations));
    pattern_ = std::regex(options.filter);
  }

  std::vector<Point> all() {
    for (const SweepInfo& info : kSweeps) {
      if (is_wanted(info.name)) add_sweep(info.name);
    }
    return std::move(points_);
  }

 private:
  [[nodiscard]] bool is_wanted(std::string_view sweep) const {
    const auto& only = options_.only;
    return only.empty() || std::find(only.begin(), only.end(), sweep) != only.end();
  }

  void add_sweep(std::string_view sweep) {
    if (sweep == "density") add_density();
    if (sweep == "size") add_sizes();
    if (sweep == "threads") add_threads();
    if (sweep == "depth") add_depths();
    if (sweep == "enlarged") add_enlargements();
    if (sweep == "isa") add_levels();
  }

  void add_density() {
    const Index side = options_.quick ? 1024 : 2048;
    const int step = options_.quick ? 25 : 10;
    const std::vector<Index> grains = options_.quick ? std::vector<Index>{1, 4, 16}
                                                     : std::vector<Index>{1, 2, 3, 4, 6, 8, 12, 16};
    const Names names = {"thin_guo_hall", "thin_zhang_suen", "thin_naccache_shinghal", "holes",
                         "euler_number"};
    for (const Index grain : grains) {
      for (int percent = 0; percent <= 100; percent += step) {
        const Point point{"density",
                          static_cast<double>(percent),
                          static_cast<double>(grain),
                          {Picture::noise, side, side, grain, percent}};
        add_chosen(point, names);
      }
    }
  }

  void add_sizes() {
    const Index largest = options_.quick ? 1024 : 8192;
    std::vector<Index> sides(kAwkwardSides.begin(), kAwkwardSides.end());
    for (Index side = 32; side <= largest; side *= 2) sides.push_back(side);
    std::sort(sides.begin(), sides.end());
    for (const Index side : sides) {
      if (side > largest + 1) continue;
      const Point point{"size", static_cast<double>(side), {}, {Picture::scene, side, side}};
      add_chosen(point, drawn_operations());
      add_scalar(point, drawn_operations());
    }
  }

  /// The same technique on one thread is what threads are compared with.
  void add_threads() {
    for (const Index tiles : options_.quick ? std::vector<Index>{1} : std::vector<Index>{1, 10}) {
      const SweepInput input{Picture::scene, tiles * kSceneWidth, tiles * kSceneHeight};
      for (const int threads : thread_steps(options_.processors)) {
        const Point point{"threads", static_cast<double>(threads),
                          static_cast<double>(input.pixels()), input};
        for_each(drawn_operations(), [&](const Operation& operation) {
          const Variant* variant = chosen_variant(operation, input.width, true);
          const Variant* alone = variant == nullptr ? nullptr : on_one_thread(operation, *variant);
          add(point, operation, threads == 1 ? alone : variant, threads);
        });
      }
    }
  }

  void add_depths() {
    const Index side = options_.quick ? 1024 : 2048;
    for (Index depth = 4; depth <= side / 4; depth *= 2) {
      const Point point{
          "depth", static_cast<double>(depth), {}, {Picture::squares, side, side, depth}};
      add_chosen(point, {"thin_guo_hall", "thin_zhang_suen", "thin_naccache_shinghal",
                         "thin_spta_directional", "thin_mb2", "skeleton_scan"});
    }
  }

  void add_enlargements() {
    for (const Index times :
         options_.quick ? std::vector<Index>{1, 2} : std::vector<Index>{1, 2, 5, 10}) {
      const Point point{"enlarged",
                        static_cast<double>(times),
                        {},
                        {Picture::enlarged, times * kSceneWidth, times * kSceneHeight, times}};
      add_chosen(point, {"thin_guo_hall", "thin_zhang_suen", "thin_naccache_shinghal",
                         "thin_spta_directional", "thin_mb2", "holes"});
    }
  }

  void add_levels() {
    const SweepInput input{Picture::scene, kSceneWidth, kSceneHeight};
    Names names = drawn_operations();
    names.insert(names.begin() + 1, "thin_zhang_suen");
    for_each(names, [&](const Operation& operation) {
      for (const Variant& variant : operation.variants) {
        if (variant.is_peer || variant.threaded) continue;
        const Point point{"isa", static_cast<double>(variant.isa), {}, input};
        add(point, operation, &variant, 1);
      }
    });
  }

  void add_chosen(const Point& point, const Names& names) {
    for_each(names, [&](const Operation& operation) {
      add(point, operation, chosen_variant(operation, point.input.width, false), 1);
    });
  }

  void add_scalar(const Point& point, const Names& names) {
    for_each(names, [&](const Operation& operation) {
      const Variant* scalar = scalar_variant(operation, point.input.width);
      if (scalar == chosen_variant(operation, point.input.width, false)) return;
      add(point, operation, scalar, 1);
    });
  }

  void for_each(const Names& names, const std::function<void(const Operation&)>& add_points) const {
    for (const Operation& operation : operations_) {
      if (std::find(names.begin(), names.end(), operation.name) != names.end()) {
        add_points(operation);
      }
    }
  }

  void add(Point point, const Operation& operation, const Variant* variant, int threads) {
    if (variant == nullptr || !variant->unavailable_reason(point.input.width).empty()) return;
    point.operation = &operation;
    point.variant = variant;
    point.threads = threads;
    if (std::regex_search(point.row(), pattern_)) points_.push_back(point);
  }

  const SweepPlanOptions& options_;
  const std::vector<Operation>& operations_;
  std::regex pattern_;
  std::vector<Point> points_;
};

}  // namespace

std::span<const SweepInfo> all_sweeps() {
  return kSweeps;
}

std::string Point::row() const {
  return row_name(operation->name, variant->technique, variant->isa_label(), threads);
}

std::string Point::name() const {
  std::string text(sweep);
  text.append(" x=").append(fixed(x, 0));
  if (y) text.append(" y=").append(fixed(*y, 0));
  return text + " " + row() + " on " + input.name();
}

std::vector<Point> plan_points(const SweepPlanOptions& options,
                               const std::vector<Operation>& operations) {
  return Planner(options, operations).all();
}

std::vector<int> thread_steps(int processors) {
  std::vector<int> steps;
  for (int threads = 1; threads < processors; threads += threads < 8 ? 1 : threads / 2) {
    steps.push_back(threads);
  }
  steps.push_back(processors);
  return steps;
}

}  // namespace thinbench
