// thinbench batch: one operation on many image files.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <tbb/info.h>

#include "batch/inputs.hpp"
#include "batch/jobs.hpp"
#include "batch/manifest.hpp"
#include "batch/pipeline.hpp"
#include "cli/arguments.hpp"
#include "cli/batch_operations.hpp"
#include "cli/batch_table.hpp"
#include "cli/command.hpp"
#include "cli/names.hpp"
#include "cli/tables.hpp"
#include "cli/thinbench.hpp"
#include "images/image_file.hpp"
#include "support/text.hpp"

namespace thinbench {
namespace {

struct BatchOptions {
  BatchOperationRequest operation;
  InputRequest inputs;
  BatchSettings settings;
  std::string manifest;  // empty: in the output directory
  std::string shard;
  bool resume = false;
};

constexpr std::size_t kMaxShards = 1'000'000;

/// From "3/8".
Shard shard_from(const std::string& text) {
  const auto numbers = whole_numbers(text, "N/N", 7);
  if (!numbers.empty()) {
    const Shard shard = {static_cast<std::size_t>(numbers[0]),
                         static_cast<std::size_t>(numbers[1])};
    if (shard.number >= 1 && shard.number <= shard.count && shard.count <= kMaxShards) return shard;
  }
  throw UsageError("--shard: expected I/N with 1 <= I <= N <= " + std::to_string(kMaxShards) +
                   ", got '" + text + "'");
}

/// Shards may run at the same time, so each has its own: table_3_of_8.csv.
std::string name_for(const Shard& shard, const std::string& path) {
  if (shard.count == 1) return path;
  std::filesystem::path name = path;
  const std::string extension = name.extension();
  name.replace_extension();
  return fmt::format("{}_{}_of_{}{}", name.string(), shard.number, shard.count, extension);
}

std::string manifest_path(const BatchOptions& options, const Shard& shard) {
  if (!options.manifest.empty()) return name_for(shard, options.manifest);
  return std::filesystem::path(options.settings.out) / name_for(shard, "manifest.csv");
}

void print_skipped(const FoundInputs& found, const std::string& out, std::ostream& log) {
  if (found.skipped_out) log << "note: skipped '" << out << "', the directory of the results\n";
  if (found.skipped_files > 0) {
    log << "note: skipped " << counted(found.skipped_files, "file")
        << ", hidden or without the extension of an image format\n";
  }
  if (found.skipped_directories > 0) {
    log << "note: skipped " << counted(found.skipped_directories, "directory", "directories")
        << "; --recursive searches all but links and --out\n";
  }
}

std::vector<BatchJob> open_jobs(const std::vector<BatchJob>& jobs, const Manifest& manifest,
                                const BatchOperation& operation, const std::string& out) {
  std::vector<BatchJob> open;
  std::copy_if(jobs.begin(), jobs.end(), std::back_inserter(open),
               [&](const BatchJob& job) { return !is_done(job, manifest, operation, out); });
  return open;
}

void print_failures(const std::vector<std::string>& failures, std::ostream& log) {
  if (failures.empty()) return;
  log << fmt::format("{}:\n", counted(failures.size(), "failure"));
  for (const std::string& failure : failures) log << "  " << one_line(failure) << '\n';
}

struct BatchOutcome {
  std::size_t skipped;  // were done before
  double seconds;
  BatchTotals totals;
};

void print_summary(const BatchOperation& operation, const BatchOutcome& outcome,
                   std::ostream& out) {
  const BatchTotals& totals = outcome.totals;
  const double all =
      std::max(1e-9, totals.decode_seconds + totals.compute_seconds + totals.encode_seconds);
  out << fmt::format("{}: {} done, {} failed, {} done before; {:.1f} s, {:.0f} images/s",
                     one_line(operation.name), counted(totals.done, "image"),
                     totals.failures.size(), outcome.skipped, outcome.seconds,
                     static_cast<double>(totals.done) / std::max(outcome.seconds, 1e-9));
  out << fmt::format("; decoding {:.1f} %, computing {:.1f} %, encoding {:.1f} %\n",
                     100 * totals.decode_seconds / all, 100 * totals.compute_seconds / all,
                     100 * totals.encode_seconds / all);
  if (totals.not_started > 0) {
    out << counted(totals.not_started, "result was", "results were") << " not started\n";
  }
  if (totals.with_warning > 0) {
    out << counted(totals.with_warning, "image has a warning", "images have warnings")
        << " in the manifest\n";
  }
}

BatchOutcome run_open_jobs(const std::vector<BatchJob>& jobs, const BatchOperation& operation,
                           const BatchOptions& options, Manifest& manifest) {
  const std::vector<BatchJob> open = open_jobs(jobs, manifest, operation, options.settings.out);
  const auto start = std::chrono::steady_clock::now();
  BatchTotals totals = run_jobs(open, operation, options.settings, manifest);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  manifest.put_in_order(jobs);
  return {jobs.size() - open.size(), spent.count(), std::move(totals)};
}

/// The manifest, after the directories of the results. Where there can be no manifest, no new
/// directory is left behind.
void open_outputs(const std::vector<BatchJob>& jobs, const std::string& path,
                  const BatchOptions& options, std::optional<Manifest>& manifest) {
  const bool is_new = !std::filesystem::exists(options.settings.out);
  make_directories(jobs, options.settings.out);
  try {
    manifest.emplace(path, options.resume);
  } catch (...) {
    if (is_new) remove_empty_directories(jobs, options.settings.out);
    throw;
  }
}

ResultExtensions extensions_of(const BatchOptions& options) {
  const std::string& overlay = options.operation.overlay;
  if (makes_json(options.operation)) return {".json", overlay.empty() ? "" : "." + overlay};
  const std::string& format = options.operation.format;
  if (format.empty()) return {".png", ""};
  return {format == "tiff" ? ".tif" : "." + format, ""};
}

int run(const BatchOptions& options, const Console& console) {
  const BatchOperation operation = batch_operation(options.operation);
  const Shard shard = options.shard.empty() ? Shard{} : shard_from(options.shard);
  const std::string path = manifest_path(options, shard);
  const TableFormat format = table_format("--manifest", path);
  const std::string table =
      options.operation.table.empty() ? "" : name_for(shard, options.operation.table);
  if (!table.empty()) static_cast<void>(table_format("--table", table));
  if (options.inputs.null_separated && std::ranges::count(options.inputs.in, "-") == 0) {
    throw UsageError("--null needs - as IN, a list on standard input");
  }
  FoundInputs found = find_inputs(options.inputs, std::cin);
  if (found.inputs.empty() && found.failures.empty()) {
    throw std::runtime_error("there is no image file in what was named");
  }
  const ResultExtensions extensions = extensions_of(options);
  auto all = jobs_of(found.inputs, extensions, extensions.output == ".tif");
  const auto check = [format](const std::string& file) { check_name(file, format); };
  const std::vector<std::string> impossible = remove_impossible(all, options.settings.out, check);
  const bool ends = options.settings.stops_on_error || (all.empty() && found.failures.empty());
  if (!impossible.empty() && ends) throw std::runtime_error(impossible.front());
  found.failures.insert(found.failures.end(), impossible.begin(), impossible.end());
  const std::vector<BatchJob> jobs = jobs_in(all, shard);
  if (!table.empty()) check_table(table, path, jobs, options.settings.out);
  std::optional<Manifest> manifest;
  open_outputs(jobs, path, options, manifest);
  print_skipped(found, options.settings.out, console.err);
  BatchOutcome outcome = run_open_jobs(jobs, operation, options, *manifest);
  if (!table.empty()) {
    write_batch_table(table, jobs, *manifest, operation, options.settings.out,
                      makes_graphs(options.operation));
  }
  std::vector<std::string>& failures = outcome.totals.failures;
  failures.insert(failures.begin(), found.failures.begin(), found.failures.end());
  print_summary(operation, outcome, console.out);
  print_failures(failures, console.err);
  return failures.empty() ? kSuccess : kFailure;
}

void add_input_options(CLI::App& app, BatchOptions& options) {
  add_argument(app, "IN", options.inputs.in,
               "Image files, directories, quoted patterns such as 'scans/*.png', or - for a list "
               "on standard input");
  app.add_flag("--recursive", options.inputs.recursive,
               "Search the directories in directories, too");
  app.add_flag("--null", options.inputs.null_separated,
               "The list has a NUL after each path instead of a newline, as from find -print0");
  add_value(app, "--shard", options.shard, "Do the I-th of N parts, for several runs at once",
            not_empty(), "I/N");
}

void add_output_options(CLI::App& app, BatchOptions& options) {
  add_value(app, "--out", options.settings.out, "Directory of the results, made if need be",
            not_empty(), "DIR")
      ->required();
  add_value(app, "--format", options.operation.format, "Format of images",
            one_of({"png", "tiff", "pgm", "pbm"}), "png|tiff|pgm|pbm")
      ->default_str("png");
  add_value(app, "--overlay", options.operation.overlay,
            "Also DIR/NAME.svg or .png for each image: what was found, drawn on it (holes, "
            "localise, graph)",
            one_of({"svg", "png"}), "svg|png");
  add_file_option(app, "--table", options.operation.table,
                  "One table of what was found in all images, .csv or .jsonl (holes, localise, "
                  "graph)",
                  file_name());
  add_file_option(app, "--manifest", options.manifest,
                  "A line for each image, .csv or .jsonl (default: DIR/manifest.csv)");
  app.add_flag("--resume", options.resume,
               "Skip what the manifest says is done and whose result exists");
  add_value(
      app, "--on-error",
      [&options](const std::string& word) { options.settings.stops_on_error = word == "stop"; },
      "After a failure: continue with the other images, or stop", one_of({"continue", "stop"}),
      "continue|stop")
      ->default_str("continue");
}

constexpr const char* kFooter = R"(Examples:
  thinbench batch thin_guo_hall scans --out skeletons
  thinbench batch thin_guo_hall scans --recursive --out skeletons --resume
  thinbench batch holes 'parts/*.jpg' --min-area 20 --out found --table holes.csv --overlay png
  thinbench batch graph maps --prune-widths 1 --out graphs --table edges.csv --overlay svg
  find scans -name '*.tif' -print0 | thinbench batch edges - --null --out edges --format tiff
  parallel thinbench batch thin_zhang_suen scans --out skeletons --shard {}/4 ::: 1 2 3 4

OPERATION is a rule, midpoint_scan, holes, localise or graph (a .json for each image), edges (by Sobel's
operator) or edges_ and the name of another operator. A result has the name of its input and lies in
DIR, that of scans/a/b.png, found in scans, at DIR/a/b.png; beside b.bmp it is DIR/a/b.png.png. A TIFF
file of several pages becomes NAME_page1.png and so on or, with --format tiff, one file. Results appear
whole or not at all; after a failure or a kill, --resume does what is left, and the failed images again.

The manifest has the foreground chosen, numbers of pixels, objects and holes of the foreground
before, seconds, warnings and errors. The exit status is 1 if any image failed.)";

}  // namespace

