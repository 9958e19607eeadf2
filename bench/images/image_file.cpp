#include "images/image_file.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <string_view>
#include <system_error>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "images/captured_stderr.hpp"
#include "images/mat_of.hpp"
#include "images/pnm_file.hpp"
#include "images/tiff_file.hpp"
#include "support/regular_file.hpp"
#include "support/text.hpp"

namespace thinbench {
namespace {

[[noreturn]] void cannot_read(const std::string& path, const std::string& why) {
  throw ImageError("cannot read '" + path + "': " + why);
}

/// OpenCV reads its limit when it is loaded, before any code of ours could raise it.
std::string too_many_pixels() {
  constexpr const char* variable = "OPENCV_IO_MAX_IMAGE_PIXELS";
  const char* limit = std::getenv(variable);
  if (limit == nullptr) {
    return std::string("it has more than 2^30 pixels; set ") + variable +
           "=2147483648 in the environment to read up to 2^31";
  }
  return std::string("it has more pixels than ") + variable + "=" + limit +
         " allows; at most 2^31 = 2147483648 can be read";
}

bool is_tiff(const std::string& path) {
  const std::string bytes = beginning_of(path, 4);
  using namespace std::string_view_literals;  // the last two are those of BigTIFF
  const std::array marks = {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv};
  return std::find(marks.begin(), marks.end(), bytes) != marks.end();
}

/// The decoder gave up without a reason.
[[noreturn]] void cannot_decode(const std::string& path) {
  const std::string why = is_tiff(path) ? unreadable_tiff_reason(path) : "";
  if (!why.empty()) cannot_read(path, why);
  if (!cv::haveImageReader(path)) cannot_read(path, "it is not an image of a known format");
  cannot_read(path, "it is damaged or has no pixels");
}

/// A rejection by OpenCV in the words of this program.
[[noreturn]] void cannot_read(const std::string& path, const cv::Exception& error) {
  const auto mentions = [&](const char* text) { return error.err.find(text) != std::string::npos; };
  if (mentions("CV_IO_MAX_IMAGE_PIXELS")) cannot_read(path, too_many_pixels());
  if (mentions("CV_IO_MAX_IMAGE")) cannot_read(path, "it is wider or higher than 2^20 pixels");
  if (error.code == cv::Error::StsNoMem) cannot_read(path, "there is not enough memory for it");
  cannot_decode(path);
}

/// What the decoder of a JPEG file warned of first; empty if nothing. It fills up what is missing.
std::string jpeg_warning(const std::string& path, const std::string& said) {
  if (said.empty() || beginning_of(path, 2) != "\xFF\xD8") return {};
  if (said.starts_with("Premature end of JPEG file")) return "the file is truncated";
  return "its decoder says: " + one_line(said.substr(0, said.find('\n')));
}

cv::Mat first_page(const std::string& path) {
  return is_pnm(path) ? read_pnm(path) : cv::imread(path, cv::IMREAD_GRAYSCALE);
}

cv::Mat one_page(const std::string& path, int page) {
  std::vector<cv::Mat> pages;
  cv::imreadmulti(path, pages, page, 1, cv::IMREAD_GRAYSCALE);
  return pages.empty() ? cv::Mat() : pages.front();
}

template <class Decode>
cv::Mat decoded(const std::string& path, const Decode& decode, std::string* warning) {
  const CapturedStderr captured;
  cv::Mat image = decode();
  if (image.empty()) cannot_decode(path);
  const std::string found = jpeg_warning(path, captured.text());
  if (!found.empty() && warning == nullptr) cannot_read(path, found);
  if (warning != nullptr) *warning = found;
  return image;
}

template <class Decode>
ByteImage read_by(const std::string& path, const Decode& decode, std::string* warning) {
  check_file(path);
  try {
    const cv::Mat image = decoded(path, decode, warning);
    if (image.total() > static_cast<std::size_t>(kMaxImagePixels)) {
      cannot_read(path, "it has more than 2^31 pixels");
    }
    return copy_of({image.data, image.cols, image.rows, static_cast<Index>(image.step[0])});
  } catch (const cv::Exception& error) {
    cannot_read(path, error);
  } catch (const FileError& error) {
    throw ImageError(error.what());
  } catch (const std::bad_alloc&) {
    cannot_read(path, "there is not enough memory for it");
  }
}

}  // namespace

void check_file(const std::string& path) {
  try {
    if (regular_file_bytes(path) == 0) cannot_read(path, "the file is empty");
  } catch (const FileError& error) {
    throw ImageError(error.what());
  }
}

ByteImage read_grey(const std::string& path, std::string* warning) {
  return read_by(
      path, [&] { return first_page(path); }, warning);
}

int page_count(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored) || !is_tiff(path)) return 1;
  const CapturedStderr captured;
  try {
    return std::max(1, static_cast<int>(cv::imcount(path, cv::IMREAD_GRAYSCALE)));
  } catch (const cv::Exception&) {
    return 1;  // reading it gives the reason
  }
}

