#include "images/binarise.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>

#include <fmt/format.h>

#include "images/codecs.hpp"
#include "support/text.hpp"

namespace thinbench {
namespace {

const char* opposite(const BinaryImage& binary) {
  return binary.foreground == Foreground::bright ? "--foreground dark" : "--foreground bright";
}

std::string note(const BinaryImage& binary, const BinariseOptions& options) {
  const bool is_as_read = binary.was_binary && binary.foreground == Foreground::bright;
  std::vector<const char*> overrides;  // options that choose otherwise what was chosen here
  if (options.foreground == Foreground::automatic) overrides.push_back(opposite(binary));
  if (!options.threshold && !options.local && !binary.was_binary)
    overrides.push_back("--threshold N");
  if (is_as_read || binary.only_level || overrides.empty()) return {};
  return fmt::format("{}foreground is {}; {} {} this",
                     binary.range.empty() ? "" : binary.range + "; ", class_text(binary),
                     fmt::join(overrides, " and "),
                     overrides.size() == 1 ? "overrides" : "override");
}

std::string histogram_warning(const BinaryImage& binary, const BinariseOptions& options) {
  if (binary.only_level) {
    const char* const what =
        binary.foreground_share > 0 ? "all of them are foreground" : "none is foreground";
    return fmt::format("all pixels have the same grey level, {:.9g}: {}",
                       binary.number_of(*binary.only_level), what);
  }
  const bool is_clear =
      binary.separation >= kMinSeparation || binary.undecided_share <= kMaxUndecided;
  if (options.threshold || options.local || is_clear) return {};
  return fmt::format(
      "the two classes overlap: {:.1f} % of the pixels are near the threshold; check the result, "
      "or "
      "try --threshold local, --channel auto, --blur 1 or --threshold N",
      100 * binary.undecided_share);
}

std::string share_warning(const BinaryImage& binary, const BinariseOptions& options) {
  const bool is_usual = binary.foreground_share <= 0.5 || options.is_mostly_foreground;
  if (binary.only_level || is_usual) return {};
  return fmt::format("{:.1f} % of the image is foreground; {} takes the rest instead",
                     100 * binary.foreground_share, opposite(binary));
}

void print_line(const char* kind, const std::string& name, const std::string& text,
                std::ostream& log) {
  if (!text.empty()) log << kind << one_line(name) << ": " << text << '\n';
}

}  // namespace

namespace {

/// The level from which on the numbers of the file are at least `number`.
int level_of(double number, const GreyImage& grey) {
  if (grey.boundary) return *grey.boundary;
  const double level = std::ceil(number);
  if (level <= grey.highest()) return static_cast<int>(std::max(level, 0.0));
  throw std::invalid_argument(
      fmt::format("--threshold: expected up to {}, the highest grey level, got {:.9g}",
                  grey.highest(), number));
}

/// In levels.
Binarisation request_for(const GreyImage& grey, const BinariseOptions& options) {
  Binarisation request = {options.foreground, std::nullopt, options.local};
  if (options.threshold) request.threshold = level_of(*options.threshold, grey);
  if (request.local && options.offset) {
    constexpr int most = 65535;  // which 8 bits reject
    const double offset = std::round(*options.offset / grey.step);
    request.local->offset = static_cast<int>(std::min<double>(offset, most));
  }
  return request;
}

/// For a threshold above all levels of 8 bits.
void widen(GreyImage& grey) {
  grey.deep =
      detail::make_uninitialised<std::uint16_t>(static_cast<std::size_t>(grey.width * grey.height));
  for (Index y = 0; y < grey.height; ++y)
    std::copy_n(grey.bytes.view().row(y), grey.width, grey.deep_view().row(y));
}

std::string range_text(const GreyImage& grey, const LevelRange& range) {
  const auto number = [&](int level) { return grey.first + grey.step * level; };
  return fmt::format("16 bits, levels {:.9g} to {:.9g}", number(range.lowest),
                     number(range.highest));
}

}  // namespace

BinaryImage binarise(GreyImage grey, const BinariseOptions& options) {
  if (grey.boundary > grey.highest()) widen(grey);
  const LevelRange range = grey.is_deep() ? range_of(grey) : LevelRange{0, 255};
  const Binarisation request = request_for(grey, options);
  BinaryImage result;
  result.first = grey.first;
  result.step = grey.step;
  result.given = options.threshold;
  if (grey.is_deep()) {
    ByteImage image(grey.width, grey.height);
    static_cast<Binarised&>(result) = binarise16(grey.deep_view(), image.view(), request);
    result.image = std::move(image);
    result.range = range_text(grey, range);
  } else {
    static_cast<Binarised&>(result) = binarise(grey.bytes.view(), grey.bytes.view(), request);
    result.image = std::move(grey.bytes);
  }
  return result;
}

BinaryImage binarise(ByteImage grey, const BinariseOptions& options) {
  return binarise(GreyImage(std::move(grey)), options);
}

namespace {

/// The number of set bits, by operations that compilers vectorise on any processor.
Index bits_of(std::uint64_t word) {
  word -= word >> 1 & 0x5555555555555555;
  word = (word & 0x3333333333333333) + (word >> 2 & 0x3333333333333333);
  word = (word + (word >> 4)) & 0x0F0F0F0F0F0F0F0F;
  word += word >> 8;
  word += word >> 16;
  word += word >> 32;
  return static_cast<Index>(word & 0x7F);
}

}  // namespace

Index packed_foreground(const ConstPackedView& image) {
  const Index bytes = packed_row_bytes(image.width);
  Index count = 0;
  for (Index y = 0; y < image.height; ++y) {
    const std::uint8_t* row = image.row(y);
    Index i = 0;
    for (; i + 8 <= bytes; i += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, row + i, sizeof(word));
      count += bits_of(word);
    }
    for (; i < bytes; ++i) count += bits_of(row[i]);
  }
  return count;
}

