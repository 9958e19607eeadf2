// detect_edges().
#include "thinbench/edges.hpp"

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "reference.hpp"
#include "support/filled_image.hpp"

namespace thinbench {
namespace {

TEST(DetectEdges, equals_the_reference_by_default) {
  for (const EdgeOperatorInfo& info : kEdgeOperators) {
    for (const Index width : {1, 7, 64, 200, 513}) {
      const ByteImage image = grey_noise_image(width, 21, 60, 200, 3);
      ByteImage expected(width, 21);
      reference::edges(info.op)({}, image.view(), expected.view());
      for (const int threads : {1, 3}) {
        ByteImage found = filled_image(width, 21, 0x5A);
        detect_edges(info.op, image.view(), found.view(), {}, {.threads = threads});
        EXPECT_TRUE(equal(found.view(), expected.view())) << info.name << ", " << width;
      }
    }
  }
}

}  // namespace
}  // namespace thinbench
