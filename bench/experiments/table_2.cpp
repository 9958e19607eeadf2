#include "experiments/table_2.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "training/text.hpp"

namespace thinbench {
namespace {

constexpr const char* kBaseOperation = "thin_naccache_shinghal";
constexpr double kBaseSeconds = 0.73;

std::optional<double> find(const std::map<std::string, double>& times, const char* operation) {
  const auto found = times.find(operation);
  return found == times.end() ? std::nullopt : std::optional<double>(found->second);
}

std::string cell(const std::optional<double>& value) {
  return value ? fixed(*value, 2) : "";
}

nlohmann::ordered_json row_json(const ThenAndNow& row) {
  nlohmann::ordered_json json = {{"method", row.paper.method},
                                 {"operation", row.paper.operation},
                                 {"paper_seconds", row.paper.seconds},
                                 {"paper_ratio", row.then_ratio}};
  if (row.now_ns) json["now_ns"] = *row.now_ns;
  if (row.now_ratio) json["now_ratio"] = *row.now_ratio;
  return json;
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

std::vector<ThenAndNow> then_and_now(const std::map<std::string, double>& median_ns) {
  const std::optional<double> base = find(median_ns, kBaseOperation);
  std::vector<ThenAndNow> rows;
  for (const PaperTime& paper : paper_times()) {
    ThenAndNow row = {paper, paper.seconds / kBaseSeconds, find(median_ns, paper.operation), {}};
    if (row.now_ns && base) row.now_ratio = *row.now_ns / *base;
    rows.push_back(row);
  }
  return rows;
}

ExperimentReport table_2_report(const std::vector<ThenAndNow>& rows) {
  nlohmann::ordered_json json = {{"image", "510 x 412"},
                                 {"machine", "Pentium II MMX, 350 MHz"},
                                 {"rows", nlohmann::ordered_json::array()}};
  std::vector<std::vector<std::string>> cells;
  for (const ThenAndNow& row : rows) {
    json["rows"].push_back(row_json(row));
    cells.push_back({row.paper.method, fixed(row.paper.seconds, 2), fixed(row.then_ratio, 2),
                     row.now_ns ? fixed(*row.now_ns / 1000, 1) : "", cell(row.now_ratio)});
  }
  std::vector<std::string> head = {"Method", "Paper, s", "Paper, ratio", "Now, µs", "Now, ratio"};
  if (std::none_of(rows.begin(), rows.end(), [](const auto& row) { return row.now_ns; })) {
    constexpr std::size_t kPaperColumns = 3;
    head.resize(kPaperColumns);
    for (auto& row : cells) row.resize(kPaperColumns);
  }
  return {experiment_json("table-2", json),
          "Table 2 of the paper (510 x 412, Pentium II at 350 MHz); ratios are to "
          "Naccache-Shinghal:\n\n" +
              markdown_table(head, cells)};
}

}  // namespace thinbench
