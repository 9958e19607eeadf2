// The main function of every test program. oneTBB may use 8 threads even on a machine with fewer
// cores, so that tests with 7 threads run 7 threads.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 8);
  return RUN_ALL_TESTS();
}
