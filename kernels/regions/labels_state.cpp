#include "regions/labels_state.hpp"

#include "core/features.hpp"
#include "regions/contact_labels.hpp"

namespace thinbench::detail {
namespace {

constexpr Features kContactFeatures =
    feature("popcnt") | feature("avx2") | feature("avx512bw") | feature("avx512vpopcntdq");

class ContactLabelsState final : public LabelsState {
 public:
  explicit ContactLabelsState(const LabelsSetting& setting)
      : LabelsState(setting),
        labels_(make_contact_labels(setting, setting.isa, setting.width, setting.height)) {}

  [[nodiscard]] RegionLists regions() const override { return labels_->regions(); }
  [[nodiscard]] Label objects() const override { return labels_->objects(); }

 private:
  void compute() override { labels_->find(image()); }
  void store(const LabelView& labels) override { labels_->paint(image(), labels); }

  std::unique_ptr<ContactLabels> labels_;
};

std::unique_ptr<LabelsState> make_contacts(const LabelsSetting& setting) {
  return std::make_unique<ContactLabelsState>(setting);
}

std::vector<LabelsVariant> labels_variants() {
  LabelsVariants list;
  list.add("bitpacked_contacts", Isa::baseline, &make_contacts, {1});
  for (const Isa isa : isas_with(kContactFeatures)) {
    if (isa == Isa::baseline) continue;  // the same as `bitpacked_contacts`
    list.add("simd_contacts", isa, &make_contacts, {2});
  }
  return list.take();
}

std::vector<LabelsOperation> make_labels_operations() {
  const auto operation = [](LabelsTask task, std::string_view name, std::string_view description) {
    return LabelsOperation{task, name, description, labels_variants()};
  };
  return {
      operation(LabelsTask::image_eight, "label_image", "label image of 8-connected objects"),
      operation(LabelsTask::image_four, "label_image_4", "label image of 4-connected objects"),
      operation(LabelsTask::components_eight, "label_components",
                "label image of 8-connected objects, with areas and centres"),
      operation(LabelsTask::components_four, "label_components_4",
                "label image of 4-connected objects, with areas and centres"),
      operation(LabelsTask::regions, "label_regions",
                "label image of objects (8-connected) and their holes, with areas and centres")};
}

}  // namespace

void LabelsState::run(const ConstImageView& source, const LabelView& labels) {
  if (source.width == 0 || source.height == 0) return;
  load(source);
  compute();
  store(labels);
}

LabelsTask labels_task(Connectivity connectivity, bool with_list) {
  if (connectivity == Connectivity::eight) {
    return with_list ? LabelsTask::components_eight : LabelsTask::image_eight;
  }
  require_connectivity(static_cast<int>(connectivity));
  return with_list ? LabelsTask::components_four : LabelsTask::image_four;
}

std::span<const LabelsOperation> labels_operations() {
  static const auto& operations = kept(make_labels_operations());
  return operations;
}

const LabelsOperation& operation_of(LabelsTask task) {
  return operation_with(task, labels_operations(), "task");
}

}  // namespace thinbench::detail
