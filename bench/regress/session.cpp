#include "regress/session.hpp"

#include <filesystem>
#include <iostream>
#include <optional>
#include <set>
#include <string_view>

#include "cli/command.hpp"
#include "regress/compare.hpp"
#include "regress/options.hpp"
#include "regress/table.hpp"
#include "support/text.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Rows = std::vector<RegressionVerdict>;

/// What one measurement says.
struct Findings {
  ControlVerdicts controls;
  Rows changes;
  Rows simd;
};

/// Of the cache that a core has for itself: what else runs does not empty it.
std::int64_t own_cache_kib(const json& machine) {
  for (const json& cache : machine.at("caches")) {
    if (cache.at("level") == 2) return cache.at("size_kib");
  }
  return 0;
}

constexpr std::string_view kCountsEnding = "-instructions.json";

/// With the file's name after the machine's fingerprint.
fs::path file_of(const std::string& folder, const json& machine, std::string_view ending) {
  return fs::path(folder) / machine.at("fingerprint").get<std::string>().append(ending);
}

fs::path baseline_file(const std::string& folder, const json& machine) {
  return file_of(folder, machine, ".json");
}

int number_of_baselines(const std::string& folder) {
  int number = 0;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".json") && !name.ends_with(kCountsEnding)) ++number;
  }
  return number;
}

void say_that_none_fits(const std::string& folder, const json& machine) {
  std::cout << "INFO: there is no baseline for this processor, compiler and flags ("
            << machine.at("fingerprint").get<std::string>() << "), but "
            << number_of_baselines(folder)
            << " for others; make one with: ./study regress --update --reason \"...\"\n";
}

/// The baseline of this machine and build; where there is none, that is said.
std::optional<Baseline> usable_baseline(const std::string& folder, const json& machine) {
  const fs::path file = baseline_file(folder, machine);
  if (fs::exists(file)) {
    Baseline baseline = read_baseline(file);
    if (baseline.fingerprint() == machine.at("fingerprint")) return baseline;
  }
  say_that_none_fits(folder, machine);
  return std::nullopt;
}

class Gate {
 public:
  Gate(const RegressOptions& options, const json& machine)
      : rules_{options.judge_threads, own_cache_kib(machine)} {
    if (options.old.empty()) baseline_ = usable_baseline(options.baselines, machine);
  }

  [[nodiscard]] Findings find(const std::vector<std::string>& run_files,
                              const std::vector<std::string>& old_files) const {
    const MeasuredRun run = read_run(run_files);
    const bool in_turns = !old_files.empty();
    Findings found{
        judge_controls(run, in_turns ? Neighbour::next_process : Neighbour::same_process),
        {},
        against_scalar(run)};
    if (in_turns) found.changes = between(read_run(old_files), run, rules_);
    if (baseline_) found.changes = against_baseline(run, *baseline_, rules_);
    doubt(found.controls, found.changes);
    doubt(found.controls, found.simd);
    return found;
  }

 private:
  Rules rules_;
  std::optional<Baseline> baseline_;
};

std::vector<Verdict> verdicts_of(const Rows& rows) {
  std::vector<Verdict> verdicts;
  for (const RegressionVerdict& row : rows) verdicts.push_back(row.verdict);
  return verdicts;
}

/// Slow SIMD rows make it worse, never green: they need nothing to compare with.
Verdict overall_of(const Findings& found) {
  const Verdict changes = overall(verdicts_of(found.changes));
  const Verdict simd = overall(verdicts_of(found.simd));
  if (simd == Verdict::fail) return simd;
  return changes == Verdict::pass && simd == Verdict::undecided ? simd : changes;
}

/// Whole cases, since the rows of one are measured side by side. Their names are filters for these
/// very cases, see is_requested().
std::string cases_in_doubt(const Findings& found) {
  std::set<std::string> cases;
  for (const Rows& rows : {found.changes, found.simd}) {
    for (const RegressionVerdict& row : rows) {
      const bool settled = row.verdict == Verdict::pass || row.verdict == Verdict::skipped;
      if (!settled) cases.insert(row.name.substr(0, row.name.find('/')));
    }
  }
  return joined({cases.begin(), cases.end()}, "|");
}

void print(const Findings& found, bool all) {
  std::cout << to_table(found.changes, all) << "rows against before: " << counts(found.changes)
            << "\n\n"
            << to_simd_table(found.simd, all) << "SIMD against scalar code: " << counts(found.simd)
            << "\n\n";
}

int compare(const RegressOptions& options, const json& machine) {
  const Gate gate(options, machine);
  Findings found = gate.find(options.run, options.old);
  if (!options.rerun_out.empty()) {
    write_whole_file(options.rerun_out, cases_in_doubt(found) + "\n");
  }
  const std::string controls = "controls " + to_line(found.controls) + "\n";
  std::string controls_again;
  if (!options.again.empty()) {
    const Findings again = gate.find(options.again, options.old_again);
    confirm(again.changes, found.changes);
    confirm(again.simd, found.simd);
    controls_again = "controls of what was measured again " + to_line(again.controls) + "\n";
  }
  print(found, options.all);
  const Verdict verdict = overall_of(found);
  std::cout << controls << controls_again << name_of(verdict)
            << (verdict == Verdict::skipped ? ": nothing was compared" : "") << '\n';
  return exit_status(verdict);
}

int update(const RegressOptions& options, json machine) {
  const MeasuredRun run = read_run(options.run);
  const ControlVerdicts controls = judge_controls(run, Neighbour::same_process);
  std::cout << "controls " << to_line(controls) << '\n';
  if (!controls.pass) {
    std::cout << "INCONCLUSIVE: no baseline is made of a run whose controls failed\n";
    return exit_status(Verdict::undecided);
  }
  machine["commit"] = options.commit;
  const fs::path file = baseline_file(options.baselines, machine);
  Baseline baseline;
  if (fs::exists(file)) baseline = read_baseline(file);
  update(baseline, run, machine, options.reason);
  write_whole_file(file, to_text(baseline));
  std::cout << "baseline of " << baseline.rows.size() << " rows, entry " << baseline.history.size()
            << " of its history: " << file.filename().string() << '\n';
  return kSuccess;
}

int print_counts_file(const RegressOptions& options, const json& machine) {
  std::cout << file_of(options.baselines, machine, kCountsEnding).string() << '\n';
  return kSuccess;
}

}  // namespace

int run_regress(const std::vector<std::string>& arguments, const json& machine) {
  try {
    RegressOptions options;
    if (!parse_options(arguments, options)) return kSuccess;
    if (options.counts_file) return print_counts_file(options, machine);
    return options.update ? update(options, machine) : compare(options, machine);
  } catch (const std::exception& error) {
    std::cerr << "thinbench_regress: " << error.what() << '\n';
    return kUsage;
  }
}

}  // namespace thinbench
