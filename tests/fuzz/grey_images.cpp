// Image files of any format: an image, or one line that says why there is none.
#include "images/image_file.hpp"
#include "memory_file.hpp"

namespace thinbench {
namespace {

/// What `read` throws must be an error of the reader with one line.
template <class Read>
void must_read_or_explain(const Read& read) {
  try {
    const ByteImage image = read();
    must(image.width() > 0 && image.height() > 0, "an image without pixels");
  } catch (const FileError& error) {
    must_be_one_line(error.what());
  }
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
}  // namespace thinbench

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const thinbench::MemoryFile file;
  file.hold({data, size});
  thinbench::read_all(file.path());
  return 0;
}
