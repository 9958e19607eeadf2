#include "cli/packed_run.hpp"

#include <charconv>
#include <optional>
#include <string_view>

#include "cli/arguments.hpp"
#include "images/image_file.hpp"
#include "support/text.hpp"
#include "support/usage.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

/// The number at the beginning of `text`, which is shortened by it; nothing if there is none.
std::optional<Index> take_number(std::string_view& text) {
  Index number = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (result.ec != std::errc() || number < 1) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(result.ptr - text.data()));
  return number;
}

/// "510x412" as width and height.
PackedFormat raw_format(const PackedOptions& options) {
  std::string_view text = options.raw;
  constexpr Index max_side = Index{1} << 40;
  const std::optional<Index> width = take_number(text);
  const bool has_x = !text.empty() && text.front() == 'x';
  if (has_x) text.remove_prefix(1);
  const std::optional<Index> height = take_number(text);
  if (!width || !has_x || !height || !text.empty() || *width > max_side ||
      *height > max_side / *width) {
    throw UsageError("--raw: expected WIDTHxHEIGHT of 1 to 2^40 pixels, got '" + options.raw + "'");
  }
  return {*width, *height, options.bit_order == "lsb" ? BitOrder::lsb_first : BitOrder::msb_first,
          0};
}

PackedFormat format_of(const PackedOptions& options, const FileBytes& in) {
  return options.raw.empty() ? pbm_format(in) : raw_format(options);
}

}  // namespace

void add_packed_options(CLI::App& app, PackedOptions& options) {
  CLI::Option* raw =
      app.add_option("--raw", options.raw, "IN and OUT hold bits alone, of an image of this size")
          ->check(not_empty())
          ->type_name("WIDTHxHEIGHT");
  app.add_option("--bit-order", options.bit_order,
                 "Raw bits: the first pixel is the highest (msb) or lowest (lsb) bit of a byte "
                 "(default: msb)")
      ->check(one_of({"msb", "lsb"}))
      ->needs(raw)
      ->type_name("msb|lsb");
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