ByteImage read_grey_page(const std::string& path, int page) {
  return read_by(
      path, [&] { return one_page(path, page); }, nullptr);
}

namespace {

constexpr std::array<std::string_view, 5> kExtensions = {".png", ".pgm", ".bmp", ".tif", ".tiff"};
constexpr const char* kKnownExtensions = ".png, .pgm, .bmp, .tif and .tiff";

[[noreturn]] void cannot_write(const std::string& path, const std::string& why) {
  throw ImageError("cannot write '" + path + "': " + why);
}

std::vector<std::uint8_t> encoded(const std::string& path, const cv::Mat& image) {
  const CapturedStderr captured;
  std::vector<std::uint8_t> bytes;
  if (!cv::imencode(extension_of(path), image, bytes)) {
    cannot_write(path, "the image cannot be encoded");
  }
  return bytes;
}

}  // namespace

void check_extension(const std::string& path) {
  const std::string extension = extension_of(path);
  if (std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end()) return;
  const std::string what = extension.empty() ? "its name has no extension"
                           : extension == ".jpg" || extension == ".jpeg"
                               ? "JPEG would change pixels"
                               : "unknown extension '" + extension + "'";
  cannot_write(path, what + "; known are " + kKnownExtensions);
}

void check_colour_extension(const std::string& path) {
  check_extension(path);
  if (extension_of(path) == ".pgm") cannot_write(path, "PGM holds no colours");
}

namespace {

/// Does what writes a file, with its failures as ImageError.
template <class Write>
void write_by(const std::string& path, const Write& write) {
  try {
    write();
  } catch (const FileError& error) {
    throw ImageError(error.what());
  } catch (const ImageError&) {
    throw;
  } catch (const std::exception&) {  // OpenCV's own, or memory is short
    cannot_write(path, "the image cannot be encoded");
  }
}

void check_writable(const std::string& path, const ConstImageView& image) {
  try {
    check_target(path);
  } catch (const FileError& error) {
    throw ImageError(error.what());
  }
  if (image.width == 0 || image.height == 0) cannot_write(path, "the image has no pixels");
  if (!is_writable_size(image.width, image.height)) {
    cannot_write(path, "the image has 2^31 pixels or more");
  }
}

}  // namespace

void write_mat(const std::string& path, const cv::Mat& image) {
  write_by(path, [&] {
    const std::vector<std::uint8_t> bytes = encoded(path, image);
    write_whole_file(path,
                     std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  });
}

void write_grey(const std::string& path, const ConstImageView& image) {
  check_extension(path);
  check_writable(path, image);
  write_mat(path, mat_of(image));
}

void write_binary(const std::string& path, const ConstImageView& image) {
  if (extension_of(path) != ".pbm") check_extension(path);
  check_writable(path, image);
  write_mat(path, mat_of(image));
}

void write_grey_pages(const std::string& path, const std::vector<ByteImage>& pages) {
  std::vector<cv::Mat> mats;
  for (const ByteImage& page : pages) {
    check_writable(path, page.view());
    mats.push_back(mat_of(page.view()));
  }
  write_by(path, [&] {
    write_whole_file(path, [&](const std::string& name) {
      const CapturedStderr captured;
      const bool is_written = cv::imwritemulti(name, mats);
      // A full disk is no failure to the encoder.
      if (!is_written || page_count(name) != static_cast<int>(mats.size())) {
        cannot_write(path, "the pages cannot be encoded, or the disk is full");
      }
    });
  });
}

OneThreadPerImage::OneThreadPerImage() : threads_(cv::getNumThreads()) {
  cv::setNumThreads(1);
}

OneThreadPerImage::~OneThreadPerImage() {
  cv::setNumThreads(threads_);
}

}  // namespace thinbench
