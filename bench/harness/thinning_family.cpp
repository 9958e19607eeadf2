#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/packed_rows.hpp"
#include "core/packing.hpp"
#include "core/planes.hpp"
#include "harness/families.hpp"
#include "reference.hpp"
#include "rules/trained_cluster.hpp"

namespace thinbench {
namespace {

using detail::ThinningState;
using detail::ThinningVariant;

/// What all thinning gives beside the image.
class CountingJob : public Job {
 public:
  [[nodiscard]] std::vector<std::int64_t> numbers() const override { return {iterations_}; }
  [[nodiscard]] std::string name_of_number(std::size_t) const override { return "iterations"; }

 protected:
  int iterations_ = 0;
};

/// Owns a packed image. Its bits are in the order of the kernels' words.
class PackedImage {
 public:
  PackedImage(Index width, Index height)
      : bytes_(static_cast<std::size_t>(packed_row_bytes(width) * height)),
        view_(bytes_.data(), width, height, BitOrder::lsb_first) {}

  [[nodiscard]] const PackedView& view() const { return view_; }

 private:
  std::vector<std::uint8_t> bytes_;
  PackedView view_;
};

/// The kernel is thinning from packed bits to packed bits.
class StateJob final : public CountingJob {
 public:
  explicit StateJob(std::unique_ptr<ThinningState> state) : state_(std::move(state)) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    iterations_ = state_->run(input, output);
  }
  void load(const ConstImageView& input) override {
    const Index width = input.width, height = input.height;
    detail::BitPlane bits(width, height);
    conversion_.read(input, bits.view());
    detail::write_packed(bits.view(), source_.emplace(width, height).view());
    result_.emplace(width, height);
  }
  void kernel() override {
    iterations_ = state_->run(ConstPackedView(source_.value().view()), result_.value().view());
  }
  void store(const ImageView& output) const override {
    detail::BitPlane bits(output.width, output.height);
    detail::read_packed(result_.value().view(), bits.view());
    conversion_.write(bits.view(), output);
  }

 private:
  std::unique_ptr<ThinningState> state_;
  const detail::PlaneConversion<std::uint64_t>& conversion_ =
      detail::plane_conversion<std::uint64_t>(Isa::baseline);
  std::optional<PackedImage> source_;
  std::optional<PackedImage> result_;
};

/// Whether a technique works on bits. Others would convert them to bytes.
bool has_kernel_scope(std::string_view technique) {
  constexpr std::array<std::string_view, 4> on_bytes = {"lut", "lut_sliding", "autovec",
                                                        "simd_bytes"};
  return std::find(on_bytes.begin(), on_bytes.end(), technique) == on_bytes.end();
}

class FunctionJob final : public CountingJob {
 public:
  using Function = std::function<int(const ConstImageView& input, const ImageView& output)>;

  explicit FunctionJob(Function function) : function_(std::move(function)) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    iterations_ = function_(input, output);
  }

 private:
  Function function_;
};

std::string case_name(std::string_view operation, const ThinningCase& options) {
  std::string name(operation);
  if (options.border != Border::background) name.append(":").append(border_name(options.border));
  if (options.max_iterations != kUnlimited) {
    name.append(":").append(std::to_string(options.max_iterations));
  }
  return name;
}

bool is_net_rule(const Rule& rule) {
  return rule.name().starts_with("net_");
}

/// Of nets: whether they decide as the rule that they learned.
bool is_exact(const Rule& net) {
  return net.sub_iterations().front() == Rule(Rule::naccache_shinghal).sub_iterations().front();
}

/// OpenCV keeps the border, by these two rules.
bool has_peer_with_border(const Rule& rule) {
  return rule.name() == "zhang_suen" || rule.name() == "guo_hall";
}

}  // namespace

Variant library_variant(const detail::VariantInfo& variant, bool has_kernel_scope,
                        JobMaker make_job) {
  const detail::study::TechniqueInfo& info = detail::study::technique_info(variant.technique);
  return {info.name,
          info.description,
          variant.isa,
          variant.threaded,
          has_kernel_scope,
          std::move(make_job),
          [variant](Index width) { return detail::unavailable_reason(variant, width); },
          variant.priority};
}

std::unique_ptr<Job> thinning_job(std::unique_ptr<ThinningState> state) {
  return std::make_unique<StateJob>(std::move(state));
}

