// thinbench verify: every variant against its reference.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <tbb/global_control.h>

#include "cli/arguments.hpp"
#include "cli/binarise_options.hpp"
#include "cli/command.hpp"
#include "cli/verify_images.hpp"
#include "cli/verify_progress.hpp"
#include "cli/verify_report.hpp"
#include "peers/peers.hpp"
#include "thinbench/options.hpp"

namespace thinbench {
namespace {

constexpr const char* kExamples = R"(Examples:
  thinbench verify
  thinbench verify --quick --image horse.png --image coins.png
  thinbench verify --filter 'simd_.*/avx2' --threads 3 --threads 16

Rows are named operation/technique/isa/threads. The last line on standard output is
"N passed, M failed, K skipped". The exit status is 1 after a mismatch and 2 where nothing ran.

Images of more than 2^30 pixels need OPENCV_IO_MAX_IMAGE_PIXELS=2147483648 in the environment.)";

struct VerifyOptions {
  std::string filter;
  std::vector<std::string> images;
  std::vector<int> threads = {2, 7};
  BinariseOptions binarise;
  bool quick = false;
};

std::vector<Row> chosen_rows(const VerifyOptions& options) {
  std::vector<int> threads = options.threads;
  std::sort(threads.begin(), threads.end());
  threads.erase(std::unique(threads.begin(), threads.end()), threads.end());
  try {
    return matching_rows(options.filter, threads, operations_with_peers());
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--filter: ") + error.what());
  }
}

void verify(Verifier& verifier, const std::vector<TestImageSet>& sets, const Console& console) {
  VerifyProgress progress(console, sets);
  for (std::size_t set = 0; set < sets.size(); ++set) {
    progress.begin_set(set);
    sets[set].generate([&](const TestImage& image) {
      verifier.show(image);
      progress.image_done(image);
    });
    progress.end_set();
  }
}

bool any_runs_here(const std::vector<Row>& rows) {
  return std::any_of(rows.begin(), rows.end(),
                     [](const Row& row) { return row.unavailable_reason(0).empty(); });
}

/// The sets that some row takes.
std::vector<TestImageSet> chosen_sets(const VerifyOptions& options, const std::vector<Row>& rows,
                                      std::ostream& log) {
  std::vector<TestImageSet> sets =
      verify_image_sets(options.quick, options.images, options.binarise, log);
  std::erase_if(sets, [&](const TestImageSet& set) {
    return std::none_of(rows.begin(), rows.end(),
                        [&](const Row& row) { return row.operation->takes == set.kind; });
  });
  return sets;
}

int run(const VerifyOptions& options, const Console& console) {
  Verifier verifier(chosen_rows(options));
  if (verifier.rows().empty()) {
    console.out << "0 passed, 0 failed, 0 skipped" << std::endl;
    throw UsageError("no row matches the filter '" + options.filter + "'; see 'thinbench list'");
  }
  const std::vector<TestImageSet> sets = chosen_sets(options, verifier.rows(), console.err);
  const int most = *std::max_element(options.threads.begin(), options.threads.end());
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(most));
  if (any_runs_here(verifier.rows())) verify(verifier, sets, console);
  return report_verdicts(verifier, console.out);
}

}  // namespace

Command add_verify_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("verify", "Compare every variant with its reference");
  const auto options = std::make_shared<VerifyOptions>();
  app->add_option("--filter", options->filter, "Only rows whose name contains a match")
      ->type_name("REGEX");
  CLI::Option* image =
      app->add_option("--image", options->images, "Image to compare on as well (repeatable)")
          ->type_name("FILE")
          ->allow_extra_args(false);
  add_binarise_options(*app, options->binarise, image);
  app->add_option("--threads", options->threads,
                  "Threads of threaded rows, 1 to " + std::to_string(kMaxThreads) +
                      " (repeatable; default: 2 and 7)")
      ->check(whole_number(1, kMaxThreads))
      ->type_name("N")
      ->allow_extra_args(false);
  app->add_flag("--quick", options->quick, "Leave out the sets that take longest");
  app->footer(kExamples);
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
