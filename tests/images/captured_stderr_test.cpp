#include "images/captured_stderr.hpp"

#include <cstdio>
#include <iostream>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace thinbench {
namespace {

TEST(CapturedStderr, catches_what_its_thread_writes_to_either_stream) {
  const CapturedStderr captured;
  std::fprintf(stderr, "%d", 1);
  std::cerr << 2 << 'c';
  EXPECT_EQ(captured.text(), "12c");
}

TEST(CapturedStderr, threads_do_not_see_each_others_text) {
  std::vector<std::string> texts(8);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    threads.emplace_back([&texts, i] {
      const CapturedStderr captured;
      for (int repeat = 0; repeat < 100; ++repeat) std::fprintf(stderr, "%zu", i);
      texts[i] = captured.text();
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < texts.size(); ++i) {
    EXPECT_EQ(texts[i], std::string(100, static_cast<char>('0' + i)));
  }
}

TEST(CapturedStderr, inner_capture_hides_its_text_from_the_outer_one) {
  const CapturedStderr outer;
  {
    const CapturedStderr inner;
    std::fputs("inner", stderr);
  }
  std::fputs("outer", stderr);
  EXPECT_EQ(outer.text(), "outer");
}

TEST(CapturedStderr, uncaught_text_reaches_standard_error) {
  { const CapturedStderr captured; }
  testing::internal::CaptureStderr();
  std::fputs("C", stderr);
  std::cerr << "++";
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "C++");
}

}  // namespace
}  // namespace thinbench
