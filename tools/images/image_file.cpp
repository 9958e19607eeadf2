#include "images/image_file.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <new>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "images/captured_stderr.hpp"
#include "images/image_header.hpp"
#include "images/mat_of.hpp"
#include "images/pnm_file.hpp"
#include "images/tiff_file.hpp"
#include "support/regular_file.hpp"
#include "support/text.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

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

/// The decoder gave up without a reason.
[[noreturn]] void cannot_decode(const std::string& path) {
  const std::string why = is_tiff(path) ? unreadable_tiff_reason(path) : "";
  if (!why.empty()) cannot_read(path, why);
  cannot_read(path, "it is damaged or has no pixels");
}

/// A rejection by OpenCV in the words of this program.
[[noreturn]] void reject(const std::string& path, const cv::Exception& error) {
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

/// Decoders say so, or throw, and OpenCV catches what is not its own without saying what it was.
bool is_out_of_memory(const std::string& said) {
  return said.find("memory") != std::string::npos ||
         said.find("can't read data: unknown exception") != std::string::npos;
}

/// 8 bits, grey levels upright, colours in three channels: decoders would each weight them in their
/// own way.
constexpr int kLevelsOrColours = cv::IMREAD_ANYCOLOR;

cv::Mat first_page(const std::string& path) {
  return is_pnm(path) ? read_pnm(path) : cv::imread(path, kLevelsOrColours);
}

cv::Mat one_page(const std::string& path, int page) {
  std::vector<cv::Mat> pages;
  cv::imreadmulti(path, pages, page, 1, kLevelsOrColours);
  return pages.empty() ? cv::Mat() : pages.front();
}

template <class Decode>
cv::Mat decoded(const std::string& path, const Decode& decode, std::string* warning) {
  const CapturedStderr captured;
  cv::Mat image = decode();
  if (image.empty() && is_out_of_memory(captured.text())) throw std::bad_alloc();
  if (image.empty()) cannot_decode(path);
  const std::string found = jpeg_warning(path, captured.text());
  if (!found.empty() && warning == nullptr) cannot_read(path, found);
  if (warning != nullptr) *warning = found;
  if (image.total() > static_cast<std::size_t>(kMaxImagePixels)) {
    cannot_read(path, "it has more than 2^31 pixels");
  }
  return image;
}

/// What `read()` makes of a file that exists; exceptions as FileError.
template <class Read>
auto guarded_read(const std::string& path, int page, const Read& read) {
  check_file(path);
  try {
    check_header(path, page);
    return read();
  } catch (const cv::Exception& error) {
    reject(path, error);
  } catch (const std::bad_alloc&) {
    cannot_read(path, "there is not enough memory for it");
  }
}

/// The image itself, not a copy.
ByteImage image_of(const cv::Mat& mat) {
  const ImageView pixels(mat.data, mat.cols, mat.rows, static_cast<Index>(mat.step[0]));
  return {pixels, [mat](void*) {}};  // the last reference frees it
}

/// The channel of a decoded image, and which it is.
ByteImage channel_of(cv::Mat image, Channel& channel) {
  if (image.channels() == 1) {
    channel = Channel::grey;
    return image_of(image);
  }
  for (int y = 0; y < image.rows; ++y) {  // OpenCV copies what it converts in place
    cv::Mat row = image.row(y);
    cv::cvtColor(row, row, cv::COLOR_BGR2RGB);
  }
  cv::Mat levels(image.size(), CV_8UC1);
  const ImageView to(levels.data, levels.cols, levels.rows, static_cast<Index>(levels.step[0]));
  channel = select_channel({image.data, image.cols, image.rows, static_cast<Index>(image.step[0])},
                           to, channel);
  return image_of(levels);
}

}  // namespace

void check_file(const std::string& path) {
  if (regular_file_bytes(path) == 0) cannot_read(path, "the file is empty");
}

void read_standard_input(const std::function<void(const std::string& copy)>& read) {
  const std::string copy = path_of_standard_input();
  try {
    read(copy);
  } catch (const FileError& error) {
    std::string text = error.what();
    const std::size_t at = text.find(copy);
    if (at != std::string::npos) text.replace(at - 1, copy.size() + 2, "standard input");
    throw FileError(text);
  }
}

ByteImage read_grey(const std::string& path, std::string* warning) {
  Channel grey = Channel::grey;
  return read_channel(path, std::nullopt, grey, warning);
}

/// Grey levels of 8 or 16 bits, upright; colours remain colours.
constexpr int kAsStored = cv::IMREAD_ANYDEPTH | cv::IMREAD_ANYCOLOR;

