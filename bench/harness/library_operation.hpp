// How families make operations: jobs of states and of references, and what jobs give.
#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "harness/families.hpp"
#include "holes.hpp"

namespace thinbench {

// Results of jobs beside the image. Those that depend on the size of images are made with it.

struct NoNumbers {
  static constexpr bool kGivesImage = true;
  [[nodiscard]] static std::vector<std::int64_t> numbers() { return {}; }
};

struct OneNumber {
  static constexpr bool kGivesImage = false;
  std::int64_t number = 0;
  [[nodiscard]] std::vector<std::int64_t> numbers() const { return {number}; }
};

struct Iterations : OneNumber {
  static constexpr bool kGivesImage = true;
  [[nodiscard]] static std::string name_of_number(std::size_t) { return "iterations"; }
};

struct RegionLists {
  static constexpr bool kGivesImage = false;
  Regions lists;
  [[nodiscard]] std::vector<std::int64_t> numbers() const { return numbers_of(lists); }
  [[nodiscard]] static std::string name_of_number(std::size_t index) {
    return name_of_region_number(index);
  }
};

[[nodiscard]] inline Regions lists_of(reference::Regions found) {
  return {std::move(found.objects), std::move(found.holes)};
}

/// A number for each pixel, row by row.
class PixelNumbers {
 public:
  static constexpr bool kGivesImage = false;
  PixelNumbers(const char* name, Index width, Index height)
      : name_(name),
        width_(width),
        height_(height),
        values_(static_cast<std::size_t>(width * height)) {}

  [[nodiscard]] LabelView view() { return {values_.data(), width_, height_}; }
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] std::vector<std::int64_t> numbers() const {
    return {values_.begin(), values_.end()};
  }
  /// "label at (3, 4)".
  [[nodiscard]] std::string name_of_number(std::size_t index) const {
    const auto pixel = static_cast<Index>(index);
    return std::string(name_) + " at (" + std::to_string(pixel % width_) + ", " +
           std::to_string(pixel / width_) + ")";
  }

 private:
  const char* name_;
  Index width_;
  Index height_;
  std::vector<std::int32_t> values_;
};

/// A job that gives a result.
template <class Result>
class ResultJob : public Job {
 public:
  explicit ResultJob(Result given = {}) : result(std::move(given)) {}

  [[nodiscard]] std::vector<std::int64_t> numbers() const final { return result.numbers(); }
  [[nodiscard]] std::string name_of_number(std::size_t index) const final {
    if constexpr (requires(Result given) { given.name_of_number(index); }) {
      return result.name_of_number(index);
    } else {
      return Job::name_of_number(index);
    }
  }
  [[nodiscard]] bool gives_image() const final { return Result::kGivesImage; }

 protected:
  Result result;
};

/// Calls `function(input, output, result)`.
template <class Result, class Function>
class FunctionJob final : public ResultJob<Result> {
 public:
  FunctionJob(Function function, Result given)
      : ResultJob<Result>(std::move(given)), function_(std::move(function)) {}

  void run(const ConstImageView& input, const ImageView& output) override {
    function_(input, output, this->result);
  }

 private:
  Function function_;
};

template <class Result, class Function>
[[nodiscard]] std::unique_ptr<Job> function_job(Index width, Index height, Function function) {
  if constexpr (std::is_constructible_v<Result, Index, Index>) {
    return std::make_unique<FunctionJob<Result, Function>>(std::move(function),
                                                           Result(width, height));
  } else {
    return std::make_unique<FunctionJob<Result, Function>>(std::move(function), Result{});
  }
}

/// Of a function of input and output that returns the number of iterations.
template <class Function>
[[nodiscard]] std::unique_ptr<Job> counting_job(Function function) {
  return function_job<Iterations>(
      0, 0,
      [function = std::move(function)](const auto& input, const auto& output, Iterations& found) {
        found.number = function(input, output);
      });
}

/// Each job has a copy of the function.
template <class Result, class Function>
[[nodiscard]] JobMaker job_maker(Function function) {
  return [function = std::move(function)](Index width, Index height, int) {
    return function_job<Result>(width, height, function);
  };
}

template <class Function>
[[nodiscard]] JobMaker counting_job_maker(Function function) {
  return [function = std::move(function)](Index, Index, int) { return counting_job(function); };
}

/// Appends variants with jobs by `make_job(variant, width, height, threads)`.
template <class State, class MakeJob>
void add_variants(Operation& operation, const std::vector<detail::Variant<State>>& variants,
                  const MakeJob& make_job) {
  for (const detail::Variant<State>& variant : variants) {
    operation.variants.push_back(
        library_variant(variant, [variant, make_job](Index width, Index height, int threads) {
          return make_job(variant, width, height, threads);
        }));
  }
}

/// A case without variants; `operation` must outlive it.
template <class Key, class State>
[[nodiscard]] Operation case_of(const detail::Operation<Key, State>& operation, InputKind takes,
                                JobMaker reference) {
  Operation result = {
      std::string(operation.name), operation.description, takes, {}, std::move(reference)};
  result.operation = operation.name;
  return result;
}

/// With jobs that call `run(state, input, output, result)`.
template <class Result, class Key, class State, class Run>
[[nodiscard]] Operation library_operation(const detail::Operation<Key, State>& operation,
                                          const typename State::Parameters& parameters,
                                          InputKind takes, Run run, JobMaker reference) {
  Operation result = case_of(operation, takes, std::move(reference));
  add_variants(result, operation.variants,
               [parameters, run](const auto& variant, Index width, Index height, int threads) {
                 return function_job<Result>(
                     width, height,
                     [run, state = detail::make_state(variant, width, height, parameters, threads)](
                         const ConstImageView& input, const ImageView& output, Result& found) {
                       run(*state, input, output, found);
                     });
               });
  return result;
}

}  // namespace thinbench
