// PGM, PPM and PAM files. Includes OpenCV.
#pragma once

#include <string>

#include <opencv2/core.hpp>

namespace thinbench {

/// By its first two bytes, "P2" to "P7"; false for files that cannot be read.
[[nodiscard]] bool is_pnm(const std::string& path);

/// Reads grey levels or colours as they are meant where OpenCV alone does not: the maximum that the
/// header names becomes 255, the last number of a text needs no newline, and PAM has red first.
/// Empty where OpenCV gives up. Throws FileError, also for PAM files of another maximum than 255 and
/// 65535 or of another depth than 1 and 3.
[[nodiscard]] cv::Mat read_pnm(const std::string& path);

}  // namespace thinbench