LabelPixels read_labels(const std::string& path) {
  if (path == kStandardStream) {
    LabelPixels labels;
    read_standard_input([&](const std::string& copy) { labels = read_labels(copy); });
    return labels;
  }
  return guarded_read(path, 0, [&] {
    check_label_levels(path);
    const auto decode = [&] { return cv::imread(path, kAsStored); };
    cv::Mat image = decoded(path, decode, nullptr);
    const bool is_deep = image.depth() == CV_16U;
    if (image.channels() != 1 || (!is_deep && image.depth() != CV_8U)) {
      const bool is_signed = image.depth() == CV_8S || image.depth() == CV_16S;
      cannot_read(path, fmt::format("labels are one channel of 8 or 16 bits, and it has {} of {}{}",
                                    image.channels(), 8 * image.elemSize1(),
                                    is_signed ? " with signs" : ""));
    }
    image.convertTo(image, CV_32S);
    return LabelPixels{
        image.cols, image.rows,
        std::vector<std::int32_t>(image.begin<std::int32_t>(), image.end<std::int32_t>())};
  });
}

ByteImage read_channel(const std::string& path, std::optional<int> page, Channel& channel,
                       std::string* warning) {
  if (path == kStandardStream) {
    ByteImage image;
    read_standard_input([&](const std::string& copy) {
      image = read_channel(copy, std::nullopt, channel, warning);
    });
    return image;
  }
  return guarded_read(path, page.value_or(0), [&] {
    const auto decode = [&] { return page ? one_page(path, *page) : first_page(path); };
    return channel_of(decoded(path, decode, warning), channel);
  });
}

namespace {

bool has_pixel_below_opaque(const cv::Mat& image) {
  cv::Mat alpha;
  cv::extractChannel(image, alpha, 3);
  double min = 0;
  cv::minMaxLoc(alpha, &min);
  return min < (image.depth() == CV_8U ? 255 : 65535);
}

}  // namespace

bool is_transparent(const std::string& path) {
  const std::string file = path == kStandardStream ? path_of_standard_input() : path;
  const std::optional<TransparentColour> colour = png_transparency(file);
  if (!colour) return false;
  const CapturedStderr captured;
  try {
    const cv::Mat image = cv::imread(file, cv::IMREAD_UNCHANGED);
    if (image.channels() == 4) return has_pixel_below_opaque(image);
    if (image.channels() != static_cast<int>(colour->size())) return false;
    cv::Mat is_colour;
    cv::inRange(image, *colour, *colour, is_colour);
    return cv::countNonZero(is_colour) > 0;
  } catch (const cv::Exception& error) {
    reject(path, error);
  }
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
  Channel grey = Channel::grey;
  return read_channel(path, page, grey);
}

namespace {

/// Throws ExtensionError unless the file has one of these extensions.
void check_among(const std::string& path, std::initializer_list<std::string_view> known) {
  if (path == kStandardStream) return;
  const std::string extension = extension_of(path);
  if (std::ranges::find(known, extension) != known.end()) return;
  const std::string why = extension.empty()     ? "its name has no extension"
                          : extension == ".bmp" ? "BMP holds no 16 bits"
                          : extension == ".pgm" ? "PGM holds no colours"
                          : extension == ".jpg" || extension == ".jpeg"
                              ? "JPEG would change pixels"
                              : "unknown extension '" + extension + "'";
  throw ExtensionError(fmt::format("cannot write '{}': {}; known are {} and {}", path, why,
                                   fmt::join(known.begin(), known.end() - 1, ", "),
                                   *(known.end() - 1)));
}

std::vector<std::uint8_t> encoded(const std::string& path, const cv::Mat& image) {
  constexpr int max_png_side = 1'000'000;
  if (extension_of(path) == ".png" && std::max(image.cols, image.rows) > max_png_side) {
    cannot_write(path, "PNG has sides of at most 10^6 pixels; .tif and .pgm have no such limit");
  }
  const CapturedStderr captured;
  std::vector<std::uint8_t> bytes;
  try {
    if (cv::imencode(extension_of(path), image, bytes)) return bytes;
  } catch (const cv::Exception&) {  // as where it returns false
  }
  throw std::bad_alloc();  // encoders give no reason, and all others were checked
}

}  // namespace

void check_extension(const std::string& path) {
  check_among(path, {".png", ".pgm", ".bmp", ".tif", ".tiff"});
}

void check_deep_extension(const std::string& path) {
  check_among(path, {".png", ".pgm", ".tif", ".tiff"});
}

void check_overlay_extension(const std::string& path) {
  check_among(path, {".svg", ".png", ".bmp", ".tif", ".tiff"});
}

