#include "cli/thinning_run.hpp"

#include <algorithm>
#include <sstream>

#include "cli/arguments.hpp"
#include "cli/summary.hpp"
#include "cli/variant_choice.hpp"
#include "harness/operation.hpp"
#include "images/image_file.hpp"

namespace thinbench {
namespace {

/// The summary without the numbers of foreground pixels.
template <class Source, class Destination>
RunSummary thin_views(detail::ThinningState& state, const Source& source,
                      const Destination& destination, int threads) {
  RunSummary summary{source.width, source.height, 0, 0, 0, 0};
  summary.milliseconds =
      milliseconds_of(threads, [&] { summary.iterations = state.run(source, destination); });
  return summary;
}

Options with_useful_threads(const Thinning& thinning, const Options& how, Index width,
                            Index height) {
  const bool can_share = std::ranges::any_of(thinning.variants, &detail::ThinningVariant::threaded);
  return detail::with_useful_threads(how, can_share, width, height);
}

std::string line_of(const Thinning& thinning, const detail::ThinningVariant& variant, int threads,
                    const RunSummary& summary) {
  return row_name(thinning.name, technique_name(variant.technique), isa_name(variant.isa),
                  threads) +
         ": " + text_of(summary);
}

}  // namespace

Thinning thinning_of(const detail::ThinningOperation& operation) {
  return {std::string(operation.name), operation.variants,
          [&operation](const detail::ThinningVariant& variant, Index width, Index height,
                       const Options& options) {
            return detail::make_state(operation, variant, width, height, options);
          }};
}

std::string thin_image_file(const Thinning& thinning, const ThinningFiles& files,
                            const BinariseOptions& binarise, const Options& how,
                            const Console& console) {
  check_extension(files.out);
  std::ostringstream remarks;  // failures are one line, without them
  ByteImage image = read_binary(files.in, binarise, &remarks);
  const Index width = image.width(), height = image.height();
  const Options used = with_useful_threads(thinning, how, width, height);
  const detail::ThinningVariant& variant = variant_for(thinning, width, used);
  auto state = thinning.make_state(variant, width, height, used);
  const Index foreground_before = foreground_pixels(image.view());
  RunSummary summary = thin_views(*state, image.view(), image.view(), used.threads);
  summary.foreground_before = foreground_before;
  summary.foreground_after = foreground_pixels(image.view());
  state.reset();  // encoding takes memory, too
  write_grey(files.out, image.view());
  console.err << remarks.str();
  return line_of(thinning, variant, used.threads, summary);
}

std::string thin_packed_image(const Thinning& thinning, const PackedView& image, const Options& how,
                              const std::function<void()>& save) {
  const Options used = with_useful_threads(thinning, how, image.width, image.height);
  const detail::ThinningVariant& variant = variant_for(thinning, image.width, used);
  const Index foreground_before = packed_foreground(image);
  const auto state = thinning.make_state(variant, image.width, image.height, used);
  RunSummary summary = thin_views(*state, image, image, used.threads);
  summary.foreground_before = foreground_before;
  summary.foreground_after = packed_foreground(image);
  save();
  return line_of(thinning, variant, used.threads, summary);
}

std::string thin_packed_file(const Thinning& thinning, const ThinningFiles& files,
                             const PackedFormat& format, const Options& how) {
  std::string bytes = format.header;
  bytes.resize(static_cast<std::size_t>(format.file_bytes()));
  auto* const data = reinterpret_cast<std::uint8_t*>(bytes.data() + format.header_bytes());
  PackedFile::open(files.in, format).read({0, 0, format.width, format.height}, data);
  const PackedView image(data, format.width, format.height, format.order);
  return thin_packed_image(thinning, image, how, [&] { write_whole_file(files.out, bytes); });
}

void reject_for_packed_files(const BinariseOptions& options) {
  const std::string words = binarise_words(options);
  if (words.empty()) return;
  throw UsageError(words.substr(1, words.find(' ', 1) - 1) +
                   " does not apply to packed files, whose foreground is 1");
}

}  // namespace thinbench
