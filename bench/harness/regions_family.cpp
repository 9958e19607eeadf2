#include <array>
#include <memory>
#include <optional>
#include <type_traits>

#include "harness/families.hpp"
#include "holes.hpp"
#include "localise.hpp"
#include "techniques/regions.hpp"
#include "techniques/variants.hpp"

namespace thinbench {
namespace {

using detail::EulerState;
using detail::FillState;
using detail::ListState;
using detail::Variant;
using detail::VariantInfo;

constexpr std::size_t kCounts = 2;
constexpr std::array kMembers = {"area", "sum of x", "sum of y", "left",
                                 "top",  "right",    "bottom",   "enclosing object"};

void append(std::vector<std::int64_t>& numbers, const Region& region) {
  numbers.insert(numbers.end(), {region.area, region.sum_x, region.sum_y, region.left, region.top,
                                 region.right, region.bottom, region.enclosing_object});
}

std::vector<std::int64_t> numbers_of(std::int64_t number) {
  return {number};
}

/// Gives no image, but a result as numbers.
template <class Result>
class ResultJob : public Job {
 public:
  [[nodiscard]] bool gives_image() const override { return false; }
  [[nodiscard]] std::vector<std::int64_t> numbers() const override { return numbers_of(result_); }
  [[nodiscard]] std::string name_of_number(std::size_t index) const override {
    return std::is_same_v<Result, Regions> ? name_of_region_number(index) : "Euler number";
  }

 protected:
  Result result_{};
};

/// Calls a function that sets the result of an input.
template <class Result, class Find>
class FindingJob final : public ResultJob<Result> {
 public:
  explicit FindingJob(Find find) : find_(std::move(find)) {}

  void run(const ConstImageView& input, const ImageView& /*output*/) override {
    find_(input, this->result_);
  }

 private:
  Find find_;
};

template <class Result, class Find>
std::unique_ptr<Job> finding_job(Find find) {
  return std::make_unique<FindingJob<Result, Find>>(std::move(find));
}

/// Calls a function of input and output.
template <class Fill>
class FillingJob final : public Job {
 public:
  explicit FillingJob(Fill fill) : fill_(std::move(fill)) {}

  void run(const ConstImageView& input, const ImageView& output) override { fill_(input, output); }

 private:
  Fill fill_;
};

template <class Fill>
std::unique_ptr<Job> filling_job(Fill fill) {
  return std::make_unique<FillingJob<Fill>>(std::move(fill));
}

/// What a kernel alone works on.
class PackedInput {
 public:
  void load(const ConstImageView& input) {
    if (!image_) image_.emplace(best_isa(), input.width, input.height);
    view_ = image_->read(input);
  }
  [[nodiscard]] const detail::ConstBitPlaneView& view() const { return view_; }

 private:
  std::optional<detail::PackedImage> image_;
  detail::ConstBitPlaneView view_{};
};

void run_state(ListState& state, const ConstImageView& input, Regions& found) {
  state.run(input, found);
}
void run_state(EulerState& state, const ConstImageView& input, std::int64_t& number) {
  number = state.run(input);
}
void run_kernel(ListState& state, const detail::ConstBitPlaneView& image, Regions& found) {
  state.find(image, found);
}
void run_kernel(EulerState& state, const detail::ConstBitPlaneView& image, std::int64_t& number) {
  number = state.count(image);
}

template <class Result, class State>
class StateJob final : public ResultJob<Result> {
 public:
  explicit StateJob(std::unique_ptr<State> state) : state_(std::move(state)) {}

  void run(const ConstImageView& input, const ImageView& /*output*/) override {
    run_state(*state_, input, this->result_);
  }
  void load(const ConstImageView& input) override { packed_.load(input); }
  void kernel() override { run_kernel(*state_, packed_.view(), this->result_); }

 private:
  std::unique_ptr<State> state_;
  PackedInput packed_;
};

class FillStateJob final : public Job {
 public:
  explicit FillStateJob(std::unique_ptr<FillState> state) : state_(std::move(state)) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    state_->run(input, output);
  }
  void load(const ConstImageView& input) override { packed_.load(input); }
  void kernel() override { filled_ = state_->fill(packed_.view()); }
  void store(const ImageView& output) const override {
    detail::plane_conversion<std::uint64_t>(best_isa()).write(filled_, output);
  }