namespace {

/// Does what writes a file, with OpenCV's failures as FileError.
template <class Write>
void write_by(const std::string& path, const Write& write) {
  try {
    write();
  } catch (const std::bad_alloc&) {
    cannot_write(path, "there is not enough memory for it");
  } catch (const cv::Exception& error) {
    cannot_write(path, error.code == cv::Error::StsNoMem ? "there is not enough memory for it"
                                                         : "the image cannot be encoded");
  }
}

void check_writable(const std::string& path, Index width, Index height) {
  if (path != kStandardStream) check_target(path);
  if (width == 0 || height == 0) cannot_write(path, "the image has no pixels");
  if (!is_writable_size(width, height)) {
    cannot_write(path, "the image has 2^31 pixels or more");
  }
}

bool has_tiff_extension(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".tif" || extension == ".tiff";
}

TiffFormat tiff_format_of(const cv::Mat& page) {
  constexpr std::uint16_t lzw = 5;
  return {.width = page.cols,
          .height = page.rows,
          .compression = lzw,
          .bits = static_cast<int>(8 * page.elemSize1()),
          .samples = page.channels()};
}

void write_tiff_rows(TiffWriter& writer, const cv::Mat& page) {
  cv::Mat row;
  for (int y = 0; y < page.rows; ++y) {
    row = page.row(y);
    if (page.channels() == 3) cv::cvtColor(page.row(y), row, cv::COLOR_BGR2RGB);
    writer.write(1, row.data);
  }
}

/// Row by row: OpenCV's encoder ends the program if memory is short, and hides a full disk.
void write_tiff_pages(const std::string& path, const std::vector<cv::Mat>& pages) {
  write_whole_file(path, [&](const std::string& name) {
    Index all_bytes = 0;
    for (const cv::Mat& page : pages)
      all_bytes += static_cast<Index>(page.total() * page.elemSize());
    TiffWriter writer(name, path, tiff_format_of(pages.front()), all_bytes);
    for (std::size_t i = 0; i < pages.size(); ++i) {
      if (i > 0) writer.begin_page(tiff_format_of(pages[i]));
      write_tiff_rows(writer, pages[i]);
    }
    writer.finish();
  });
}

}  // namespace

void write_bytes(const std::string& path, std::string_view bytes) {
  if (path != kStandardStream) return write_whole_file(path, bytes);
  const bool is_written = std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size();
  if (!is_written || std::fflush(stdout) != 0) {
    throw FileError("standard output cannot be written");
  }
}

void write_mat(const std::string& path, const std::function<cv::Mat()>& draw) {
  write_by(path, [&] {
    const cv::Mat image = draw();
    if (has_tiff_extension(path)) return write_tiff_pages(path, {image});
    const std::vector<std::uint8_t> bytes =
        encoded(path == kStandardStream ? "image.png" : path, image);
    write_bytes(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  });
}

void write_grey(const std::string& path, const ConstImageView& image) {
  check_extension(path);
  check_writable(path, image.width, image.height);
  write_mat(path, [&] { return mat_of(image); });
}

void write_binary(const std::string& path, const ConstImageView& image) {
  if (extension_of(path) != ".pbm") check_extension(path);
  check_writable(path, image.width, image.height);
  write_mat(path, [&] { return mat_of(image); });
}

void write_deep(const std::string& path, const View<const std::uint16_t>& image) {
  check_deep_extension(path);
  check_writable(path, image.width, image.height);
  write_mat(path, [&] {
    return cv::Mat(static_cast<int>(image.height), static_cast<int>(image.width), CV_16UC1,
                   const_cast<std::uint16_t*>(image.data),
                   static_cast<std::size_t>(image.stride) * sizeof(std::uint16_t));
  });
}

std::string png_of(const ConstImageView& image) {
  std::string png;
  write_by("the image", [&] {
    const std::vector<std::uint8_t> bytes = encoded("image.png", mat_of(image));
    png.assign(bytes.begin(), bytes.end());
  });
  return png;
}

void write_grey_pages(const std::string& path, const std::vector<ByteImage>& pages) {
  std::vector<cv::Mat> mats;
  for (const ByteImage& page : pages) {
    check_writable(path, page.width(), page.height());
    mats.push_back(mat_of(page.view()));
  }
  write_by(path, [&] { write_tiff_pages(path, mats); });
}

OneThreadPerImage::OneThreadPerImage() : threads_(cv::getNumThreads()) {
  cv::setNumThreads(1);
}

OneThreadPerImage::~OneThreadPerImage() {
  cv::setNumThreads(threads_);
}

}  // namespace thinbench
