#include "regress/baseline.hpp"

#include <cmath>
#include <fstream>
#include <stdexcept>

#include "harness/case_json.hpp"
#include "paired/statistics.hpp"

namespace thinbench {
namespace {

using nlohmann::json;

constexpr int kSchema = 1;

/// To the nearest of so many parts of 1.
double rounded(double value, double parts) {
  return std::round(value * parts) / parts;
}

json to_json(const BaselineRow& row) {
  json object = labels_json<json>(row.labels);
  object.update({{"ratio", rounded(row.speedup.ratio, 1e3)},
                 {"low", rounded(row.speedup.low, 1e3)},
                 {"high", rounded(row.speedup.high, 1e3)},
                 {"reference_ns", rounded(row.times.reference_ns, 1)},
                 {"variant_ns", rounded(row.times.row_ns, 1)},
                 {"input_hash", row.input_hash}});
  return object;
}

BaselineRow row_from(const json& row) {
  return {{row.at("ratio"), row.at("low"), row.at("high")},
          {row.at("reference_ns"), row.at("variant_ns")},
          row.at("input_hash"),
          labels_from(row)};
}

Baseline baseline_from(const json& object) {
  if (!object.is_object()) throw std::runtime_error("it is no JSON object, or truncated");
  if (object.value("kind", "") != "baseline") throw std::runtime_error("it is no baseline");
  if (object.at("schema") != kSchema) {
    throw std::runtime_error("its schema " + object.at("schema").dump() + " is unknown");
  }
  Baseline baseline{object.at("machine"), {}, object.at("history")};
  for (const auto& [name, row] : object.at("rows").items()) {
    baseline.rows.emplace(name, row_from(row));
  }
  if (baseline.fingerprint().empty() || baseline.commit().empty()) {
    throw std::runtime_error("it does not say where it was measured");
  }
  return baseline;
}

std::map<std::string, BaselineRow> rows_of(const MeasuredRun& run) {
  std::map<std::string, BaselineRow> rows;
  for (const auto& [name, row] : run.rows) {
    const Estimate estimate = estimate_of(row.logs);
    rows[name] = {
        {estimate.ratio, estimate.low, estimate.high}, row.times, row.input_hash, row.labels};
  }
  return rows;
}

/// Of speed-ups that both have; null for none.
json mean_change(const std::map<std::string, BaselineRow>& before,
                 const std::map<std::string, BaselineRow>& now) {
  double logs = 0;
  int common = 0;
  for (const auto& [name, row] : now) {
    const auto earlier = before.find(name);
    if (earlier == before.end()) continue;
    logs += std::log(row.speedup.ratio / earlier->second.speedup.ratio);
    ++common;
  }
  return common == 0 ? json() : json(rounded(std::exp(logs / common), 1e4));
}

}  // namespace

Baseline read_baseline(const std::string& file) {
  std::ifstream stream(file);
  try {
    if (!stream) throw std::runtime_error("cannot read it");
    return baseline_from(json::parse(stream, nullptr, false));
  } catch (const std::exception& error) {
    throw std::runtime_error("baseline '" + file + "': " + error.what());
  }
}

std::string to_text(const Baseline& baseline) {
  json rows = json::object();
  for (const auto& [name, row] : baseline.rows) rows[name] = to_json(row);
  const json object = {{"schema", kSchema},
                       {"kind", "baseline"},
                       {"machine", baseline.machine},
                       {"rows", std::move(rows)},
                       {"history", baseline.history}};
  return object.dump(1) + "\n";
}

void update(Baseline& baseline, const MeasuredRun& run, const json& machine,
            const std::string& reason) {
  std::map<std::string, BaselineRow> rows = rows_of(run);
  baseline.history.push_back({{"date", machine.at("date")},
                              {"commit", machine.at("commit")},
                              {"reason", reason},
                              {"change", mean_change(baseline.rows, rows)}});
  baseline.machine = machine;
  baseline.rows = std::move(rows);
}

}  // namespace thinbench
