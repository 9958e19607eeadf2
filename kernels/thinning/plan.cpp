#include "thinning/plan.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "core/convert.hpp"
#include "core/planes.hpp"
#include "nets/model.hpp"
#include "thinning/iterate.hpp"

namespace thinbench {

bool knows_border(const ThinningVariant& variant, Border border) {
  return border == Border::kBackground || !std::holds_alternative<const RowKernel*>(variant.engine);
}

std::string_view why_unavailable(const ThinningVariant& variant, Index width, Border border) {
  if (!cpu_supports(variant.isa)) return "this machine lacks the instruction set";
  if (!isa_available(variant.isa)) return "above the ISA cap";
  if (width > variant.max_width) return "wider than this variant's limit";
  if (!knows_border(variant, border)) return "this variant does not keep the border";
  return {};
}

struct ThinningState {
  virtual ~ThinningState() = default;
  virtual void load(const ConstByteView& source) = 0;
  virtual int thin() = 0;
  virtual void store(const ByteView& destination) const = 0;
  [[nodiscard]] virtual bool margins_are_zero() const = 0;
};

namespace {

constexpr Index kMaxPixels = Index{1} << 40;

void require(bool holds, const std::string& otherwise) {
  if (!holds) throw std::invalid_argument(otherwise);
}

void check(const ThinningVariant& variant, Index width, Index height, int threads, Border border) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height);
  require(width >= 0 && height >= 0, "image size " + size + " is negative");
  require(
      width <= kMaxPixels && height <= kMaxPixels && (width == 0 || height <= kMaxPixels / width),
      "image size " + size + " is larger than 2^40 pixels");
  require(threads >= 1 && threads <= 1024,
          "threads is " + std::to_string(threads) + "; it must be in 1..1024");
  const std::string_view reason = why_unavailable(variant, width, border);
  require(reason.empty(), std::string(technique_name(variant.technique)) + " at " +
                              std::string(isa_name(variant.isa)) +
                              " cannot run: " + std::string(reason));
}

/// What a state needs to know beside its engine.
struct Setting {
  Isa isa;
  Index width;
  Index height;
  int threads;
  int most_passes;
  Border border;
  std::shared_ptr<const RuleModel> model;

  [[nodiscard]] Conditions conditions() const { return {model.get(), most_passes, border}; }
};

std::shared_ptr<const RuleModel> chosen_model(const ThinningOperation& operation,
                                              const ThinningVariant& variant,
                                              const std::shared_ptr<const RuleModel>& given) {
  const bool takes_model = operation.default_model != nullptr;
  require(takes_model || given == nullptr, std::string(operation.name) + " takes no weights");
  if (!takes_model) return nullptr;
  // The default lives as long as the program: an owner without anything to delete.
  auto model = given != nullptr ? given
                                : std::shared_ptr<const RuleModel>(std::shared_ptr<void>(),
                                                                   &operation.default_model());
  require(variant.technique != Technique::kSimdFixedPoint || model->fixed_point_is_exact,
          "simd_fixed_point cannot run: no 8-bit weights decide as these do");
  return model;
}

/// The engine of a variant, or a better one where the model has the table of a known rule.
const ThinningEngine& chosen_engine(const ThinningVariant& variant, const RuleModel* model) {
  for (const KnownRule& known : variant.known_rules) {
    if (model != nullptr &&
        std::equal(known.table->begin(), known.table->end(), model->new_pixel)) {
      return known.engine;
    }
  }
  return variant.engine;
}

/// Source and result planes with the conversions of one instruction-set level.
template <class T>
struct Planes {
  Planes(Isa isa, Index width, Index height)
      : conversion(plane_conversion<T>(isa)), source(width, height), result(width, height) {}
  const PlaneConversion<T>& conversion;
  Plane<T> source;
  Plane<T> result;
};

/// Passes over planes of T.
template <class T>
struct PassState final : ThinningState {
  PassState(std::span<const Pass<T>> passes, const Setting& chosen)
      : cycle(passes),
        setting(chosen),
        planes(setting.isa, setting.width, setting.height),
        scratch(setting.width, setting.height),
        activity(setting.height, planes.result.view().row_elements, sizeof(T) == 1 ? kWordBits : 1),
        team(setting.threads) {}

  void load(const ConstByteView& view) override {
    planes.conversion.read(view, planes.source.view());
  }
  int thin() override {
    const auto& source = planes.source;
    return iterate<T>(cycle, setting.conditions(), source.view(), planes.result.view(),
                      scratch.view(), activity, team);
  }
  void store(const ByteView& view) const override {
    planes.conversion.write(planes.result.view(), view);
  }
  [[nodiscard]] bool margins_are_zero() const override {
    return planes.source.margin_is_zero() && planes.result.margin_is_zero() &&
           scratch.margin_is_zero();
  }

