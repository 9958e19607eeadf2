#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "picture/captured_stderr.hpp"
#include "picture/picture.hpp"
#include "picture/write_mat.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

constexpr std::array<std::string_view, 5> kExtensions = {".png", ".pgm", ".bmp", ".tif", ".tiff"};
constexpr const char* kKnownExtensions = ".png, .pgm, .bmp, .tif and .tiff";

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw PictureError("cannot write '" + path + "': " + why);
}

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

std::vector<std::uint8_t> encoded(const std::string& path, const cv::Mat& picture) {
  const CapturedStderr captured;
  std::vector<std::uint8_t> bytes;
  if (!cv::imencode(extension_of(path), picture, bytes)) {
    refuse(path, "the image cannot be encoded");
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
  refuse(path, what + "; known are " + kKnownExtensions);
}

void check_colour_extension(const std::string& path) {
  check_extension(path);
  if (extension_of(path) == ".pgm") refuse(path, "PGM holds no colours");
}

void write_mat(const std::string& path, const cv::Mat& picture) {
  try {
    const std::vector<std::uint8_t> bytes = encoded(path, picture);
    write_whole_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  } catch (const FileError& error) {
    throw PictureError(error.what());
  } catch (const PictureError&) {
    throw;
  } catch (const std::exception&) {  // OpenCV's own, or memory is short
    refuse(path, "the image cannot be encoded");
  }
}

void write_grey(const std::string& path, const ConstImageView& picture) {
  check_extension(path);
  try {
    check_target(path);
  } catch (const FileError& error) {
    throw PictureError(error.what());
  }
  if (picture.width == 0 || picture.height == 0) refuse(path, "the image has no pixels");
  if (!is_writable_size(picture.width, picture.height)) {
    refuse(path, "the image has 2^31 pixels or more");
  }
  // OpenCV only reads the pixels, but has no view of constant ones.
  write_mat(path, cv::Mat(static_cast<int>(picture.height), static_cast<int>(picture.width),
                          CV_8UC1, const_cast<std::uint8_t*>(picture.data),
                          static_cast<std::size_t>(picture.stride)));
}

}  // namespace thinbench
