#include <array>
#include <memory>
#include <optional>

#include "harness/library_operation.hpp"
#include "localise.hpp"
#include "techniques/regions.hpp"

namespace thinbench {
namespace {

using detail::ConstBitPlaneView;
using detail::EulerState;
using detail::FillState;
using detail::ListState;

constexpr std::size_t kCounts = 2;
constexpr std::array kMembers = {"area", "sum of x", "sum of y", "left",
                                 "top",  "right",    "bottom",   "enclosing object"};

void append(std::vector<std::int64_t>& numbers, const Region& region) {
  numbers.insert(numbers.end(), {region.area, region.sum_x, region.sum_y, region.left, region.top,
                                 region.right, region.bottom, region.enclosing_object});
}

struct EulerNumber : OneNumber {
  [[nodiscard]] static std::string name_of_number(std::size_t) { return "Euler number"; }
};

/// What a kernel gives; it belongs to the state.
struct Filled : NoNumbers {
  ConstBitPlaneView bits{};
};

void run_state(ListState& state, const ConstImageView& input, const ImageView&,
               RegionLists& found) {
  state.run(input, found.lists);
}
void run_state(EulerState& state, const ConstImageView& input, const ImageView&,
               EulerNumber& found) {
  found.number = state.run(input);
}
void run_state(FillState& state, const ConstImageView& input, const ImageView& output, Filled&) {
  state.run(input, output);
}

void run_kernel(ListState& state, const ConstBitPlaneView& image, RegionLists& found) {
  state.find(image, found.lists);
}
void run_kernel(EulerState& state, const ConstBitPlaneView& image, EulerNumber& found) {
  found.number = state.count(image);
}
void run_kernel(FillState& state, const ConstBitPlaneView& image, Filled& found) {
  found.bits = state.fill(image);
}

/// The kernel works on packed bits.
template <class Result, class State>
class StateJob final : public ResultJob<Result> {
 public:
  explicit StateJob(std::unique_ptr<State> state) : state_(std::move(state)) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    run_state(*state_, input, output, this->result);
  }
  void load(const ConstImageView& input) override {
    if (!image_) image_.emplace(best_isa(), input.width, input.height);
    bits_ = image_->read(input);
  }
  void kernel() override { run_kernel(*state_, bits_, this->result); }
  void store(const ImageView& output) const override {
    if constexpr (Result::kGivesImage) {
      detail::plane_conversion<std::uint64_t>(best_isa()).write(this->result.bits, output);
    } else {
      Job::store(output);
    }
  }

 private:
  std::unique_ptr<State> state_;
  std::optional<detail::PackedImage> image_;
  ConstBitPlaneView bits_{};
};

template <class Result, class Key, class State>
Operation packed_operation(const detail::Operation<Key, State>& operation,
                           const typename State::Parameters& parameters, JobMaker reference) {
  Operation result = case_of(operation, InputKind::binary, std::move(reference));
  add_variants(result, operation.variants,
               [parameters](const auto& variant, Index width, Index height, int threads) {
                 return std::make_unique<StateJob<Result, State>>(
                     detail::make_state(variant, width, height, parameters, threads));
               });
  for (Variant& variant : result.variants) variant.has_kernel_scope = true;
  return result;
}

/// Adds a technique of the study to those of an operation: below the product's in priority.
/// `State` is made by the arguments and the size; `run(state, input, output, result)`.
template <class Result, class State, class Run, class... Arguments>
void add_technique(Operation& operation, std::string_view technique, Run run,
                   Arguments... arguments) {
  const auto make_job = [=](Index width, Index height, int) {
    return function_job<Result>(width, height,
                                [run, state = std::make_unique<State>(arguments..., width, height)](
                                    const auto& input, const auto& output, Result& found) {
                                  run(*state, input, output, found);
                                });
  };
  operation.variants.insert(operation.variants.begin(),
                            library_variant({technique, Isa::baseline}, make_job));
}

Operation list_operation(detail::ListOperation operation) {
  const bool with_holes = operation.key;
  operation.variants.insert(
      operation.variants.begin(),
      detail::Variant<ListState>{{"bitpacked_runs", Isa::baseline}, &detail::make_bitpacked_runs});
  Operation result = packed_operation<RegionLists>(
      operation, {with_holes},
      job_maker<RegionLists>([with_holes](const auto& input, const auto&, auto& found) {
        found.lists = lists_of(with_holes ? reference::holes(input) : reference::objects(input));
      }));
  add_technique<RegionLists, detail::UnionFind>(
      result, "union_find",
      [with_holes](detail::UnionFind& state, const auto& input, const auto&, auto& found) {
        state.find(input, with_holes, found.lists);
      });
  return result;
}

Operation euler_operation(const detail::EulerOperation& operation) {
  const Connectivity objects = operation.key;
  const auto reference =
      objects == Connectivity::eight ? reference::euler_number : reference::euler_number_4;
  Operation result = packed_operation<EulerNumber>(
      operation, {objects},
      job_maker<EulerNumber>([reference](const auto& input, const auto&, auto& found) {
        found.number = reference(input);
      }));
  add_technique<EulerNumber, detail::EulerQuads>(
      result, "lut",
      [](detail::EulerQuads& state, const auto& input, const auto&, auto& found) {
        found.number = state.run(input);
      },
      objects);
  return result;
}

Operation fill_operation(const detail::FillOperation& operation) {
  const bool eight = operation.key == Connectivity::eight;
  const auto reference = eight ? reference::fill_holes : reference::fill_holes_4;
  Operation result = packed_operation<Filled>(
      operation, {operation.key},
      job_maker<NoNumbers>(
          [reference](const auto& input, const auto& output, auto&) { reference(input, output); }));
  if (!eight) return result;
  add_technique<NoNumbers, detail::UnionFind>(
      result, "union_find",
      [](detail::UnionFind& state, const auto& input, const auto& output, auto&) {
        state.fill(input, output);
      });
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
  return {library_operation<RegionLists>(
      detail::localise_operation(), {EdgeOperator::sobel, {}}, InputKind::grey,
      [](detail::LocaliseState& state, const auto& input, const auto&, auto& found) {
        state.run(input, found.lists);
      },
      job_maker<RegionLists>([](const auto& input, const auto&, auto& found) {
        found.lists =
            lists_of(reference::localise_objects(reference::edges(EdgeOperator::sobel), {}, input));
      }))};
}

}  // namespace thinbench
