#include "cli/packed_tiff.hpp"

#include <algorithm>
#include <memory>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "images/image_file.hpp"
#include "images/packed_file.hpp"
#include "images/tiff_file.hpp"
#include "support/text.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

constexpr BitOrder kOrder = BitOrder::msb_first;

BinaryImage binarised(const BrightPixels& count, const BinariseOptions& options,
                      const std::string& in, std::ostream& remarks) {
  BinaryImage binary = binarise_packed(count, options);
  print_remarks(in, binary, options, remarks);
  return binary;
}

int run_in_memory(const RequestedThinning& thinning, const BinariseOptions& binarise,
                  const ThinningFiles& files, const Console& console) {
  TiffReader reader(files.in);
  const TiffFormat format = reader.format();
  // Not initialised: memory is taken as rows are read, so that a damaged file takes little.
  const auto bytes = std::make_unique_for_overwrite<std::uint8_t[]>(
      static_cast<std::size_t>(format.row_bytes() * format.height));
  const PackedView image(bytes.get(), format.width, format.height, kOrder);
  reader.read(format.height, image.data);
  BrightPixels count;
  add_rows(count, image, 0, format.height);
  std::ostringstream remarks;  // failures are one line, without them
  if (binarised(count, binarise, files.in, remarks).foreground == Foreground::dark) invert(image);
  const auto save = [&] {
    write_whole_file(files.out, [&](const std::string& name) {
      TiffWriter writer(name, files.out, format);
      writer.write(format.height, image.data);
      writer.finish();
    });
    console.err << remarks.str();
  };
  console.out << thin_packed_image(thinning, image, save) << '\n';
  return kSuccess;
}

/// Reads all rows, so that damage is found before the work.
BrightPixels bright_pixels_of(const std::string& in, Index height) {
  BrightPixels count;
  read_tiff(in, [&](const PackedView& rows, Index y) { add_rows(count, rows, y, height); });
  return count;
}

void unpack(const std::string& in, Foreground foreground, const PackedFile& to) {
  read_tiff(in, [&](const PackedView& rows, Index y) {
    if (foreground == Foreground::dark) invert(rows);
    to.write({0, y, rows.width, rows.height}, rows.data, rows.stride);
  });
}

void pack(const PackedFile& from, const TiffFormat& format, const std::string& name,
          const std::string& out) {
  TiffWriter writer(name, out, format);
  const Index part = format.part_rows();
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(part * format.row_bytes()));
  for (Index y = 0; y < format.height; y += part) {
    const Index rows = std::min(part, format.height - y);
    from.read({0, y, format.width, rows}, bytes.data());
    writer.write(rows, bytes.data());
  }
  writer.finish();
}

/// While a file is read, tiles have their memory already: a quarter of all.
void check_memory(const TiffReader& reader, const std::string& in, Index memory) {
  if (reader.working_bytes() <= memory / 4 * 3) return;
  throw FileError(
      fmt::format("cannot read '{}': reading it takes {:.1f} MB, more than --memory allows", in,
                  static_cast<double>(reader.working_bytes()) / 1e6));
}

int run_out_of_core(const PackedOptions& options, const RequestedThinning& thinning,
                    const BinariseOptions& binarise, const ThinningFiles& files,
                    const Console& console) {
  BinariseOptions levels = binarise;
  levels.foreground = Foreground::automatic;
  reject_for_packed_files(levels);
  check_file(files.in);
  if (!is_tiff(files.in)) cannot_read(files.in, "it is not a TIFF file, as OUT requires");
  TiffFormat format;
  {
    const TiffReader reader(files.in);
    check_memory(reader, files.in, memory_of(options));
    format = reader.format();
  }
  std::ostringstream remarks;
  const BrightPixels count = bright_pixels_of(files.in, format.height);
  const Foreground foreground = binarised(count, binarise, files.in, remarks).foreground;
  Conversion conversion;
  conversion.unpack = [&](const PackedFile& to) { unpack(files.in, foreground, to); };
  conversion.pack = [&](const PackedFile& from, const std::string& name) {
    pack(from, format, name, files.out);
  };
  conversion.name = fmt::format(", {}", foreground_name(foreground));
  const PackedFiles packed = {
      files.in, files.out, {format.width, format.height, kOrder}, conversion};
  const int status = thin_out_of_core(options, thinning, packed, console);
  console.err << remarks.str();
  return status;
}

}  // namespace

bool is_tiff_run(const PackedOptions& options, const BinariseOptions& binarise,
                 const ThinningFiles& files) {
  const std::string extension = extension_of(files.out);
  if (!options.raw.empty() || (extension != ".tif" && extension != ".tiff")) return false;
  const bool has_levels =
      binarise.threshold || binarise.local || binarise.blur > 0 || binarise.crop.height > 0;
  return options.out_of_core || (!has_levels && is_bilevel_tiff(files.in));
}

int run_tiff(const PackedOptions& options, const RequestedThinning& thinning,
             const BinariseOptions& binarise, const ThinningFiles& files, const Console& console) {
  check_target(files.out);
  if (!options.out_of_core) return run_in_memory(thinning, binarise, files, console);
  return run_out_of_core(options, thinning, binarise, files, console);
}

}  // namespace thinbench
