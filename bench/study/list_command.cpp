// thinbench-study list: the operations, and every way to compute them.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/aligned.hpp"
#include "cli/command.hpp"
#include "core/thread_team.hpp"
#include "measure/timed_row.hpp"
#include "peers/peers.hpp"
#include "study/study.hpp"

namespace thinbench {
namespace {

/// Some variants are for narrow images only.
constexpr Index kListedWidth = 1024;

struct ListedRow {
  const Operation& operation;
  const Variant& variant;
  std::string reason;  // empty where it runs
  bool is_fastest;

  [[nodiscard]] std::string threads() const { return variant.threaded ? "n" : "1"; }
  /// Of images for which the library chooses the row by itself.
  [[nodiscard]] Index min_pixels() const {
    return variant.threaded ? detail::kMinPixelsForThreads : 0;
  }
};

/// The variant that the library takes here, on one thread; nullptr where there is none.
const Variant* fastest_of(const Operation& operation) {
  const auto found = std::ranges::find_if(operation.variants, [&](const Variant& one) {
    return !one.threaded && one.unavailable_reason(kListedWidth).empty() &&
           is_default(operation, one, kListedWidth);
  });
  return found == operation.variants.end() ? nullptr : &*found;
}

/// Borders and limits are options of an operation, not operations.
bool is_listed(const Operation& operation) {
  return operation.border != Border::keep && !operation.max_iterations;
}

std::vector<ListedRow> all_rows() {
  std::vector<ListedRow> rows;
  for (const Operation& operation : operations_with_peers()) {
    if (!is_listed(operation)) continue;
    const Variant* fastest = fastest_of(operation);
    for (const Variant& variant : operation.variants) {
      rows.push_back(
          {operation, variant, std::string(variant.unavailable_reason(0)), &variant == fastest});
    }
  }
  return rows;
}

void print_json(std::ostream& out) {
  auto list = nlohmann::ordered_json::array();
  for (const ListedRow& row : all_rows()) {
    list.push_back({{"operation", row.operation.name},
                    {"technique", row.variant.technique},
                    {"isa", row.variant.isa_label()},
                    {"threads", row.threads()},
                    {"min_pixels", row.min_pixels()},
                    {"available", row.reason.empty()},
                    {"reason", row.reason},
                    {"peer", row.variant.is_peer},
                    {"fastest", row.is_fastest},
                    {"description", row.variant.description}});
  }
  out << list.dump(2) << '\n';
}

/// Of the library's own.
std::ptrdiff_t variants_here(const Operation& operation) {
  return std::count_if(
      operation.variants.begin(), operation.variants.end(),
      [](const Variant& one) { return !one.is_peer && one.unavailable_reason(0).empty(); });
}

void print_operations(std::ostream& out) {
  std::vector<Cells> lines = {{"operation", "variants", "fastest", "what it does"}};
  for (const Operation& operation : operations_with_peers()) {
    if (!is_listed(operation)) continue;
    const Variant* fastest = fastest_of(operation);
    lines.push_back({operation.name, std::to_string(variants_here(operation)),
                     fastest == nullptr ? "none"
                                        : std::string(fastest->technique) + "/" +
                                              std::string(isa_name(fastest->isa)),
                     std::string(operation.description)});
  }
  print_aligned(lines, out);
}

void print_variants(std::ostream& out) {
  std::vector<Cells> lines = {{"operation", "technique", "isa", "threads", "available"}};
  for (const ListedRow& row : all_rows()) {
    lines.push_back({row.operation.name, std::string(row.variant.technique),
                     std::string(row.variant.isa_label()), row.threads(),
                     row.reason.empty() ? "yes" : "no: " + row.reason});
  }
  print_aligned(lines, out);
  out << "\nWith --threads: images of fewer than " << detail::kMinPixelsForThreads
      << " pixels run on one thread all the same,\nwhich is faster, unless --technique asks for "
         "one with threads.\n";
}

struct ListOptions {
  bool variants = false;
  bool json = false;
};

int list(const ListOptions& options, std::ostream& out) {
  if (options.json) {
    print_json(out);
  } else if (options.variants) {
    print_variants(out);
  } else {
    print_operations(out);
  }
  return kSuccess;
}

}  // namespace

Command add_study_list_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("list", "List the operations and how each is computed");
  const auto options = std::make_shared<ListOptions>();
  app->add_flag("--variants", options->variants,
                "A line for each variant of each operation, and whether it runs here");
  app->add_flag("--json", options->json, "All variants as a JSON array instead of a table");
  app->footer(R"(Examples:
  thinbench-study list
  thinbench-study list --variants | grep thin_guo_hall
  thinbench-study list --json | jq '.[] | select(.fastest) | .operation + " " + .technique'
  THINBENCH_MAX_ISA=sse4.2 thinbench-study list

Without options, a line for each operation: how many of its variants this machine can run, which of
them the library takes on one thread for an image 1024 pixels wide, and what it does.)");
  return {app, [options](const Console& console) { return list(*options, console.out); }};
}

}  // namespace thinbench
