// thinbench list: every way to compute every operation, and whether it runs here.
#include <algorithm>
#include <array>
#include <iomanip>
#include <memory>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "image/thread_team.hpp"
#include "peers/peers.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

constexpr const char* kExamples = R"(Examples:
  thinbench list
  thinbench list --json | jq '.[] | select(.available) | .technique'
  THINBENCH_MAX_ISA=sse4.2 thinbench list)";

constexpr std::size_t kColumns = 5;
using Cells = std::array<std::string, kColumns>;

struct ListedRow {
  const Operation& operation;
  const Variant& variant;
  std::string reason;  // empty where it runs

  [[nodiscard]] std::string threads() const { return variant.threaded ? "n" : "1"; }
  /// Of pictures for which the library chooses the row by itself.
  [[nodiscard]] Index least_pixels() const {
    const bool is_thinning = find_thinning_operation(operation.name) != nullptr;
    return is_thinning && variant.threaded ? kMinPixelsForThreads : 0;
  }
};

std::vector<ListedRow> all_rows() {
  std::vector<ListedRow> rows;
  for (const Operation& operation : operations_with_peers()) {
    for (const Variant& variant : operation.variants) {
      rows.push_back({operation, variant, std::string(variant.unavailable_reason(0))});
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
                    {"least_pixels", row.least_pixels()},
                    {"available", row.reason.empty()},
                    {"reason", row.reason},
                    {"peer", row.variant.is_peer},
                    {"description", row.variant.description}});
  }
  out << list.dump(2) << '\n';
}

void print_aligned(const std::vector<Cells>& lines, std::ostream& out) {
  std::array<std::size_t, kColumns> widths{};
  for (const Cells& cells : lines) {
    for (std::size_t i = 0; i < kColumns; ++i) widths[i] = std::max(widths[i], cells[i].size());
  }
  for (const Cells& cells : lines) {
    for (std::size_t i = 0; i + 1 < kColumns; ++i) {
      out << std::left << std::setw(static_cast<int>(widths[i]) + 2) << cells[i];
    }
    out << cells.back() << '\n';
  }
}

void print_table(std::ostream& out) {
  std::vector<Cells> lines = {{"operation", "technique", "isa", "threads", "available"}};
  for (const ListedRow& row : all_rows()) {
    lines.push_back({row.operation.name, std::string(row.variant.technique),
                     std::string(row.variant.isa_label()), row.threads(),
                     row.reason.empty() ? "yes" : "no: " + row.reason});
  }
  print_aligned(lines, out);
  out << "\nThinning with --threads: pictures of fewer than " << kMinPixelsForThreads
      << " pixels run on one thread all the same,\nwhich is faster, unless --technique asks for "
         "one with threads.\n";
}

}  // namespace

Command add_list_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("list", "List every way to compute every operation");
  const auto json = std::make_shared<bool>(false);
  app->add_flag("--json", *json, "Print a JSON array instead of a table");
  app->footer(kExamples);
  return {app, [json](const Console& console) {
            *json ? print_json(console.out) : print_table(console.out);
            return kSuccess;
          }};
}

}  // namespace thinbench
