#include "cli/packed_run.hpp"

#include <charconv>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <malloc.h>

#include "cli/arguments.hpp"
#include "cli/usage.hpp"
#include "images/image_file.hpp"
#include "out_of_core/out_of_core.hpp"
#include "support/text.hpp"
#include "support/timing.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

constexpr const char* kDefaultMemory = "256M";
constexpr Index kMinMemory = Index{1} << 20;

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
  return {*width, *height, options.bit_order == "lsb" ? BitOrder::lsb_first : BitOrder::msb_first};
}

/// "256M" in bytes.
Index bytes_of(const std::string& given) {
  constexpr std::string_view units = "KMGT";
  std::string_view text = given;
  const std::optional<Index> number = take_number(text);
  const std::size_t unit = text.size() == 1 ? units.find(text.front()) : std::string_view::npos;
  const bool has_unit = unit != std::string_view::npos;
  const int shift = has_unit ? static_cast<int>(10 * (unit + 1)) : 0;
  if (!number || !(text.empty() || has_unit) || *number > (Index{1} << 60) >> shift ||
      *number << shift < kMinMemory) {
    throw UsageError("--memory: expected 1M to 1048576T bytes, such as 256M or 4G, got '" + given +
                     "'");
  }
  return *number << shift;
}

PackedFormat format_of(const PackedOptions& options, const std::string& in) {
  return options.raw.empty() ? pbm_format(in) : raw_format(options);
}

/// Shows the number of the pass and of the tile on a terminal.
std::function<void(int, Index)> progress_on(const Console& console, Index tiles) {
  if (!console.err_is_terminal) return {};
  const auto mutex = std::make_shared<std::mutex>();
  return [&console, tiles, mutex](int pass, Index tile) {
    const std::lock_guard lock(*mutex);
    console.err << fmt::format("\rpass {}, tile {} of {}  ", pass + 1, tile + 1, tiles)
                << std::flush;
  };
}

}  // namespace

Index memory_of(const PackedOptions& options) {
  return bytes_of(options.memory.empty() ? kDefaultMemory : options.memory);
}

int thin_out_of_core(const PackedOptions& options, const RequestedThinning& thinning,
                     const PackedFiles& files, const Console& console) {
  // By default glibc keeps up to 64 MiB of what was freed.
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  const PackedFormat& format = files.format;
  const Index reach = std::max(1, thinning.rule.reach());  // checked by the run
  const Tiling tiling = tiling_for(format.width, format.height, reach,
                                   block_bytes_for(memory_of(options), thinning.execution.threads));
  const OutOfCoreRun run{thinning.rule,
                         files.in,
                         files.out,
                         format,
                         tiling,
                         thinning.thinning,
                         thinning.execution,
                         options.resume,
                         progress_on(console, tiling.count()),
                         files.conversion};
  OutOfCoreResult result{};
  const double milliseconds = milliseconds_of([&] { result = thin_out_of_core(run); });
  if (run.on_tile) console.err << '\n';
  const RunSummary summary = {format.width,
                              format.height,
                              result.iterations,
                              result.foreground_before,
                              result.foreground_after,
                              milliseconds};
  console.out << fmt::format("{}: {}\n", thinning.name, text_of(summary))
              << fmt::format("{} of {} x {} in {}\n", counted(tiling.count(), "tile"),
                             tiling.tile_width, tiling.tile_height,
                             counted(result.passes, "pass", "passes"));
  return kSuccess;
}

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
  CLI::Option* out_of_core =
      app.add_flag("--out-of-core", options.out_of_core,
                   "Thin a packed file by tiles, for images larger than memory");
  app.add_option("--memory", options.memory,
                 "How much memory --out-of-core may take, such as 64M or 4G (default: 256M)")
      ->check(not_empty())
      ->needs(out_of_core)
      ->type_name("LIMIT");
  app.add_flag("--resume", options.resume,
               "Continue an --out-of-core run that was interrupted, with the same options")
      ->needs(out_of_core);
}

bool is_packed_run(const PackedOptions& options, const std::string& out) {
  return !options.raw.empty() || options.out_of_core || extension_of(out) == ".pbm";
}

int run_packed(const PackedOptions& options, const RequestedThinning& thinning,
               const ThinningFiles& files, const Console& console) {
  if (files.in == kStandardStream && !options.out_of_core) {
    int status = kFailure;
    read_standard_input([&](const std::string& copy) {
      status = run_packed(options, thinning, {copy, files.out}, console);
    });
    return status;
  }
  if (options.out_of_core && (files.in == kStandardStream || files.out == kStandardStream)) {
    throw UsageError("--out-of-core reads and writes files, no standard streams");
  }
  if (options.out_of_core && options.raw.empty() && extension_of(files.out) != ".pbm") {
    throw UsageError("--out-of-core writes .pbm, .tif and .tiff or, with --raw, bits; got '" +
                     files.out + "'");
  }
  if (files.out != kStandardStream) check_target(files.out);
  const PackedFormat format = format_of(options, files.in);
  if (options.out_of_core) {
    return thin_out_of_core(options, thinning, {files.in, files.out, format, {}}, console);
  }
  const std::string summary = thin_packed_file(thinning, files, format);
  summary_stream(console, files.out) << summary << '\n';
  return kSuccess;
}

}  // namespace thinbench
