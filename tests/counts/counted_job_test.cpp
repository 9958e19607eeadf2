#include "counts/counted_job.hpp"

#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

namespace thinbench {
namespace {

TimedInput small_scene() {
  return small_copy(timed_inputs({}).front());
}

TEST(CountedJob, what_is_read_is_what_was_written) {
  const TimedInput input = small_scene();
  std::stringstream stream;
  write_job(stream, input, {"a/b", "c"});
  const CountedJob job = read_job(stream);
  EXPECT_EQ(job.rows, (std::vector<std::string>{"a/b", "c"}));
  EXPECT_EQ(job.input.name, "scene_small");
  EXPECT_TRUE(equal(job.input.binary.view(), input.binary.view()));
  EXPECT_TRUE(equal(job.input.grey.view(), input.grey.view()));
}

TEST(CountedJob, a_job_that_was_cut_off_is_rejected) {
  std::stringstream stream;
  write_job(stream, small_scene(), {"a/b"});
  const std::string whole = stream.str();
  for (const std::size_t length : {std::size_t{0}, std::size_t{20}, whole.size() - 1}) {
    std::istringstream cut(whole.substr(0, length));
    EXPECT_THROW(static_cast<void>(read_job(cut)), std::runtime_error) << length;
  }
}

}  // namespace
}  // namespace thinbench
