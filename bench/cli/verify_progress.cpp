#include "cli/verify_progress.hpp"

#include <iomanip>
#include <sstream>

namespace thinbench {
namespace {

/// What an image costs beside its pixels, in pixels.
constexpr double kImageOverhead = 140;

constexpr auto kRenewal = std::chrono::milliseconds(200);
constexpr const char* kClearLine = "\r\033[K";

}  // namespace

void VerifyProgress::Load::add(const TestImage& image) {
  ++images;
  work += static_cast<double>(image.image.width() * image.image.height()) + kImageOverhead;
}

VerifyProgress::VerifyProgress(const Console& console, const std::vector<TestImageSet>& sets)
    : console_(console), sets_(sets), loads_(sets.size()) {
  for (std::size_t set = 0; set < sets.size(); ++set) {
    sets[set].generate([&](const TestImage& image) { loads_[set].add(image); });
    all_work_ += loads_[set].work;
  }
  start_ = Clock::now();
}

double VerifyProgress::seconds_since(Clock::time_point start) const {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void VerifyProgress::begin_set(std::size_t set) {
  set_ = set;
  set_done_ = {};
  set_start_ = Clock::now();
}

void VerifyProgress::image_done(const TestImage& image) {
  const double before = set_done_.work;
  set_done_.add(image);
  work_done_ += set_done_.work - before;
  if (console_.err_is_terminal && Clock::now() - renewed_ >= kRenewal) renew_line();
}

void VerifyProgress::renew_line() {
  renewed_ = Clock::now();
  const double left = seconds_since(start_) * (all_work_ - work_done_) / work_done_;
  std::ostringstream line;
  line << kClearLine << sets_[set_].name << ": " << set_done_.images << " of "
       << loads_[set_].images << " images; about " << std::fixed << std::setprecision(0) << left
       << " s left for all";
  console_.err << line.str() << std::flush;
}

void VerifyProgress::end_set() {
  std::ostringstream line;
  if (console_.err_is_terminal) line << kClearLine;
  line << sets_[set_].name << ": " << set_done_.images << " images in " << std::fixed
       << std::setprecision(1) << seconds_since(set_start_) << " s\n";
  console_.err << line.str() << std::flush;
}

}  // namespace thinbench
