#include "experiments/table_2.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "support/text.hpp"
#include "thinbench/options.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {
namespace {

constexpr const char* kBaseOperation = "thin_naccache_shinghal";
constexpr double kBaseSeconds = 0.73;

using Ratio = std::optional<double>;

Ratio ratio_of(const std::optional<double>& time, const std::optional<double>& base) {
  return time && base ? Ratio(*time / *base) : std::nullopt;
}

MeasuredTimes find(const TimesByOperation& times, const char* operation) {
  const auto found = times.find(operation);
  return found == times.end() ? MeasuredTimes{} : found->second;
}

std::string microseconds(const std::optional<double>& ns) {
  return ns ? fixed(*ns / 1000, 1) : "";
}

std::string ratio_text(const Ratio& ratio) {
  return ratio ? fixed(*ratio, 2) : "";
}

nlohmann::ordered_json row_json(const ThenAndNow& row) {
  const bool iterates = rule_from_name(row.paper.operation).has_value();
  nlohmann::ordered_json json = {{"method", row.paper.method},
                                 {"operation", row.paper.operation},
                                 {"border", iterates ? border_name(Border::background) : ""},
                                 {"max_iterations", nullptr},
                                 {"paper_seconds", row.paper.seconds},
                                 {"paper_ratio", row.then_ratio}};
  if (row.now.reference_ns) json["reference_ns"] = *row.now.reference_ns;
  if (row.reference_ratio) json["reference_ratio"] = *row.reference_ratio;
  if (row.now.best_ns) json["best_variant"] = row.now.best_variant;
  if (row.now.best_ns) json["best_ns"] = *row.now.best_ns;
  if (row.best_ratio) json["best_ratio"] = *row.best_ratio;
  return json;
}

std::vector<std::string> row_cells(const ThenAndNow& row) {
  return {row.paper.method,
          fixed(row.paper.seconds, 2),
          fixed(row.then_ratio, 2),
          microseconds(row.now.reference_ns),
          ratio_text(row.reference_ratio),
          row.now.best_variant,
          microseconds(row.now.best_ns),
          ratio_text(row.best_ratio)};
}

bool is_measured(const ThenAndNow& row) {
  return row.now.reference_ns || row.now.best_ns;
}

}  // namespace

const std::vector<PaperTime>& paper_times() {
  static const std::vector<PaperTime> times = {
      {"Hole detection and localisation", "holes", 0.67},
      {"Original skeleton", "skeleton_scan", 0.31},
      {"Naccache-Shinghal", kBaseOperation, kBaseSeconds},
      {"Two-layer net, sigmoid", "net_two_layer_sigmoid", 5.11},
      {"Two-layer net, linear threshold", "net_two_layer_linear", 3.54},
      {"Cluster of single-layer nets", "net_single_layer_cluster", 0.89}};
  return times;
}

std::vector<ThenAndNow> then_and_now(const TimesByOperation& times) {
  const MeasuredTimes base = find(times, kBaseOperation);
  std::vector<ThenAndNow> rows;
  for (const PaperTime& paper : paper_times()) {
    const MeasuredTimes now = find(times, paper.operation);
    rows.push_back({paper, paper.seconds / kBaseSeconds, now,
                    ratio_of(now.reference_ns, base.reference_ns),
                    ratio_of(now.best_ns, base.best_ns)});
  }
  return rows;
}

ExperimentReport table_2_report(const std::vector<ThenAndNow>& rows, const std::string& options) {
  nlohmann::ordered_json json = {{"image", "510 x 412"},
                                 {"machine", "Pentium II MMX, 350 MHz"},
                                 {"rows", nlohmann::ordered_json::array()}};
  std::vector<std::string> head = {
      "Method", "Paper, s",         "Paper, ratio", "Reference now, µs",
      "Ratio",  "Best variant now", "Best, µs",     "Ratio"};
  constexpr std::size_t kPaperColumns = 3;
  if (std::none_of(rows.begin(), rows.end(), is_measured)) head.resize(kPaperColumns);
  std::vector<std::vector<std::string>> cells;
  for (const ThenAndNow& row : rows) {
    json["rows"].push_back(row_json(row));
    cells.push_back(row_cells(row));
    cells.back().resize(head.size());
  }
  return {experiment_json("table-2", json, options),
          "Table 2 of the paper (510 x 412, Pentium II at 350 MHz); ratios are to "
          "Naccache-Shinghal:\n\n" +
              markdown_table(head, cells)};
}

}  // namespace thinbench
