#include "regress/run.hpp"

#include <algorithm>
#include <fstream>
#include <numeric>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "harness/case_json.hpp"
#include "paired/row_names.hpp"
#include "paired/statistics.hpp"

namespace thinbench {
namespace {

using nlohmann::json;
using Logs = std::vector<double>;

constexpr int kSchema = 1;

struct Clock {
  double log;  // trimmed mean of ln(time / anchor's time)
  double ns;
};

/// Without an eighth at each end. Where short calls come in two speeds, by what else the core does,
/// a median jumps from one to the other between processes.
double trimmed_mean(Logs logs) {
  if (logs.empty()) throw std::runtime_error("a row has no samples");
  std::sort(logs.begin(), logs.end());
  const auto cut = static_cast<std::ptrdiff_t>(logs.size() / 8);
  const double sum = std::accumulate(logs.begin() + cut, logs.end() - cut, 0.0);
  return sum / static_cast<double>(static_cast<std::ptrdiff_t>(logs.size()) - 2 * cut);
}

Clock clock_of(const json& sample, const char* name) {
  const json& clock = sample.at(name);
  return {trimmed_mean(clock.at("logs").get<Logs>()), clock.at("ns").get<double>()};
}

bool is_reference(const std::string& row) {
  return fields_of(row)[1] == "reference";
}

/// Samples of one process, and what all processes together gave.
class Reader {
 public:
  void add_process(const std::vector<json>& samples) {
    for (const json& sample : samples) {
      const auto name = sample.at("row").get<std::string>();
      if (is_reference(name)) references_[group_of(name)] = &sample;
    }
    for (const json& sample : samples) add(sample);
    references_.clear();
    ++run_.processes;
  }

  MeasuredRun take() {
    for (auto& [name, row] : run_.rows) {
      row.times = {median(reference_ns_.at(name)), median(row_ns_.at(name))};
    }
    return std::move(run_);
  }

 private:
  void add(const json& sample) {
    const auto name = sample.at("row").get<std::string>();
    const auto kind = sample.at("kind").get<std::string>();
    const bool threaded = !sample.contains("thread_cpu");
    const char* clock = threaded ? "wall" : "thread_cpu";
    const Clock of_row = clock_of(sample, clock);
    const Clock of_reference = clock_of(*references_.at(group_of(name)), clock);
    const double log = of_reference.log - of_row.log;
    if (kind != "row") return add_control(kind, name, log);
    if (is_reference(name)) return;
    MeasuredRow& row = run_.rows[name];
    row.name = name;
    row.threaded = threaded;
    row.labels = labels_from(sample);
    row.input_hash = sample.value("input_hash", "");
    row.pixels = sample.value("pixels", std::int64_t{0});
    row.logs.push_back(log);
    row_ns_[name].push_back(of_row.ns);
    reference_ns_[name].push_back(of_reference.ns);
  }

  void add_control(const std::string& kind, const std::string& name, double log) {
    MeasuredControls& controls = run_.controls[group_of(name)];
    if (kind == "same") controls.base.push_back(name);
    (kind == "same" ? controls.same : controls.slowed).push_back(log);
  }

  MeasuredRun run_;
  std::map<std::string, const json*> references_;
  std::map<std::string, Logs> row_ns_;
  std::map<std::string, Logs> reference_ns_;
};

json parsed(const std::string& line) {
  json object = json::parse(line, nullptr, false);
  if (!object.is_object()) throw std::runtime_error("a line is no JSON object");
  return object;
}

/// The lines of a file by process; the first line says what was done.
std::map<std::size_t, std::vector<json>> processes_in(std::istream& stream) {
  std::string line;
  std::getline(stream, line);
  const json head = parsed(line);
  if (head.value("kind", "") != "run") throw std::runtime_error("it holds no samples");
  if (head.value("schema", 0) != kSchema) throw std::runtime_error("its schema is unknown");
  std::map<std::size_t, std::vector<json>> processes;
  while (std::getline(stream, line)) {
    json sample = parsed(line);
    processes[sample.at("process").get<std::size_t>()].push_back(std::move(sample));
  }
  if (processes.size() != head.at("processes")) throw std::runtime_error("it is truncated");
  return processes;
}

void add_file(const std::string& file, Reader& reader) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read it");
  for (const auto& [process, samples] : processes_in(stream)) reader.add_process(samples);
}

}  // namespace

std::string group_of(const std::string& row) {
  const std::vector<std::string> fields = fields_of(row);
  return fields.front() + "/" + fields.back();
}

MeasuredRun read_run(const std::vector<std::string>& files) {
  Reader reader;
  for (const std::string& file : files) {
    try {
      add_file(file, reader);
    } catch (const std::exception& error) {
      throw std::runtime_error("samples '" + file + "': " + error.what());
    }
  }
  return reader.take();
}

}  // namespace thinbench
