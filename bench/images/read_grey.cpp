#include <cerrno>
#include <cstdlib>
#include <new>
#include <system_error>

#include <fcntl.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include "picture/captured_stderr.hpp"
#include "picture/no_pixels.hpp"
#include "picture/picture.hpp"

namespace thinbench {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw PictureError("cannot read '" + path + "': " + why);
}

/// Refuses what no decoder could give a good reason for.
void check_file(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0 && errno == ENOENT) refuse(path, "there is no such file");
  if (descriptor < 0) refuse(path, std::generic_category().message(errno));
  struct stat facts {};
  const int failed = fstat(descriptor, &facts);
  close(descriptor);
  if (failed != 0) refuse(path, "its kind and size are unknown");
  if (S_ISDIR(facts.st_mode)) refuse(path, "it is a directory");
  if (!S_ISREG(facts.st_mode)) refuse(path, "it is not a regular file");
  if (facts.st_size == 0) refuse(path, "the file is empty");
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

/// The decoder gave up without a reason; the beginning of the file may tell one.
[[noreturn]] void refuse_undecoded(const std::string& path) {
  if (declares_no_pixels(path)) refuse(path, "it has no pixels");
  if (!cv::haveImageReader(path)) refuse(path, "it is not an image of a known format");
  refuse(path, "it is damaged");
}

/// A refusal by OpenCV in the words of this program.
[[noreturn]] void refuse(const std::string& path, const cv::Exception& error) {
  const auto mentions = [&](const char* text) { return error.err.find(text) != std::string::npos; };
  if (mentions("CV_IO_MAX_IMAGE_PIXELS")) refuse(path, too_many_pixels());
  if (mentions("CV_IO_MAX_IMAGE")) refuse(path, "it is wider or higher than 2^20 pixels");
  if (error.code == cv::Error::StsNoMem) refuse(path, "there is not enough memory for it");
  refuse_undecoded(path);
}

/// Some decoders fill up what is missing in a file that ends too early and only warn.
void check_warnings(const std::string& path, const std::string& warnings) {
  if (warnings.find("remature end") != std::string::npos) refuse(path, "the file is truncated");
}

cv::Mat decoded(const std::string& path) {
  const CapturedStderr captured;
  cv::Mat picture = cv::imread(path, cv::IMREAD_GRAYSCALE);
  if (picture.empty()) refuse_undecoded(path);
  check_warnings(path, captured.text());
  return picture;
}

}  // namespace

ByteImage read_grey(const std::string& path) {
  check_file(path);
  try {
    const cv::Mat picture = decoded(path);
    if (picture.total() > static_cast<std::size_t>(kMaxPicturePixels)) {
      refuse(path, "it has more than 2^31 pixels");
    }
    return copy_of({picture.data, picture.cols, picture.rows, static_cast<Index>(picture.step[0])});
  } catch (const cv::Exception& error) {
    refuse(path, error);
  } catch (const std::bad_alloc&) {
    refuse(path, "there is not enough memory for it");
  }
}

}  // namespace thinbench
