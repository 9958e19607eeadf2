#include "counts/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "counts/documents.hpp"
#include "support/text.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
  throw std::runtime_error("'" + file + "' " + why);
}

/// What keeps the documents from being compared.
std::string difference_of(const Json& before, const Json& now) {
  for (const auto& [name, value] : now.at("build").items()) {
    if (before.at("build").value(name, Json()) != value) return "they are of another " + name;
  }
  if (before.at("input") != now.at("input")) return "they are of another input";
  return {};
}

struct StoredCount {
  std::uint64_t instructions = 0;
  std::string method;  // with valgrind's version
  std::optional<std::int64_t> iterations = std::nullopt;
};

using StoredCounts = std::map<std::string, StoredCount>;

/// Before schema 3, iterations were called passes; before schema 2, rows named no method.
StoredCounts counts_in(const Json& document) {
  const std::string single_steps = method_name(Method::single_steps);
  StoredCounts counts;
  for (const Json& row : document.at("rows")) {
    std::string method = row.value("method", single_steps);
    if (method != single_steps) method.append(" ").append(document.at("valgrind"));
    StoredCount& count = counts[row.at("row")];
    count = {row.at("instructions"), std::move(method)};
    for (const char* field : {"iterations", "passes"}) {
      if (row.contains(field)) count.iterations = row.at(field);
    }
  }
  return counts;
}

bool is_moved(std::uint64_t before, std::uint64_t now) {
  const auto old = static_cast<double>(before);
  return std::abs(static_cast<double>(now) - old) > kCountTolerance * old;
}

/// Rows that were counted before and have become too long to be counted.
void add_overlong(const Json& now, const StoredCounts& before, Comparison& comparison) {
  for (const Json& row : now.at("skipped")) {
    const auto found = before.find(row.at("row"));
    if (found == before.end() || row.at("reason") != kTooManySteps) continue;
    const StoredCount& old = found->second;
    if (old.method != method_name(Method::single_steps)) {
      ++comparison.otherwise_counted;
    } else if (old.instructions <= now.at("most_steps")) {
      ++comparison.compared;
      comparison.moved.push_back({found->first, old.instructions, 0});
    }
  }
}

std::string line_of(const MovedRow& moved) {
  const std::string before = moved.row + ": " + std::to_string(moved.before) + " instructions";
  if (moved.now == 0) return before + " before, now too many to count\n";
  const double ratio = static_cast<double>(moved.now) / static_cast<double>(moved.before);
  return before + " before, " + std::to_string(moved.now) + " now (" +
         (moved.is_more() ? "+" : "") + fixed(100 * (ratio - 1), 1) + " %)\n";
}

std::string line_of(const ChangedIterations& changed) {
  return changed.row + ": " + std::to_string(changed.before) + " iterations before, " +
         std::to_string(changed.now) + " now\n";
}

bool is_known(const Json& document) {
  try {
    static_cast<void>(counts_in(document));
    static_cast<void>(document.at("input"));
    const int schema = document.at("schema");
    return document.at("build").is_object() && schema >= kFirstCountsSchema &&
           schema <= kCountsSchema && document.at("kind") == kInstructionsKind;
  } catch (const Json::exception&) {
    return false;
  }
}

}  // namespace

std::size_t Comparison::more() const {
  return static_cast<std::size_t>(
      std::count_if(moved.begin(), moved.end(), [](const MovedRow& row) { return row.is_more(); }));
}

Json read_counts(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) refuse(file, "cannot be read");
  Json document = Json::parse(stream, nullptr, false);
  if (document.is_discarded()) refuse(file, "is no complete JSON");
  if (!is_known(document)) refuse(file, "holds no counts that this version knows");
  return document;
}

Comparison compare(const Json& before, const Json& now) {
  Comparison comparison;
  comparison.why_not = difference_of(before, now);
  if (!comparison.why_not.empty()) return comparison;
  const auto old_counts = counts_in(before);
  for (const auto& [row, count] : counts_in(now)) {
    const auto old = old_counts.find(row);
    if (old == old_counts.end()) continue;
    if (old->second.method != count.method) {
      ++comparison.otherwise_counted;
      continue;
    }
    ++comparison.compared;
    if (old->second.iterations && count.iterations && old->second.iterations != count.iterations) {
      comparison.iterations.push_back({row, *old->second.iterations, *count.iterations});
    }
    if (is_moved(old->second.instructions, count.instructions)) {
      comparison.moved.push_back({row, old->second.instructions, count.instructions});
    }
  }
  add_overlong(now, old_counts, comparison);
  return comparison;
}

std::string to_text(const Comparison& comparison) {
  if (!comparison.why_not.empty()) return "nothing compared: " + comparison.why_not + "\n";
  std::string text;
  for (const MovedRow& moved : comparison.moved) text += line_of(moved);
  for (const ChangedIterations& changed : comparison.iterations) text += line_of(changed);
  if (comparison.otherwise_counted > 0) {
    text += std::to_string(comparison.otherwise_counted) +
            " rows not compared: they were counted by another method or valgrind\n";
  }
  const std::size_t more = comparison.more();
  return text + std::to_string(comparison.compared) + " rows compared: " + std::to_string(more) +
         " take more instructions, " + std::to_string(comparison.moved.size() - more) +
         " fewer (tolerance " + fixed(100 * kCountTolerance, 0) + " %)\n";
}

}  // namespace thinbench
