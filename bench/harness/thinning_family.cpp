#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/packed_rows.hpp"
#include "core/packing.hpp"
#include "core/planes.hpp"
#include "harness/library_operation.hpp"
#include "reference.hpp"
#include "rules/trained_cluster.hpp"

namespace thinbench {
namespace {

using detail::ThinningState;
using detail::ThinningVariant;
using reference::Repetition;

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
class StateJob final : public ResultJob<Iterations> {
 public:
  explicit StateJob(std::unique_ptr<ThinningState> state) : state_(std::move(state)) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    result.number = state_->run(input, output);
  }
  void load(const ConstImageView& input) override {
    const Index width = input.width, height = input.height;
    detail::BitPlane bits(width, height);
    conversion_.read(input, bits.view());
    detail::write_packed(bits.view(), source_.emplace(width, height).view());
    skeleton_.emplace(width, height);
  }
  void kernel() override {
    result.number = state_->run(ConstPackedView(source_.value().view()), skeleton_.value().view());
  }
  void store(const ImageView& output) const override {
    detail::BitPlane bits(output.width, output.height);
    detail::read_packed(skeleton_.value().view(), bits.view());
    conversion_.write(bits.view(), output);
  }

 private:
  std::unique_ptr<ThinningState> state_;
  const detail::PlaneConversion<std::uint64_t>& conversion_ =
      detail::plane_conversion<std::uint64_t>(Isa::baseline);
  std::optional<PackedImage> source_;
  std::optional<PackedImage> skeleton_;
};

/// Whether a technique works on bits. Others would convert them to bytes.
bool has_kernel_scope(std::string_view technique) {
  constexpr std::array<std::string_view, 4> on_bytes = {"lut", "lut_sliding", "autovec",
                                                        "simd_bytes"};
  return std::find(on_bytes.begin(), on_bytes.end(), technique) == on_bytes.end();
}

std::string case_name(std::string_view operation, const Repetition& repetition) {
  const auto& [border, max_iterations] = repetition;
  std::string name(operation);
  if (border != Border::background) name.append(":").append(border_name(border));
  if (max_iterations != kUnlimited) name.append(":").append(std::to_string(max_iterations));
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

Variant library_variant(const detail::VariantInfo& variant, JobMaker make_job,
                        std::string_view description) {
  if (description.empty()) {
    description = detail::study::technique_info(variant.technique).description;
  }
  return {variant.technique,
          description,
          variant.isa,
          variant.threaded,
          false,
          std::move(make_job),
          [variant](Index width) { return detail::unavailable_reason(variant, width); },
          variant.priority};
}

std::unique_ptr<Job> thinning_job(std::unique_ptr<ThinningState> state) {
  return std::make_unique<StateJob>(std::move(state));
}

namespace {

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
constexpr std::array kStudyReferences = {&reference::spta, &thin_by_sigmoid, &thin_by_rounded,
                                         &thin_by_linear, &thin_by_cluster};
static_assert(kStudyReferences.size() == detail::study::kStudyRules.size());

/// Of a rule of the product or of the study; nullptr for other names.
reference::Thinning find_reference(std::string_view rule) {
  if (const auto built_in = rule_from_name(rule)) return reference::thinning(*built_in);
  for (const auto& info : detail::study::kStudyRules) {
    if (info.name == rule || info.operation == rule) {
      return kStudyReferences[static_cast<std::size_t>(info.rule)];
    }
  }
  return nullptr;
}

[[noreturn]] void throw_no_reference(std::string_view rule) {
  throw std::logic_error("no reference for the rule " + std::string(rule));
}

}  // namespace

reference::Thinning reference_named(std::string_view rule) {
  const reference::Thinning function = find_reference(rule);
  if (function == nullptr) throw_no_reference(rule);
  return function;
}

int thin_by_reference(const Rule& rule, const Repetition& repetition, const ConstImageView& source,
                      const ImageView& destination) {
  const reference::Thinning function = find_reference(rule.name());
  if (function != nullptr && repetition.border != Border::foreground) {
    return function(repetition, source, destination);
  }
  if (rule.sub_iterations().empty()) throw_no_reference(rule.name());
  return reference::apply_tables(rule.sub_iterations(), repetition, source, destination);
}

int thin_by_reference(const Rule& rule, const Thinning& thinning, const ConstImageView& source,
                      const ImageView& destination) {
  const Repetition repetition = {thinning.border.value_or(rule.border()),
                                 thinning.max_iterations.value_or(rule.max_iterations())};
  return thin_by_reference(rule, repetition, source, destination);
}

namespace {

/// The variants of a case; those of the complement where everything outside is foreground.
std::vector<ThinningVariant> variants_of(const detail::ThinningOperation& operation,
                                         const detail::ThinningParameters& parameters) {
  return parameters.complemented ? detail::thinning_variants(*parameters.rule) : operation.variants;
}

}  // namespace

Operation thinning_operation(const detail::ThinningOperation& operation,
                             const Repetition& repetition) {
  const Rule& rule = operation.key;
  const bool is_net = is_net_rule(rule);
  const detail::ThinningParameters parameters =
      detail::thinning_parameters(rule, {repetition.border, repetition.max_iterations});
  Operation result =
      case_of(operation, InputKind::binary,
              counting_job_maker([rule, repetition](const auto& input, const auto& output) {
                return thin_by_reference(rule, repetition, input, output);
              }));
  result.name = case_name(operation.name, repetition);
  add_variants(result, variants_of(operation, parameters),
               [parameters](const auto& variant, Index width, Index height, int threads) {
                 return thinning_job(make_state(variant, width, height, parameters, threads));
               });
  for (Variant& variant : result.variants) {
    variant.has_kernel_scope = has_kernel_scope(variant.technique);
  }
  result.counts_iterations = true;
  result.is_net = is_net && is_exact(rule);
  result.border = repetition.border;
  if (repetition.max_iterations != kUnlimited) result.max_iterations = repetition.max_iterations;
  result.small_sets_only =
      (is_net && !result.max_iterations) || repetition.border == Border::foreground;
  result.timed = repetition.border == Border::background ||
                 (repetition.border == Border::keep && has_peer_with_border(rule));
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