Command add_batch_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("batch", "Do one operation on many image files");
  const auto options = std::make_shared<BatchOptions>();
  BatchOperationRequest& operation = options->operation;
  add_argument(*app, "OPERATION", operation.thinning.rule,
               "A rule, midpoint_scan, holes, localise, graph, edges or edges_sobel and so on");
  add_input_options(*app, *options);
  add_output_options(*app, *options);
  add_isa_option(*app, operation.thinning.execution.isa);
  options->settings.threads = std::min(tbb::info::default_concurrency(), kMaxThreads);
  add_threads_option(*app, options->settings.threads);
  const auto added = [app](const auto& add, auto& request) {
    return options_added(*app, [&] { add(*app, request); });
  };
  operation.of_thinning = added(add_thinning_options, operation.thinning);
  operation.of_edges = added(add_edge_thresholds, operation.edges);
  operation.of_graphs = added(add_graph_options, operation.graph);
  add_value(*app, "--min-area", operation.min_area,
            "Omit objects and holes of fewer than N pixels, 1 to 2^31 (holes)",
            whole_number(1, kMaxImagePixels), "N");
  operation.of_binarise = add_binarise_options(*app, operation.binarise);
  app->footer(kFooter);
  return {app, [options](const Console& console) {
            options->inputs.out = options->settings.out;
            options->settings.reading = options->operation.binarise;
            return run(*options, console);
          }};
}

}  // namespace thinbench
