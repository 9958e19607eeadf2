// Between the writers of pictures; includes OpenCV.
#pragma once

#include <string>

#include <opencv2/core.hpp>

namespace thinbench {

/// Writes 8-bit grey or colour (blue, green, red) in the format that the extension names, as a
/// whole or not at all. Throws PictureError.
void write_mat(const std::string& path, const cv::Mat& picture);

}  // namespace thinbench