std::unique_ptr<Job> counting_job(
    std::function<int(const ConstImageView& input, const ImageView& output)> function) {
  return std::make_unique<FunctionJob>(std::move(function));
}

namespace {

using reference::Repetition;

int thin_by_sigmoid(const Repetition& repetition, ConstImageView from, ImageView to) {
  return reference::net_two_layer(kPaperTwoLayer, Activation::sigmoid, repetition, from, to);
}
int thin_by_rounded(const Repetition& repetition, ConstImageView from, ImageView to) {
  return reference::net_two_layer(detail::kRoundedTwoLayer, Activation::sigmoid, repetition, from,
                                  to);
}
int thin_by_linear(const Repetition& repetition, ConstImageView from, ImageView to) {
  return reference::net_two_layer(kPaperTwoLayer, Activation::linear, repetition, from, to);
}
int thin_by_cluster(const Repetition& repetition, ConstImageView from, ImageView to) {
  return reference::net_single_layer_cluster(detail::kTrainedCluster, repetition, from, to);
}

/// In the order of detail::study::kStudyRules.
constexpr reference::Thinning kStudyReferences[] = {
    &reference::spta, &thin_by_sigmoid, &thin_by_rounded, &thin_by_linear, &thin_by_cluster};

}  // namespace

reference::Thinning reference_named(std::string_view rule) {
  if (const auto built_in = rule_from_name(rule)) return reference::thinning(*built_in);
  for (const auto& info : detail::study::kStudyRules) {
    if (info.name == rule || info.operation == rule) {
      return kStudyReferences[static_cast<std::size_t>(info.rule)];
    }
  }
  return nullptr;
}

namespace {

/// The variants of a case; those of the complement where everything outside is foreground.
std::vector<ThinningVariant> variants_of(const detail::ThinningOperation& operation,
                                         const detail::ThinningParameters& parameters) {
  return parameters.complemented ? detail::thinning_variants(*parameters.rule) : operation.variants;
}

/// A reference by the name of the rule or, with foreground outside, by its tables.
JobMaker reference_of(const Rule& rule, const ThinningCase& options) {
  const reference::Repetition repetition = {options.border, options.max_iterations};
  if (options.border != Border::foreground) {
    return [repetition, function = reference_named(rule.name())](Index, Index, int) {
      return counting_job(
          [repetition, function](const ConstImageView& input, const ImageView& output) {
            return function(repetition, input, output);
          });
    };
  }
  return [repetition, rule](Index, Index, int) {
    return counting_job([repetition, rule](const ConstImageView& input, const ImageView& output) {
      return reference::apply_tables(rule.sub_iterations(), repetition, input, output);
    });
  };
}

}  // namespace

Operation thinning_operation(const detail::ThinningOperation& operation,
                             const ThinningCase& options) {
  const Rule& rule = operation.key;
  const bool is_net = is_net_rule(rule);
  const detail::ThinningParameters parameters =
      detail::thinning_parameters(rule, {options.border, options.max_iterations});
  Operation result = {
      case_name(operation.name, options), operation.description, InputKind::binary, {}, {}};
  for (const ThinningVariant& variant : variants_of(operation, parameters)) {
    result.variants.push_back(library_variant(
        variant, has_kernel_scope(variant.technique),
        [variant, parameters](Index width, Index height, int threads) {
          return thinning_job(make_state(variant, width, height, parameters, threads));
        }));
  }
  result.reference = reference_of(rule, options);
  result.counter = "iterations";
  result.is_net = is_net && is_exact(rule);
  result.operation = operation.name;
  result.border = options.border;
  if (options.max_iterations != kUnlimited) result.max_iterations = options.max_iterations;
  result.small_sets_only =
      (is_net && !result.max_iterations) || options.border == Border::foreground;
  result.timed = options.border == Border::background ||
                 (options.border == Border::keep && has_peer_with_border(rule));
  return result;
}

std::vector<Operation> thinning_family() {
  std::vector<Operation> family;
  for (const detail::ThinningOperation& operation : detail::study::thinning_operations()) {
    for (const Border border : {Border::background, Border::keep}) {
      family.push_back(thinning_operation(operation, {border}));
      const bool has_single = is_net_rule(operation.key) && is_exact(operation.key);
      if (has_single) family.push_back(thinning_operation(operation, {border, 1}));
    }
    if (detail::body_of(operation.key)->complement == nullptr) continue;
    family.push_back(thinning_operation(operation, {Border::foreground}));
  }
  return family;
}

}  // namespace thinbench
