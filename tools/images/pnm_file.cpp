#include "images/pnm_file.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "images/pnm_header.hpp"
#include "support/regular_file.hpp"

namespace thinbench {
namespace {

constexpr Index kMaxByte = 255;
constexpr Index kMaxWord = 65535;
constexpr std::size_t kMaxTextBytes = (std::size_t{1} << 31) - 2;  // OpenCV counts by int

bool is_text(std::string_view header) {
  return header.starts_with("P2") || header.starts_with("P3");
}

bool is_pam(std::string_view header) {
  return header.starts_with("P7");
}

/// The number on a line of a PAM header that begins with this word.
std::optional<Index> pam_number(std::string_view header, std::string_view word) {
  const std::size_t at = header.find(word);
  if (at == std::string_view::npos) return std::nullopt;
  return PnmHeader(header.substr(at + word.size() - 2)).number();  // begins two bytes later
}

/// The maximum that a header names; nothing for headers without one, and damaged ones.
std::optional<Index> maximum_in(std::string_view header) {
  PnmHeader numbers(header);
  if (is_pam(header)) return pam_number(header, "\nMAXVAL");
  if (header.starts_with("P4") || !numbers.number() || !numbers.number()) return std::nullopt;
  return numbers.number();
}

/// Whether OpenCV takes samples for what they are not: it scales bytes of texts alone.
bool needs_scaling(std::string_view header, Index maximum) {
  if (maximum <= 0 || maximum == kMaxByte || maximum >= kMaxWord) return false;
  return !is_text(header) || maximum > kMaxByte;
}

/// 255 v / maximum, for bytes rounded down, as OpenCV does.
cv::Mat scaled(const cv::Mat& image, Index maximum) {
  cv::Mat result;
  if (image.depth() != CV_8U) {
    image.convertTo(result, CV_8U, static_cast<double>(kMaxByte) / static_cast<double>(maximum));
    return result;
  }
  cv::Mat table(1, 256, CV_8UC1);
  for (int value = 0; value < table.cols; ++value) {
    table.at<std::uint8_t>(0, value) =
        static_cast<std::uint8_t>(kMaxByte * std::min<Index>(value, maximum) / maximum);
  }
  cv::LUT(image, table, result);
  return result;
}

/// OpenCV wants a character after the last number of a text.
cv::Mat decoded(const std::string& path, std::string_view header, int how) {
  if (!is_text(header)) return cv::imread(path, how);
  std::string text = read_whole_file(path, kMaxTextBytes) + '\n';
  return cv::imdecode(cv::Mat(1, static_cast<int>(text.size()), CV_8UC1, text.data()), how);
}

/// OpenCV reads transparency wrongly, and takes red for blue.
cv::Mat read_pam(const std::string& path, std::string_view header, Index maximum) {
  if (needs_scaling(header, maximum)) {
    cannot_read(path, "its maximum is " + std::to_string(maximum) +
                          "; known for PAM files are 255 and 65535");
  }
  const Index depth = pam_number(header, "\nDEPTH").value_or(0);
  if (depth != 1 && depth != 3) {
    cannot_read(path,
                "its depth is " + std::to_string(depth) + "; known for PAM files are 1 and 3");
  }
  cv::Mat image = decoded(path, header, cv::IMREAD_ANYCOLOR);
  if (image.channels() == 3) cv::cvtColor(image, image, cv::COLOR_RGB2BGR);
  return image;
}

}  // namespace

bool is_pnm(const std::string& path) {
  const std::string start = beginning_of(path, 2);
  return start.size() == 2 && start[0] == 'P' && start[1] >= '2' && start[1] <= '7';
}

cv::Mat read_pnm(const std::string& path) {
  const std::string header = beginning_of(path, kPnmHeaderBytes);
  const Index maximum = maximum_in(header).value_or(0);
  if (is_pam(header)) return read_pam(path, header, maximum);
  if (!needs_scaling(header, maximum)) return decoded(path, header, cv::IMREAD_ANYCOLOR);
  cv::Mat image = decoded(path, header, cv::IMREAD_UNCHANGED);
  if (image.empty()) return image;
  return scaled(image, maximum);
}

}  // namespace thinbench
