// Headers of packed files, and numbers of packed pixels.
#include <string>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "images/binarise.hpp"
#include "images/pnm.hpp"
#include "support/packed_image.hpp"

namespace thinbench {
namespace {

TEST(PbmFormat, header_may_have_comments_and_any_spaces) {
  for (const std::string header :
       {"P4\n12 3\n", "P4 12 3 ", "P4\n# a\n# b 7\n12\t# c\n\n3\n", "P4#\n12 3\r"}) {
    const PackedFormat format = pbm_format({"image", header + "......"});
    EXPECT_EQ(format.width, 12) << header;
    EXPECT_EQ(format.height, 3) << header;
    EXPECT_EQ(format.header_bytes, header.size());
    EXPECT_EQ(format.file_bytes(), header.size() + 6);
  }
}

TEST(PackedForeground, counts_the_pixels_of_any_width) {
  for (const Index width : {1, 8, 63, 64, 65, 200, 1001}) {
    const ByteImage image = noise_image(width, 9, 60, 1, 4);
    Index expected = 0;
    for (Index y = 0; y < 9; ++y) {
      for (Index x = 0; x < width; ++x) expected += image.at(x, y) != 0 ? 1 : 0;
    }
    EXPECT_EQ(packed_foreground(PackedImage(image.view(), BitOrder::msb_first, 3).view()),
              expected);
  }
}

}  // namespace
}  // namespace thinbench
