// The main of every test program: seven threads are real threads even on two cores.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 8);
  return RUN_ALL_TESTS();
}
