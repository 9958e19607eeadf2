// Image files of any format: an image, or one line that says why there is none.
#include "byte_source.hpp"
#include "images/binarise.hpp"
#include "images/image_file.hpp"

namespace thinbench {
namespace {

FileBytes file_of(std::span<const std::uint8_t> bytes) {
  return {"input", {reinterpret_cast<const char*>(bytes.data()), bytes.size()}};
}

/// An image with pixels, or an error of the reader.
void read_page(std::span<const std::uint8_t> bytes, int page, const BinariseOptions& options) {
  must_succeed_or_explain<FileError>([&] {
    const GreyFile file = read_grey_file(file_of(bytes), page, options);
    must(file.grey.width > 0 && file.grey.height > 0, "an image without pixels");
  });
}

}  // namespace

void try_input(ByteSource& input) {
  const auto bytes = input.take(SIZE_MAX);
  read_page(bytes, 0, {});
  read_page(bytes, 0, {.lenient = true, .grey = {.opacity = true}});
  read_page(bytes, 0, {.grey = {.channel = Channel::automatic, .backdrop = Backdrop::white}});
  must_succeed_or_explain<FileError>([&] { static_cast<void>(read_labels(file_of(bytes))); });
  read_page(bytes, 0, {.threshold = 0.5});
  const std::vector<int> pages = pages_in(file_of(bytes));
  must(!pages.empty(), "no pages");
  if (pages.back() > 0) read_page(bytes, pages.back(), {});
}

}  // namespace thinbench