 private:
  std::unique_ptr<FillState> state_;
  PackedInput packed_;
  detail::ConstBitPlaneView filled_{};
};

/// The product's variants of an operation, as jobs of their states.
template <class StateJob, class TableOperation, class Parameters>
Operation operation_of_table(const TableOperation& operation, const Parameters& parameters) {
  Operation result = {
      std::string(operation.name), operation.description, InputKind::binary, {}, {}};
  for (const auto& variant : operation.variants) {
    result.variants.push_back(library_variant(
        variant, true, [&variant, parameters](Index width, Index height, int threads) {
          return std::make_unique<StateJob>(
              detail::make_state(variant, width, height, parameters, threads));
        }));
  }
  result.operation = operation.name;
  return result;
}

/// Adds a technique of the study to those of an operation: below the product's in priority.
void add_technique(Operation& operation, std::string_view technique, bool has_kernel_scope,
                   JobMaker make_job) {
  operation.variants.insert(
      operation.variants.begin(),
      library_variant({technique, Isa::baseline}, has_kernel_scope, std::move(make_job)));
}

Operation list_operation(const detail::ListOperation& table) {
  using ListJob = StateJob<Regions, ListState>;
  const bool with_holes = table.key;
  Operation result = operation_of_table<ListJob>(table, detail::ListParameters{with_holes});
  static const Variant<ListState> bitpacked_runs = {{"bitpacked_runs", Isa::baseline},
                                                    &detail::make_bitpacked_runs};
  add_technique(result, "bitpacked_runs", true, [with_holes](Index width, Index height, int) {
    return std::make_unique<ListJob>(
        detail::make_state(bitpacked_runs, width, height, {with_holes}, 1));
  });
  add_technique(result, "union_find", false, [with_holes](Index width, Index height, int) {
    const auto state = std::make_shared<detail::UnionFind>(width, height);
    return finding_job<Regions>([state, with_holes](const ConstImageView& input, Regions& found) {
      state->find(input, with_holes, found);
    });
  });
  result.reference = [with_holes](Index, Index, int) {
    return finding_job<Regions>([with_holes](const ConstImageView& input, Regions& found) {
      auto [objects, holes] = with_holes ? reference::holes(input) : reference::components(input);
      found = {std::move(objects), std::move(holes)};
    });
  };
  return result;
}

Operation euler_operation(const detail::EulerOperation& table) {
  const Connectivity objects = table.key;
  Operation result = operation_of_table<StateJob<std::int64_t, EulerState>>(
      table, detail::EulerParameters{objects});
  add_technique(result, "lut", false, [objects](Index width, Index height, int) {
    const auto state = std::make_shared<detail::EulerQuads>(objects, width, height);
    return finding_job<std::int64_t>(
        [state](const ConstImageView& input, std::int64_t& number) { number = state->run(input); });
  });
  const auto reference =
      objects == Connectivity::eight ? reference::euler_number : reference::euler_number_4;
  result.reference = [reference](Index, Index, int) {
    return finding_job<std::int64_t>(
        [reference](const ConstImageView& input, std::int64_t& number) {
          number = reference(input);
        });
  };
  return result;
}

Operation fill_operation(const detail::FillOperation& table) {
  Operation result = operation_of_table<FillStateJob>(table, HoleFilling{table.key});
  const bool eight = table.key == Connectivity::eight;
  if (eight) {
    add_technique(result, "union_find", false, [](Index width, Index height, int) {
      const auto state = std::make_shared<detail::UnionFind>(width, height);
      return filling_job([state](const ConstImageView& input, const ImageView& output) {
        state->fill(input, output);
      });
    });
  }
  result.reference = [fill = eight ? reference::fill_holes : reference::fill_holes_4](
                         Index, Index, int) { return filling_job(fill); };
  return result;
}

}  // namespace

std::vector<std::int64_t> numbers_of(const Regions& lists) {
  std::vector<std::int64_t> numbers = {static_cast<std::int64_t>(lists.objects.size()),
                                       static_cast<std::int64_t>(lists.holes.size())};
  for (const Region& object : lists.objects) append(numbers, object);
  for (const Region& hole : lists.holes) append(numbers, hole);
  return numbers;
}

std::string name_of_region_number(std::size_t index) {
  if (index < kCounts) return index == 0 ? "objects" : "holes";
  const std::size_t region = (index - kCounts) / kMembers.size();
  return std::string(kMembers.at((index - kCounts) % kMembers.size())) + " of region " +
         std::to_string(region + 1) + " of both lists";
}

std::vector<Operation> regions_family() {
  std::vector<Operation> family;
  for (const auto& operation : detail::list_operations()) {
    family.push_back(list_operation(operation));
  }
  for (const auto& operation : detail::fill_operations()) {
    family.push_back(fill_operation(operation));
  }
  for (const auto& operation : detail::euler_operations()) {
    family.push_back(euler_operation(operation));
  }
  return family;
}

std::vector<Operation> localise_family() {
  const detail::LocaliseOperation& chain = detail::localise_operation();
  Operation result = {std::string(chain.name), chain.description, InputKind::grey, {}, {}};
  for (const detail::LocaliseVariant& variant : chain.variants) {
    result.variants.push_back(
        library_variant(variant, false, [&variant](Index width, Index height, int threads) {
          const std::shared_ptr<detail::LocaliseState> state =
              detail::make_state(variant, width, height, {EdgeOperator::sobel, {}}, threads);
          return finding_job<Regions>(
              [state](const ConstImageView& input, Regions& found) { state->run(input, found); });
        }));
  }
  result.reference = [](Index, Index, int) {
    return finding_job<Regions>([](const ConstImageView& input, Regions& found) {
      auto [objects, holes] =
          reference::localise_objects(reference::edges(EdgeOperator::sobel), {}, input);
      found = {std::move(objects), std::move(holes)};
    });
  };
  result.operation = chain.name;
  return {result};
}

}  // namespace thinbench
