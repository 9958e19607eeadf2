#include "experiments/batches.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "api/catalogue.hpp"
#include "harness/operation.hpp"
#include "support/text.hpp"
#include "thinbench/batch.hpp"

namespace thinbench {
namespace {

constexpr std::array<Index, 2> kSides = {28, 64};
constexpr std::array kRulesOfBatches = {Rule::guo_hall, Rule::zhang_suen, Rule::naccache_shinghal};
constexpr std::uint64_t kSeed = 1999;

template <class Work>
double seconds(const Work& work) {
  using Clock = std::chrono::steady_clock;
  const auto before = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - before).count();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// One variant, image after image.
struct Single {
  std::string name;
  std::unique_ptr<detail::ThinningState> state;

  void run(const ConstStackView& source, const StackView& destination) {
    for (Index i = 0; i < source.count; ++i) state->run(source.image(i), destination.image(i));
  }
};

/// The fastest variant on one thread, by the least of a few runs over some of the images.
Single fastest_single(const detail::ThinningOperation& operation, ConstStackView source,
                      const StackView& destination) {
  source.count = std::min<Index>(source.count, 500);
  std::optional<Single> fastest;
  double least = 0;
  for (const detail::ThinningVariant& variant : operation.variants) {
    if (variant.threaded || !unavailable_reason(variant, source.width).empty()) continue;
    Single single = {std::string(technique_name(variant.technique)) + " (" +
                         std::string(isa_name(variant.isa)) + ")",
                     make_state(operation, variant, source.width, source.height, {})};
    const auto run = [&] { single.run(source, destination); };
    run();
    const double took = std::min({seconds(run), seconds(run), seconds(run)});
    if (fastest && took >= least) continue;
    least = took;
    fastest.emplace(std::move(single));
  }
  return std::move(*fastest);
}

void require_reference(std::string_view operation, const ConstStackView& source,
                       const ConstStackView& made) {
  for (Index i = 0; i < source.count; ++i) {
    if (equal(made.image(i), expected_of(operation, source.image(i)).image.view())) continue;
    throw std::runtime_error(std::string(operation) + ": image " + std::to_string(i) + " of " +
                             std::to_string(source.width) + " x " + std::to_string(source.height) +
                             " differs from its reference");
  }
}

/// Times of one round.
struct Round {
  double single, batch;
};

/// Both ways interleaved, so that what else uses the core disturbs both.
Round time_round(Single& single, ThinningBatch& batch, const ConstStackView& source,
                 const StackView& destination, int turns) {
  std::vector<double> singles;
  std::vector<double> batches;
  for (int turn = 0; turn < turns; ++turn) {
    singles.push_back(seconds([&] { single.run(source, destination); }));
    batches.push_back(seconds([&] { batch(source, destination); }));
  }
  return {median(singles), median(batches)};
}

BatchRow row_of(const detail::ThinningOperation& operation, const ConstStackView& source,
                const BatchesChoice& choice) {
  ImageStack made(source.count, source.width);
  Single single = fastest_single(operation, source, made.view());
  ThinningBatch batch(operation.rule, source.width, source.height);
  single.run(source, made.view());
  require_reference(operation.name, source, made.view());
  const int iterations = batch(source, made.view());
  require_reference(operation.name, source, made.view());
  std::vector<double> singles;
  std::vector<double> batches;
  std::vector<double> ratios;
  for (int round = 0; round < choice.rounds; ++round) {
    const Round times = time_round(single, batch, source, made.view(), choice.turns);
    singles.push_back(times.single);
    batches.push_back(times.batch);
    ratios.push_back(times.single / times.batch);
  }
  std::sort(ratios.begin(), ratios.end());
  const auto images = static_cast<double>(source.count);
  return {std::string(operation.name),
          source.width,
          foreground_share(source),
          iterations,
          single.name,
          std::string(isa_name(best_isa())),
          images / median(singles),
          images / median(batches),
          median(ratios),
          ratios[1],
          ratios[ratios.size() - 2]};
}

nlohmann::ordered_json json_of(const BatchRow& row) {
  return {{"operation", row.operation},
          {"side", row.side},
          {"border", border_name(Border::background)},
          {"max_iterations", nullptr},
          {"foreground", row.foreground},
          {"iterations", row.iterations},
          {"single", row.single},
          {"isa", row.isa},
          {"single_per_second", row.single_per_second},
          {"batch_per_second", row.batch_per_second},
          {"ratio", row.ratio},
          {"ratio_low", row.ratio_low},
          {"ratio_high", row.ratio_high}};
}

}  // namespace

std::vector<BatchRow> run_batches(const BatchesChoice& choice) {
  std::vector<BatchRow> rows;
  for (const Index side : kSides) {
    const ImageStack source = stroke_images(choice.images, side, kSeed);
    for (const Rule rule : kRulesOfBatches) {
      rows.push_back(row_of(detail::operation_of(rule), source.view(), choice));
    }
  }
  return rows;
}

ExperimentReport batches_report(const std::vector<BatchRow>& rows, const BatchesChoice& choice,
                                const std::string& options) {
  nlohmann::ordered_json json = {{"images", choice.images},
                                 {"rounds", choice.rounds},
                                 {"rows", nlohmann::ordered_json::array()}};
  std::vector<std::vector<std::string>> cells;
  for (const BatchRow& row : rows) {
    json["rows"].push_back(json_of(row));
    cells.push_back({row.operation, std::to_string(row.side), row.single, row.isa,
                     fixed(row.single_per_second / 1e6, 3), fixed(row.batch_per_second / 1e6, 3),
                     fixed(row.ratio, 2),
                     fixed(row.ratio_low, 2) + " to " + fixed(row.ratio_high, 2)});
  }
  return {experiment_json("batches", json, options),
          "Millions of images per second on one thread, one by one by the fastest variant and as a "
          "batch, " +
              std::to_string(choice.images) + " images of strokes, and the ratio (of " +
              std::to_string(choice.rounds) +
              " rounds the median, and all but the lowest and the highest):\n\n" +
              markdown_table({"Operation", "Side", "One by one", "Batch", "One by one, M/s",
                              "Batch, M/s", "Ratio", "Interval"},
                             cells)};
}

}  // namespace thinbench
