#include <utility>
#include <vector>

#include "harness/families.hpp"
#include "reference.hpp"
#include "techniques/variants.hpp"
#include "thinbench/distance.hpp"

namespace thinbench {
namespace {

/// Distances as numbers, row by row.
class DistanceJob : public Job {
 public:
  DistanceJob(Index width, Index height)
      : width_(width), numbers_(static_cast<std::size_t>(width * height)) {}

  [[nodiscard]] bool gives_image() const override { return false; }
  [[nodiscard]] std::vector<std::int64_t> numbers() const override {
    return {numbers_.begin(), numbers_.end()};
  }
  [[nodiscard]] std::string name_of_number(std::size_t index) const override {
    const auto pixel = static_cast<Index>(index);
    return "squared distance at (" + std::to_string(pixel % width_) + ", " +
           std::to_string(pixel / width_) + ")";
  }

 protected:
  [[nodiscard]] LabelView distances() {
    const Index height = width_ == 0 ? 0 : static_cast<Index>(numbers_.size()) / width_;
    return {numbers_.data(), width_, height};
  }

 private:
  Index width_;
  std::vector<std::int32_t> numbers_;
};

class StateJob final : public DistanceJob {
 public:
  StateJob(Index width, Index height, std::unique_ptr<detail::DistanceState> state)
      : DistanceJob(width, height), state_(std::move(state)) {}

  void run(const ConstImageView& input, const ImageView& /*output*/) override {
    state_->run(input, distances());
  }

 private:
  std::unique_ptr<detail::DistanceState> state_;
};

class ReferenceJob final : public DistanceJob {
 public:
  using DistanceJob::DistanceJob;

  void run(const ConstImageView& input, const ImageView& /*output*/) override {
    reference::squared_distances(input, distances());
  }
};

/// The limit of all variants, beside their own.
std::string unavailable_reason(const detail::Variant<detail::DistanceState>& variant, Index width) {
  if (width > kMaxDistanceSide) {
    return "wider than the limit for distances, " + std::to_string(kMaxDistanceSide) + " pixels";
  }
  return detail::unavailable_reason(variant, width);
}

}  // namespace

std::vector<Operation> distance_family() {
  const detail::DistanceOperation& operation = detail::study::distance_operation();
  Operation result = {
      std::string(operation.name), operation.description, InputKind::binary, {}, {}};
  for (const detail::Variant<detail::DistanceState>& variant : operation.variants) {
    result.variants.push_back(
        library_variant(variant, false, [&variant](Index width, Index height, int threads) {
          return std::make_unique<StateJob>(
              width, height, detail::make_state(variant, width, height, {}, threads));
        }));
    result.variants.back().unavailable_reason = [&variant](Index width) {
      return unavailable_reason(variant, width);
    };
  }
  result.reference = [](Index width, Index height, int) {
    return std::make_unique<ReferenceJob>(width, height);
  };
  result.operation = operation.name;
  return {result};
}

}  // namespace thinbench
