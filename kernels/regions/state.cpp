#include "regions/state.hpp"

#include <atomic>
#include <string>

#include "core/exported.hpp"
#include "regions/fill_kernels.hpp"
#include "thinbench/enumeration.hpp"

namespace thinbench::detail {
namespace {

template <class State>
std::unique_ptr<State> make(const Setting<typename State::Parameters>& setting) {
  return std::make_unique<State>(setting);
}

std::unique_ptr<ListState> make_lists(const ListSetting& setting) {
  return std::make_unique<ListState>(kernels_of<RunEngine>(setting.isa), setting);
}

std::vector<Variant<ListState>> list_variants() {
  VariantList<ListState> list;
  for (const Isa isa : isas_of<RunEngine>()) {
    list.add_with_threads("simd_runs", isa, &make_lists, {2});
  }
  return list.take();
}

/// Variants for the baseline, and for each other ISA that the kernels are compiled for.
template <class State, class Kernels>
std::vector<Variant<State>> variants_of(std::string_view of_baseline, std::string_view of_others,
                                        bool with_threads) {
  VariantList<State> list;
  for (const Isa isa : isas_of<Kernels>()) {
    const std::string_view technique = isa == Isa::baseline ? of_baseline : of_others;
    list.add(technique, isa, &make<State>, {1});
    if (with_threads) list.add(technique, isa, &make<State>, {1}, true);
  }
  return list.take();
}

std::vector<Variant<LabelState>> label_variants() {
  return variants_of<LabelState, LabelEngine>("bitpacked_contacts", "simd_contacts", true);
}

std::vector<Variant<FillState>> fill_variants() {
  return variants_of<FillState, FloodKernels>("bitpacked_flood", "simd_flood", false);
}

std::vector<Variant<EulerState>> euler_variants() {
  return variants_of<EulerState, EulerKernels>("bitpacked", "simd_bitpacked", true);
}

}  // namespace

void LabelState::check(const LabelParameters& parameters, Index width, Index height) {
  require_enumerator(parameters.order, 2, "order");
  require_label_size(width, height);
}

Label LabelState::run(const ConstImageView& source, const LabelView& labels, Regions& found) {
  if (source.width == 0 || source.height == 0) return 0;
  const ConstBitPlaneView image = image_.read(source, team_);
  const Label objects = contacts_.find(image, found);
  contacts_.paint(labels);
  return objects;
}

EulerState::EulerState(const EulerSetting& setting)
    : kernel_(setting.objects == Connectivity::four ? kernels_of<EulerKernels>(setting.isa).four
                                                    : kernels_of<EulerKernels>(setting.isa).eight),
      image_(setting.isa, setting.width, setting.height),
      team_(setting.threads) {}

std::int64_t EulerState::count(const ConstBitPlaneView& image) const {
  std::atomic<std::int64_t> number = 0;
  team_.for_ranges(image.height + 1, [&](Index first, Index last) {
    number.fetch_add(kernel_(image, first, last), std::memory_order_relaxed);
  });
  return number;
}

void FillState::check(const HoleFilling& filling, Index width, Index height) {
  require_regions_size(width, height);
  require_filling(filling);
}

FillState::FillState(const FillSetting& setting)
    : conversion_(plane_conversion<std::uint64_t>(setting.isa)),
      image_(setting.isa, setting.width, setting.height),
      filler_(setting.isa, setting),
      filled_(setting.width, setting.height) {}

std::span<const ListOperation> list_operations() {
  static const auto& operations = never_destroyed(std::vector<ListOperation>{
      {true, "holes", "objects (8-connected) and their holes, with areas and centres",
       list_variants()},
      {false, "objects", "objects (8-connected) alone, with areas and centres", list_variants()}});
  return operations;
}

std::span<const LabelOperation> label_operations() {
  static const auto& operations = never_destroyed(std::vector<LabelOperation>{
      {LabelTask::image_eight, "label_image", "label image of 8-connected objects",
       label_variants()},
      {LabelTask::image_four, "label_image_4", "label image of 4-connected objects",
       label_variants()},
      {LabelTask::objects_eight, "label_objects",
       "label image of 8-connected objects, with areas and centres", label_variants()},
      {LabelTask::objects_four, "label_objects_4",
       "label image of 4-connected objects, with areas and centres", label_variants()},
      {LabelTask::regions, "label_regions",
       "label image of objects (8-connected) and their holes, with areas and centres",
       label_variants()}});
  return operations;
}

std::span<const EulerOperation> euler_operations() {
  static const auto& operations = never_destroyed(std::vector<EulerOperation>{
      {Connectivity::eight, "euler_number", "8-connected objects minus 4-connected holes",
       euler_variants()},
      {Connectivity::four, "euler_number_4", "4-connected objects minus 8-connected holes",
       euler_variants()}});
  return operations;
}

std::span<const FillOperation> fill_operations() {
  static const auto& operations = never_destroyed(std::vector<FillOperation>{
      {Connectivity::eight, "fill_holes",
       "objects with all that they enclose, interior contours filled", fill_variants()},
      {Connectivity::four, "fill_holes_4", "4-connected objects with all that they enclose",
       fill_variants()}});
  return operations;
}

const ListOperation& operation_of(const ListParameters& parameters) {
  return operation_with(parameters.with_holes, list_operations(), "with_holes");
}

const LabelOperation& operation_of(const LabelParameters& parameters) {
  return operation_with(parameters.task, label_operations(), "task");
}

const EulerOperation& operation_of(const EulerParameters& parameters) {
  require_connectivity(static_cast<int>(parameters.objects));
  return operation_with(parameters.objects, euler_operations(), "objects");
}

const FillOperation& operation_of(const HoleFilling& filling) {
  require_filling(filling);
  return operation_with(filling.objects, fill_operations(), "objects");
}

void require_filling(const HoleFilling& filling) {
  require_connectivity(static_cast<int>(filling.objects));
  require(filling.max_area >= 0,
          [&] { return "max_area: expected at least 0, got " + std::to_string(filling.max_area); });
}

}  // namespace thinbench::detail
