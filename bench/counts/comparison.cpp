#include "counts/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "counts/documents.hpp"
#include "support/regular_file.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

[[noreturn]] void reject(const std::string& file, const std::string& why) {
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

/// Throws Json::exception for anything else than an integer.
std::int64_t integer_of(const Json& value) {
  return value.get_ref<const Json::number_integer_t&>();
}

StoredCounts counts_in(const Json& document) {
  StoredCounts counts;
  for (const Json& row : document.at("rows")) {
    std::string method = row.at("method");
    if (method == method_name(Method::callgrind))
      method.append(" ").append(document.at("valgrind"));
    StoredCount& count = counts[row.at("row")];
    count = {static_cast<std::uint64_t>(integer_of(row.at("instructions"))), std::move(method)};
    if (row.contains("iterations")) count.iterations = integer_of(row.at("iterations"));
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
    } else if (old.instructions <= now.at("max_steps")) {
      ++comparison.compared;
      comparison.moved.push_back({found->first, old.instructions, 0});
    }
  }
}

std::string line_of(const MovedRow& moved) {
  if (moved.now == 0) {
    return fmt::format("{}: {} instructions before, now too many to count\n", moved.row,
                       moved.before);
  }
  const double ratio = static_cast<double>(moved.now) / static_cast<double>(moved.before);
  return fmt::format("{}: {} instructions before, {} now ({:+.1f} %)\n", moved.row, moved.before,
                     moved.now, 100 * (ratio - 1));
}

std::string line_of(const ChangedIterations& changed) {
  return fmt::format("{}: {} iterations before, {} now\n", changed.row, changed.before,
                     changed.now);
}

bool is_known(const Json& document) {
  try {
    static_cast<void>(counts_in(document));
    static_cast<void>(document.at("input"));
    static_cast<void>(integer_of(document.at("max_steps")));
    for (const Json& row : document.at("skipped")) {
      static_cast<void>(row.at("row").get_ref<const std::string&>());
      static_cast<void>(row.at("reason"));
    }
    return document.at("build").is_object() && document.at("schema") == kCountsSchema &&
           document.at("kind") == kInstructionsKind;
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
  constexpr std::size_t max_bytes = 1'000'000'000;
  Json document = Json::parse(read_whole_file(file, max_bytes), nullptr, false);
  if (document.is_discarded()) reject(file, "is not complete JSON");
  if (!is_known(document)) reject(file, "holds no counts that this version knows");
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
    text += fmt::format("{} rows not compared: they were counted by another method or valgrind\n",
                        comparison.otherwise_counted);
  }
  const std::size_t more = comparison.more();
  return text +
         fmt::format("{} rows compared: {} take more instructions, {} fewer (tolerance {:.0f} %)\n",
                     comparison.compared, more, comparison.moved.size() - more,
                     100 * kCountTolerance);
}

}  // namespace thinbench
