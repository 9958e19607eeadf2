#include "cli/packed_tiff.hpp"

#include <memory>
#include <sstream>

#include "images/image_file.hpp"
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

}  // namespace

bool is_tiff_run(const PackedOptions& options, const BinariseOptions& binarise,
                 const ThinningFiles& files) {
  const std::string extension = extension_of(files.out);
  if (!options.raw.empty() || (extension != ".tif" && extension != ".tiff")) return false;
  const bool has_levels =
      binarise.threshold || binarise.local || binarise.blur > 0 || binarise.crop.height > 0;
  return !has_levels && is_bilevel_tiff(files.in);
}

int run_tiff(const RequestedThinning& thinning, const BinariseOptions& binarise,
             const ThinningFiles& files, const Console& console) {
  check_target(files.out);
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

}  // namespace thinbench
