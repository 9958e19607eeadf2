// Image files of any format: an image, or one line that says why there is none.
#include "images/image_file.hpp"
#include "memory_file.hpp"

namespace thinbench {
namespace {

/// An image with pixels, or an error of the reader.
template <class Read>
void must_read_or_explain(const Read& read) {
  must_succeed_or_explain<FileError>([&] {
    const ByteImage image = read();
    must(image.width() > 0 && image.height() > 0, "an image without pixels");
  });
}

void read_all(const std::string& path) {
  std::string warning;
  must_read_or_explain([&] { return read_grey(path); });
  must_read_or_explain([&] { return read_grey(path, &warning); });
  const int pages = page_count(path);
  must(pages >= 1, "no pages");
  if (pages > 1) must_read_or_explain([&] { return read_grey_page(path, pages - 1); });
}

}  // namespace

void try_input(ByteSource& input) {
  static const MemoryFile file;
  file.hold(input.take(SIZE_MAX));
  read_all(file.path());
}

}  // namespace thinbench