  std::span<const Pass<T>> cycle;
  Setting setting;
  Planes<T> planes;
  Plane<T> scratch;
  TileActivity activity;
  ThreadTeam team;
};

/// One pass that sees what the last step changed.
struct ChangeState final : ThinningState {
  ChangeState(ChangePass change_pass, const Setting& chosen)
      : pass(change_pass),
        setting(chosen),
        planes(chosen.isa, chosen.width, chosen.height),
        scratch{BitPlane(chosen.width, chosen.height), BitPlane(chosen.width, chosen.height)},
        activity(chosen.height, planes.result.view().row_elements, 1),
        team(chosen.threads) {}

  void load(const ConstByteView& view) override {
    planes.conversion.read(view, planes.source.view());
  }
  int thin() override {
    const auto& source = planes.source;
    return iterate_changes(pass, setting.conditions(), source.view(),
                           {planes.result.view(), scratch[0].view(), scratch[1].view()}, activity,
                           team);
  }
  void store(const ByteView& view) const override {
    planes.conversion.write(planes.result.view(), view);
  }
  [[nodiscard]] bool margins_are_zero() const override {
    return planes.source.margin_is_zero() && planes.result.margin_is_zero() &&
           scratch[0].margin_is_zero() && scratch[1].margin_is_zero();
  }

  ChangePass pass;
  Setting setting;
  Planes<std::uint64_t> planes;
  std::array<BitPlane, 2> scratch;
  TileActivity activity;
  ThreadTeam team;
};

/// One kernel over rows of one register.
struct RowState final : ThinningState {
  RowState(RowKernel row_kernel, const Setting& chosen)
      : kernel(row_kernel),
        setting(chosen),
        planes(chosen.isa, chosen.width, chosen.height),
        scratch(make_aligned<std::uint64_t>(
            static_cast<std::size_t>(row_kernel_scratch_words(chosen.height)))) {}

  void load(const ConstByteView& view) override {
    planes.conversion.read(view, planes.source.view());
  }
  int thin() override {
    const auto& source = planes.source;
    return kernel(setting.model.get(), setting.most_passes, source.view(), planes.result.view(),
                  scratch.get());
  }
  void store(const ByteView& view) const override {
    planes.conversion.write(planes.result.view(), view);
  }
  [[nodiscard]] bool margins_are_zero() const override {
    return planes.source.margin_is_zero() && planes.result.margin_is_zero();
  }

  RowKernel kernel;
  Setting setting;
  Planes<std::uint64_t> planes;
  AlignedArray<std::uint64_t> scratch;
};

}  // namespace

ThinningPlan::ThinningPlan(const ThinningOperation& operation, const ThinningVariant& variant,
                           Index width, Index height, const PlanOptions& options) {
  const Border border = options.border.value_or(operation.border);
  check(variant, width, height, options.threads, border);
  const Setting setting = {variant.isa,
                           width,
                           height,
                           variant.threaded ? options.threads : 1,
                           operation.most_passes,
                           border,
                           chosen_model(operation, variant, options.model)};
  const auto make = [&](const auto& engine) -> std::unique_ptr<ThinningState> {
    using Engine = std::remove_cvref_t<decltype(engine)>;
    if constexpr (std::is_same_v<Engine, const RowKernel*>) {
      return std::make_unique<RowState>(*engine, setting);
    } else if constexpr (std::is_same_v<Engine, const ChangePass*>) {
      return std::make_unique<ChangeState>(*engine, setting);
    } else {
      using T = std::conditional_t<std::is_same_v<Engine, std::span<const Pass<std::uint8_t>>>,
                                   std::uint8_t, std::uint64_t>;
      return std::make_unique<PassState<T>>(engine, setting);
    }
  };
  state_ = std::visit(make, chosen_engine(variant, setting.model.get()));
}

ThinningPlan::~ThinningPlan() = default;
ThinningPlan::ThinningPlan(ThinningPlan&&) noexcept = default;
ThinningPlan& ThinningPlan::operator=(ThinningPlan&&) noexcept = default;

void ThinningPlan::load(ConstByteView source) {
  state_->load(source);
}
int ThinningPlan::thin() {
  return state_->thin();
}
void ThinningPlan::store(ByteView destination) const {
  state_->store(destination);
}

bool ThinningPlan::margins_are_zero() const {
  return state_->margins_are_zero();
}

int ThinningPlan::run(ConstByteView source, ByteView destination) {
  state_->load(source);
  const int passes = state_->thin();
  state_->store(destination);
  return passes;
}

}  // namespace thinbench
