#include "cli/packed_run.hpp"

#include "cli/arguments.hpp"
#include "images/image_file.hpp"
#include "support/text.hpp"
#include "support/usage.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

PackedFormat raw_format(const PackedOptions& options) {
  constexpr Index max_pixels = Index{1} << 40;
  const auto numbers = whole_numbers(options.raw, "NxN", 13);
  if (numbers.empty() || numbers[0] < 1 || numbers[1] < 1 || numbers[0] > max_pixels ||
      numbers[1] > max_pixels / numbers[0]) {
    throw UsageError("--raw: expected WIDTHxHEIGHT of 1 to 2^40 pixels, got '" + options.raw + "'");
  }
  return {numbers[0], numbers[1],
          options.bit_order == "lsb" ? BitOrder::lsb_first : BitOrder::msb_first, 0};
}

PackedFormat format_of(const PackedOptions& options, const FileBytes& in) {
  return options.raw.empty() ? pbm_format(in) : raw_format(options);
}

}  // namespace

void add_packed_options(CLI::App& app, PackedOptions& options) {
  CLI::Option* raw =
      add_value(app, "--raw", options.raw, "IN and OUT hold bits alone, of an image of this size",
                not_empty(), "WIDTHxHEIGHT");
  add_value(app, "--bit-order", options.bit_order,
            "Raw bits: the first pixel is the highest (msb) or lowest (lsb) bit of a byte "
            "(default: msb)",
            one_of({"msb", "lsb"}), "msb|lsb")
      ->needs(raw);
}

bool is_packed_run(const PackedOptions& options, const std::string& out) {
  return !options.raw.empty() || extension_of(out) == ".pbm";
}

int run_packed(const PackedOptions& options, const RequestedThinning& thinning, FileBytes in,
               const std::string& out, const Console& console) {
  if (out != kStandardStream) check_target(out);
  const PackedFormat format = format_of(options, in);
  const std::string summary = thin_packed_file(thinning, std::move(in), out, format);
  summary_stream(console, out) << summary << '\n';
  return kSuccess;
}

}  // namespace thinbench
