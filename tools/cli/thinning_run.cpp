#include "cli/thinning_run.hpp"

#include <sstream>

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "images/image_file.hpp"
#include "support/text.hpp"
#include "support/timing.hpp"
#include "thinbench/packed.hpp"

namespace thinbench {
namespace {

Index foreground_of(const ImageView& image) {
  return foreground_pixels(image);
}

/// Of the last byte of each row.
void clear_unused_bits(const PackedView& image) {
  const Index bytes = packed_row_bytes(image.width);
  const int unused = static_cast<int>(bytes * 8 - image.width);
  const int used = image.order == BitOrder::msb_first ? 0xFF << unused : 0xFF >> unused;
  for (Index y = 0; y < image.height; ++y) {
    std::uint8_t& last = image.data[y * image.stride + bytes - 1];
    last = static_cast<std::uint8_t>(last & used);
  }
}

Index foreground_of(const PackedView& image) {
  return packed_foreground(image);
}

/// `apply` works in place and returns the number of iterations.
template <class View, class Apply>
std::string summary_of(std::string_view name, const View& image, const Apply& apply) {
  const Index before = foreground_of(image);
  int iterations = 0;
  const double milliseconds = milliseconds_of([&] { iterations = apply(image); });
  return fmt::format("{}: {} x {}, {}, {} before, {} after, {:.3f} ms", name, image.width,
                     image.height, counted(iterations, "iteration"),
                     counted(before, "foreground pixel"), foreground_of(image), milliseconds);
}

}  // namespace

int run_image(std::string_view name, const std::function<int(const ImageView&)>& apply,
              FileBytes in, const std::string& out, const BinariseOptions& binarise,
              const Console& console) {
  check_extension(out);
  std::ostringstream remarks;  // failures are one line, without them
  ByteImage image = read_binary(std::move(in), binarise, remarks);
  const std::string summary = summary_of(name, image.view(), apply);
  write_grey(out, image.view());
  console.err << remarks.str();
  summary_stream(console, out) << summary << '\n';
  return kSuccess;
}

std::string thin_packed_image(const RequestedThinning& thinning, const PackedView& image,
                              const std::function<void()>& save) {
  std::string summary = summary_of(thinning.name, image, [&](const PackedView& view) {
    return thin_packed(thinning.rule, view, view, thinning.thinning, thinning.execution);
  });
  save();
  return summary;
}

std::string thin_packed_file(const RequestedThinning& thinning, FileBytes in,
                             const std::string& out, const PackedFormat& format) {
  if (in.text().size() != format.file_bytes()) {
    cannot_read(in.name(),
                fmt::format("it has {} bytes; {}{} x {} pixels take {}", in.text().size(),
                            format.header_bytes == 0 ? "" : "its header and ", format.width,
                            format.height, format.file_bytes()));
  }
  auto* const data = reinterpret_cast<std::uint8_t*>(in.data() + format.header_bytes);
  const PackedView image(data, format.width, format.height, format.order);
  clear_unused_bits(image);
  return thin_packed_image(thinning, image, [&] { write_bytes(out, in.text()); });
}

void reject_for_packed_files(const Options& options) {
  const std::string words = given_words(options);
  if (words.empty()) return;
  throw UsageError(words.substr(1, words.find(' ', 1) - 1) +
                   " does not apply to packed files, whose pixels have one bit");
}

}  // namespace thinbench
