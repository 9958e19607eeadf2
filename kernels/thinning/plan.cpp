#include "thinning/plan.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "image/checks.hpp"
#include "nets/model.hpp"
#include "midpoints/state.hpp"
#include "thinning/iteration/iterate.hpp"
#include "thinning/iteration/state.hpp"
#include "thinning/iteration/tile_state.hpp"

namespace thinbench::detail {
namespace {

void check(const ThinningVariant& variant, Index width, Index height, int threads, Border border) {
  require_size(width, height);
  require_max_pixels(width, height);
  require_threads(threads);
  require_available(facts_of(variant), width);
  require(knows_border(variant, border), std::string(technique_name(variant.technique)) + " at " +
                                             std::string(isa_name(variant.isa)) +
                                             " cannot run: " + std::string(kDoesNotKeepBorder));
}

/// What a state needs to know beside its engine.
struct Setting {
  Isa isa;
  Index width;
  Index height;
  int threads;
  int max_iterations;
  Border border;
  Directions directions;
  std::shared_ptr<const RuleModel> model;

  [[nodiscard]] Conditions conditions() const { return {model.get(), max_iterations, border}; }
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
  require(variant.technique != Technique::simd_fixed_point || model->fixed_point_is_exact,
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

/// Passes over planes of T.
template <class T>
struct PassState final : PlaneState<T> {
  using PlaneState<T>::planes;
  using PlaneState<T>::team;

  PassState(std::span<const Pass<T>> passes, const Setting& chosen)
      : PlaneState<T>(chosen.isa, chosen.width, chosen.height, chosen.threads),
        cycle(passes),
        setting(chosen),
        scratch(setting.width, setting.height),
        activity(setting.height, planes.result.view().row_elements,
                 sizeof(T) == 1 ? kWordBits : 1) {}

  int thin() override {
    const auto& source = planes.source;
    return iterate<T>(cycle, setting.conditions(), source.view(), planes.result.view(),
                      scratch.view(), activity, team);
  }
  [[nodiscard]] bool margins_are_zero() const override {
    return PlaneState<T>::margins_are_zero() && scratch.margin_is_zero();
  }

  std::span<const Pass<T>> cycle;
  Setting setting;
  Plane<T> scratch;
  TileActivity activity;
};

/// One pass that sees what the last step changed.
struct ChangeState final : PlaneState<std::uint64_t> {
  ChangeState(ChangePass change_pass, const Setting& chosen)
      : PlaneState(chosen.isa, chosen.width, chosen.height, chosen.threads),
        pass(change_pass),
        setting(chosen),
        scratch{BitPlane(chosen.width, chosen.height), BitPlane(chosen.width, chosen.height)},
        activity(chosen.height, planes.result.view().row_elements, 1) {}

  int thin() override {
    const auto& source = planes.source;
    return iterate_changes(pass, setting.conditions(), source.view(),
                           {planes.result.view(), scratch[0].view(), scratch[1].view()}, activity,
                           team);
  }
  [[nodiscard]] bool margins_are_zero() const override {
    return PlaneState::margins_are_zero() && scratch[0].margin_is_zero() &&
           scratch[1].margin_is_zero();
  }

  ChangePass pass;
  Setting setting;
  std::array<BitPlane, 2> scratch;
  TileActivity activity;
};

/// One kernel over rows of one register.
struct RowState final : PlaneState<std::uint64_t> {
  RowState(RowKernel row_kernel, const Setting& chosen)
      : PlaneState(chosen.isa, chosen.width, chosen.height),
        kernel(row_kernel),
        setting(chosen),
        scratch(make_aligned<std::uint64_t>(
            static_cast<std::size_t>(row_kernel_scratch_words(chosen.height)))) {}

  int thin() override {
    const auto& source = planes.source;
    return kernel(setting.model.get(), setting.max_iterations, source.view(), planes.result.view(),
                  scratch.get());
  }

  RowKernel kernel;
  Setting setting;
  AlignedArray<std::uint64_t> scratch;
};

/// One kernel over planes of T.
template <class T>
struct ImageState final : PlaneState<T> {
  using PlaneState<T>::planes;

  ImageState(const ImageKernel<T>& image_kernel, const Setting& chosen)
      : PlaneState<T>(chosen.isa, chosen.width, chosen.height),
        kernel(image_kernel),
        directions(chosen.directions),
        scratch(make_aligned<std::uint64_t>(
            static_cast<std::size_t>(kernel.scratch_words(chosen.width, chosen.height)))) {}

  int thin() override {
    const auto& source = planes.source;
    return kernel.run(directions, source.view(), planes.result.view(), scratch.get());
  }

  const ImageKernel<T>& kernel;
  Directions directions;
  AlignedArray<std::uint64_t> scratch;
};

}  // namespace

ThinningPlan::ThinningPlan(const ThinningOperation& operation, const ThinningVariant& variant,
                           Index width, Index height, const PlanOptions& options) {
  const Border border = options.border.value_or(operation.border);
  check(variant, width, height, options.threads, border);
  require(operation.takes_directions || !options.directions,
          std::string(operation.name) + " takes no directions");
  const Setting setting = {variant.isa,
                           width,
                           height,
                           variant.threaded ? options.threads : 1,
                           operation.max_iterations,
                           border,
                           options.directions.value_or(Directions{}),
                           chosen_model(operation, variant, options.model)};
  const auto make = [&](const auto& engine) -> std::unique_ptr<ThinningState> {
    using Engine = std::remove_cvref_t<decltype(engine)>;
    if constexpr (std::is_same_v<Engine, const RowKernel*>) {
      return std::make_unique<RowState>(*engine, setting);
    } else if constexpr (std::is_same_v<Engine, TileEngine>) {
      return std::make_unique<TileState>(
          engine, TileSetting{variant.isa, width, height, setting.threads, setting.max_iterations});
    } else if constexpr (std::is_same_v<Engine, const ChangePass*>) {
      return std::make_unique<ChangeState>(*engine, setting);
    } else if constexpr (std::is_same_v<Engine, const ScanKernels*>) {
      return std::make_unique<ScanState>(
          *engine, ScanSetting{variant.isa, width, height, setting.threads, setting.directions});
    } else if constexpr (std::is_pointer_v<Engine>) {
      return std::make_unique<decltype(ImageState(*engine, setting))>(*engine, setting);
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

void ThinningPlan::load(ConstImageView source) {
  state_->load(source);
}
int ThinningPlan::thin() {
  return state_->thin();
}
void ThinningPlan::store(ImageView destination) const {
  state_->store(destination);
}

bool ThinningPlan::margins_are_zero() const {
  return state_->margins_are_zero();
}

int ThinningPlan::run(ConstImageView source, ImageView destination) {
  return state_->run(source, destination);
}

}  // namespace thinbench::detail
