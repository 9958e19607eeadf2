#include "cli/packed_tiff.hpp"

#include <sstream>

#include "images/image_file.hpp"
#include "support/text.hpp"
#include "support/whole_file.hpp"

namespace thinbench {

std::optional<PackedPage> packed_tiff(const PackedOptions& options, const BinariseOptions& binarise,
                                      const FileBytes& in, const std::string& out) {
  if (!options.raw.empty() || !is_tiff_extension(extension_of(out))) return std::nullopt;
  const bool has_levels = binarise.threshold || binarise.local || binarise.grey.blur > 0 ||
                          binarise.grey.crop.height > 0 || binarise.grey.opacity ||
                          binarise.lenient;
  return has_levels ? std::nullopt : decode_packed_tiff(in);
}

int run_tiff(const RequestedThinning& thinning, const BinariseOptions& binarise, PackedPage page,
             const ThinningFiles& files, const Console& console) {
  check_target(files.out);
  const Pixels& pixels = page.pixels;
  const PackedView image(pixels.bytes.get(), pixels.width, pixels.height, BitOrder::msb_first);
  BrightPixels count;
  add_rows(count, image, 0, image.height);
  std::ostringstream remarks;  // failures are one line, without them
  const BinaryImage binary = binarise_packed(count, binarise);
  print_remarks(files.in, binary, binarise, remarks);
  if (binary.foreground == Foreground::dark) invert(image);
  const auto save = [&] {
    const Samples samples = {image.data,   image.width, image.height,
                             image.stride, 1,           SampleKind::bit};
    write_bytes(files.out, encode_tiff({&samples, 1}, page.format));
    console.err << remarks.str();
  };
  console.out << thin_packed_image(thinning, image, save) << '\n';
  return kSuccess;
}

}  // namespace thinbench
