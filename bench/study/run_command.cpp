// thinbench-study run: one operation on an image file, by any variant.
#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/names.hpp"
#include "images/image_file.hpp"
#include "peers/peers.hpp"
#include "study/study.hpp"
#include "support/timing.hpp"

namespace thinbench {
namespace {

struct StudyRunOptions {
  std::string operation;
  std::string in;
  std::string out;
  std::string technique;
  std::optional<Isa> isa;
  int threads = 1;
  BinariseOptions binarise;
};

using Variants = std::vector<const Variant*>;

/// Narrows `variants` to those that fulfil `condition`. Throws UsageError where none does, with
/// what there is.
template <class Condition, class NameOf>
void narrow(Variants& variants, const std::string& wanted, const Condition& condition,
            const NameOf& name_of) {
  Variants kept;
  std::vector<std::string_view> known;
  for (const Variant* variant : variants) {
    if (condition(*variant)) kept.push_back(variant);
    const std::string_view name = name_of(*variant);
    if (std::ranges::find(known, name) == known.end()) known.push_back(name);
  }
  if (kept.empty())
    throw UsageError("there is no variant " + wanted + ", only " + enumeration(known));
  variants = kept;
}

/// Those that were asked for, wherever they run.
Variants requested_variants(const Operation& operation, const StudyRunOptions& options) {
  Variants variants;
  for (const Variant& variant : operation.variants) variants.push_back(&variant);
  const auto technique_of = [](const Variant& one) { return one.technique; };
  if (options.technique.empty()) {
    std::erase_if(variants, [](const Variant* one) { return one->is_peer; });
  } else {
    narrow(
        variants, "of " + options.technique,
        [&](const Variant& one) { return one.technique == options.technique; }, technique_of);
  }
  if (options.isa) {
    narrow(
        variants, "for " + std::string(isa_name(*options.isa)),
        [&](const Variant& one) { return one.isa == *options.isa; },
        [](const Variant& one) { return one.isa_label(); });
  }
  narrow(
      variants, "on " + std::to_string(options.threads) + " threads",
      [&](const Variant& one) { return one.threaded == (options.threads > 1); },
      [](const Variant& one) { return one.threaded ? "on several" : "on one"; });
  return variants;
}

/// The one that the library would take.
const Variant& best_of(const Variants& variants, Index width) {
  const Variant* best = nullptr;
  std::string reason;
  for (const Variant* variant : variants) {
    const std::string why = variant->unavailable_reason(width);
    if (!why.empty()) {
      reason = fmt::format("{}/{}: {}", variant->technique, variant->isa_label(), why);
    } else if (best == nullptr || variant->priority > best->priority) {
      best = variant;
    }
  }
  if (best == nullptr) throw std::runtime_error(reason);
  return *best;
}

std::string numbers_text(const Job& job) {
  std::string text;
  const std::vector<std::int64_t> numbers = job.numbers();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    text += fmt::format(", {}: {}", job.name_of_number(i), numbers[i]);
  }
  return text;
}

int run(const StudyRunOptions& options, const Console& console) {
  const auto name_of = [](const Operation& one) { return std::string_view(one.name); };
  const auto& operations = operations_with_peers();
  const Operation& operation = named("operation", options.operation, operations, name_of);
  const Variants variants = requested_variants(operation, options);
  check_extension(options.out);
  std::ostringstream remarks;  // failures are one line, without them
  const ByteImage image = operation.takes == InputKind::grey
                              ? read_grey(options.in, options.binarise, remarks)
                              : read_binary(options.in, options.binarise, &remarks);
  const Variant& variant = best_of(variants, image.width());
  const auto job = variant.make_job(image.width(), image.height(), options.threads);
  if (!job->gives_image()) throw UsageError(operation.name + " gives no image");
  ByteImage result(image.width(), image.height());
  const double milliseconds = milliseconds_of([&] { job->run(image.view(), result.view()); });
  write_grey(options.out, result.view());
  console.err << remarks.str();
  console.out << fmt::format(
      "{}: {} x {}{}, {:.3f} ms\n",
      row_name(operation.name, variant.technique, variant.isa_label(), options.threads),
      image.width(), image.height(), numbers_text(*job), milliseconds);
  return kSuccess;
}

}  // namespace

Command add_study_run_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("run", "Compute an image file by one variant");
  const auto options = std::make_shared<StudyRunOptions>();
  add_argument(*app, "OPERATION", options->operation, "As 'thinbench-study verify' names it");
  add_argument(*app, "IN", options->in, "Image to read");
  add_argument(*app, "OUT", options->out, "Image to write: .png, .pgm, .bmp or .tif");
  add_value(*app, "--technique", options->technique, "How to compute (default: the fastest)",
            not_empty(), "NAME");
  add_isa_option(*app, options->isa);
  add_threads_option(*app, options->threads);
  add_binarise_options(*app, options->binarise);
  app->footer(R"(Examples:
  thinbench-study run thin_guo_hall parts.png skeleton.png --technique lut
  thinbench-study run thin_zhang_suen:keep parts.png skeleton.png --isa baseline --threads 4
  thinbench-study run edges_sobel parts.png edges.png --technique simd_16bit

The operations and techniques are those of 'thinbench-study list --variants', with ':keep' where the
border is kept and with other projects' code. The line printed names the variant and what it counted.)");
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