void add_rows(BrightPixels& count, const ConstPackedView& rows, Index y, Index height) {
  count.bright += packed_foreground(rows);
  count.all += rows.width * rows.height;
  for (Index i = 0; i < rows.height; ++i) {
    const bool whole_row = y + i == 0 || y + i == height - 1;
    const std::uint8_t* const row = rows.row(i);
    const auto pixel = [&](Index x) { return row[x / 8] >> (7 - x % 8) & 1; };
    count.all_on_border += whole_row ? rows.width : std::min<Index>(rows.width, 2);
    count.bright_on_border += whole_row ? packed_foreground({row, rows.width, 1, rows.order})
                                        : pixel(0) + (rows.width > 1 ? pixel(rows.width - 1) : 0);
  }
}

BinaryImage binarise_packed(const BrightPixels& count, const BinariseOptions& options) {
  BinaryImage result;
  result.foreground = detail::foreground_of(count, options.foreground);
  result.threshold = 1;
  result.foreground_share = detail::foreground_share(count, result.foreground);
  result.separation = 1;
  result.was_binary = true;
  if (count.bright == 0) result.only_level = 0;
  if (count.bright == count.all) result.only_level = 255;
  return result;
}

std::string class_text(const BinaryImage& binary) {
  const std::string_view name = foreground_name(binary.foreground);
  if (binary.window > 0) {
    return fmt::format("{} (by the means of {} x {} pixels)", name, binary.window, binary.window);
  }
  const char* const relation = binary.foreground == Foreground::bright ? ">=" : "<";
  return fmt::format("{} (grey level {} {:.9g})", name, relation, binary.number());
}

std::vector<std::string> warnings(const BinaryImage& binary, const BinariseOptions& options) {
  std::vector<std::string> texts = {histogram_warning(binary, options),
                                    share_warning(binary, options)};
  std::erase(texts, "");
  return texts;
}

void print_remarks(const std::string& name, const BinaryImage& binary,
                   const BinariseOptions& options, std::ostream& log) {
  print_line("note: ", name, note(binary, options), log);
  for (const std::string& text : warnings(binary, options))
    print_line("warning: ", name, text, log);
}

GreyFile read_grey_file(FileBytes file, int page, const BinariseOptions& options) {
  Pixels pixels = decode(file, {.page = page, .lenient = options.lenient});
  const std::string name = file.name();
  file = {};
  GreyFile result = {{}, options.grey.channel, {}};
  std::string decoder_warning = std::move(pixels.warning);
  try {
    GreyChoice choice = options.grey;
    choice.threshold = options.threshold;
    result.grey = grey_of(std::move(pixels), choice, result.channel, result.warning);
  } catch (const DecodeError& error) {
    throw FileError((name == kStandardStream ? "standard input" : name) + ": " + error.what());
  } catch (const std::bad_alloc&) {
    cannot_read(name, "there is not enough memory for it");
  }
  const bool has_both = !decoder_warning.empty() && !result.warning.empty();
  result.warning = decoder_warning + (has_both ? "; " : "") + result.warning;
  return result;
}

GreyImage read_levels(FileBytes file, const BinariseOptions& options, std::ostream& log) {
  const std::string name = file.name();
  GreyFile read = read_grey_file(std::move(file), 0, options);
  print_line("warning: ", name, read.warning, log);
  if (options.grey.channel == Channel::automatic && !options.grey.opacity) {
    const std::string_view channel = channel_name(read.channel);
    print_line("note: ", name, fmt::format("channel is {}; --channel overrides this", channel),
               log);
  }
  return std::move(read.grey);
}

ByteImage read_grey(const std::string& path, const BinariseOptions& options, std::ostream& log) {
  return in_bytes(read_levels(read_input(path), options, log)).bytes;
}

ByteImage read_binary(FileBytes file, const BinariseOptions& options, std::ostream& log) {
  const std::string name = file.name();
  BinaryImage binary = binarise(read_levels(std::move(file), options, log), options);
  print_remarks(name, binary, options, log);
  return std::move(binary.image);
}

ByteImage read_binary(const std::string& path, const BinariseOptions& options, std::ostream* log) {
  std::ostringstream ignored;
  return read_binary(read_input(path), options, log != nullptr ? *log : ignored);
}

Index foreground_pixels(ConstImageView image) {
  Index count = 0;
  for (Index y = 0; y < image.height; ++y) {
    const std::uint8_t* const row = image.row(y);
    for (Index x = 0; x < image.width; ++x) count += row[x] != 0 ? 1 : 0;
  }
  return count;
}

}  // namespace thinbench
