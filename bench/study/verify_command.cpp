// thinbench-study verify: every variant against its reference.
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "core/startable_threads.hpp"
#include "harness/verify.hpp"
#include "images/image_file.hpp"
#include "peers/peers.hpp"
#include "scene/scene.hpp"
#include "study/study.hpp"
#include "support/progress.hpp"
#include "support/timing.hpp"
#include "thinbench/options.hpp"

namespace thinbench {
namespace {

struct VerifyOptions {
  std::string filter;
  std::vector<std::string> images;
  std::vector<int> threads = {2, 7};
  BinariseOptions binarise;
  bool quick = false;
};

bool is_big(const TestImageSet& set) {
  return set.name == "sizes" || set.name == "patterns" || set.name == "grey_noise";
}

TestImage scene_image(SceneKind scene_kind, const std::string& name, InputKind kind) {
  SceneOptions options;
  options.kind = scene_kind;
  Scene scene = render_scene(options);
  return {"scene, " + name,
          kind == InputKind::grey ? std::move(scene.grey) : std::move(scene.binary), kind};
}

/// A set of images that are there already. Names of binary sets stay bare.
TestImageSet set_of(const std::string& name, std::string claim, std::vector<TestImage> images) {
  const InputKind kind = images.front().kind;
  const auto kept = std::make_shared<const std::vector<TestImage>>(std::move(images));
  const auto generate = [kept](const TestImageSink& sink) {
    for (const TestImage& image : *kept) sink(image);
  };
  return {(kind == InputKind::grey ? "grey_" : "") + name, std::move(claim), generate, kind};
}

/// The built-in sets (without the big ones where `quick`), the scenes, and the images in these
/// files, binarised, with the remarks in `log`, and as they are.
std::vector<TestImageSet> verify_image_sets(bool quick, const std::vector<std::string>& files,
                                            const BinariseOptions& binarise, std::ostream& log) {
  std::vector<TestImageSet> sets;
  for (const TestImageSet& set : test_image_sets()) {
    if (!quick || !is_big(set)) sets.push_back(set);
  }
  for (const InputKind kind : {InputKind::binary, InputKind::grey}) {
    std::vector<TestImage> scenes, given;
    scenes.push_back(scene_image(SceneKind::parts, "separate parts", kind));
    scenes.push_back(scene_image(SceneKind::border_touching, "parts on the image border", kind));
    sets.push_back(set_of("scenes", "the scenes that benchmarks use", std::move(scenes)));
    for (const std::string& file : files) {
      const bool is_grey = kind == InputKind::grey;
      given.push_back({file,
                       is_grey ? read_grey(file, binarise, log) : read_binary(file, binarise, &log),
                       kind});
    }
    if (!files.empty()) sets.push_back(set_of("images", "the given files", std::move(given)));
  }
  return sets;
}

void print_verdict(const Row& row, const VerificationResult& verdict, std::ostream& out) {
  if (!verdict.first_mismatch.empty()) {
    out << "mismatch: " << verdict.first_mismatch;
    if (verdict.first_mismatch.back() != '\n') out << '\n';
  } else if (verdict.compared == 0) {
    const std::string reason = row.unavailable_reason(0);
    out << "skipped: " << row.name << ": "
        << (reason.empty() ? "every image is wider than its limit" : reason) << '\n';
  }
}

std::vector<Row> chosen_rows(const VerifyOptions& options) {
  std::vector<int> threads = options.threads;
  std::sort(threads.begin(), threads.end());
  threads.erase(std::unique(threads.begin(), threads.end()), threads.end());
  return checked_usage(
      [&] { return matching_rows(options.filter, threads, operations_with_peers()); },
      "--filter: ");
}

/// What the image takes, in pixels.
double work_of(const TestImage& image) {
  constexpr double kImageOverhead = 140;
  return static_cast<double>(image.image.width() * image.image.height()) + kImageOverhead;
}

/// Goes through the images of the set twice: before, to know how much there is.
void verify(Verifier& verifier, const TestImageSet& set, std::ostream& log) {
  double work = 0;
  long images = 0;
  set.generate([&](const TestImage& image) {
    work += work_of(image);
    ++images;
  });
  const double milliseconds = milliseconds_of([&] {
    Progress progress(set.name, work);
    set.generate([&](const TestImage& image) {
      verifier.show(image);
      progress.advance(work_of(image));
    });
  });
  log << fmt::format("{}: {} images in {:.1f} s\n", set.name, images, milliseconds / 1000)
      << std::flush;
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
    throw UsageError("no row matches the filter '" + options.filter +
                     "'; see 'thinbench-study list'");
  }
  const std::vector<TestImageSet> sets = chosen_sets(options, verifier.rows(), console.err);
  const int max_threads = *std::max_element(options.threads.begin(), options.threads.end());
  const tbb::global_control allowed(
      tbb::global_control::max_allowed_parallelism,
      static_cast<std::size_t>(detail::startable_threads(max_threads)));
  if (any_runs_here(verifier.rows())) {
    for (const TestImageSet& set : sets) verify(verifier, set, console.err);
  }
  return report_verdicts(verifier, console.out);
}

}  // namespace

int report_verdicts(const Verifier& verifier, std::ostream& out) {
  for (std::size_t row = 0; row < verifier.rows().size(); ++row) {
    print_verdict(verifier.rows()[row], verifier.verdict(row), out);
  }
  const VerifySummary summary = summary_of(verifier);
  out << summary.passed << " passed, " << summary.failed << " failed, " << summary.skipped
      << " skipped" << std::endl;
  if (summary.passed + summary.failed == 0) {
    throw UsageError("nothing was verified: none of the matching rows is available here");
  }
  return summary.failed > 0 ? kFailure : kSuccess;
}

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
  add_value(*app, "--threads", options->threads,
            "Threads of threaded rows, 1 to " + std::to_string(kMaxThreads) +
                " (repeatable; default: 2 and 7)",
            whole_number(1, kMaxThreads), "N")
      ->allow_extra_args(false);
  app->add_flag("--quick", options->quick, "Omit the sets that take longest");
  app->footer(R"(Examples:
  thinbench-study verify
  thinbench-study verify --quick --image horse.png --image coins.png
  thinbench-study verify --filter 'simd_.*/avx2' --threads 3 --threads 16

Rows are named operation/technique/isa/threads. The last line on standard output is
"N passed, M failed, K skipped". The exit status is 1 after a mismatch and 2 where nothing ran.)");
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
