// The main function of every test program. oneTBB may use 8 threads even on a machine with fewer
// cores, so that tests with 7 threads run 7 threads.
#include <gtest/gtest.h>
#ifdef THINBENCH_WITH_TBB
#include <tbb/global_control.h>
#endif

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
#ifdef THINBENCH_WITH_TBB
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 8);
#endif
  return RUN_ALL_TESTS();
}
