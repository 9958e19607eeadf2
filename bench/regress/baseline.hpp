// Speed-ups that were measured before on this kind of machine, by name, with their history.
#pragma once

#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "regress/run.hpp"
#include "regress/verdict.hpp"

namespace thinbench {

struct BaselineRow {
  Change speedup;  // over the reference
  PairTimes times;
  std::string input_hash;
  CaseLabels labels = {};
};

struct Baseline {
  nlohmann::json machine;  // see machine_json; with fingerprint, compiler and commit
  std::map<std::string, BaselineRow> rows;
  nlohmann::json history = nlohmann::json::array();  // date, commit, reason, change; latest last

  [[nodiscard]] std::string fingerprint() const { return machine.at("fingerprint"); }
  [[nodiscard]] std::string commit() const { return machine.at("commit"); }
};

/// Throw std::runtime_error, with the name of the file, where it cannot be read, is truncated, or
/// has a schema that is not known.
[[nodiscard]] Baseline read_baseline(const std::string& file);

[[nodiscard]] std::string to_text(const Baseline& baseline);

/// Replaces all rows and adds to the history: by how much the rows that were there before changed,
/// as a geometric mean (null where there were none).
void update(Baseline& baseline, const MeasuredRun& run, const nlohmann::json& machine,
            const std::string& reason);

}  // namespace thinbench
