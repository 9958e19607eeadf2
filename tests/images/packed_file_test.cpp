// Packed files, read and written by blocks.
#include "images/packed_file.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/own_directory.hpp"
#include "support/packed_image.hpp"

namespace thinbench {
namespace {

using PbmFormat = OwnDirectory;

TEST_F(PbmFormat, header_may_have_comments_and_any_spaces) {
  for (const std::string header :
       {"P4\n12 3\n", "P4 12 3 ", "P4\n# a\n# b 7\n12\t# c\n\n3\n", "P4#\n12 3\r"}) {
    put("image", header + "......");
    const PackedFormat format = pbm_format("image");
    EXPECT_EQ(format.width, 12) << header;
    EXPECT_EQ(format.height, 3) << header;
    EXPECT_EQ(format.header, header);
    EXPECT_EQ(format.file_bytes(), static_cast<Index>(header.size()) + 6);
  }
}

using PackedFileBlocks = OwnDirectory;

TEST_F(PackedFileBlocks, blocks_copied_one_by_one_give_the_image_with_clear_unused_bits) {
  for (const BitOrder order : {BitOrder::msb_first, BitOrder::lsb_first}) {
    const ByteImage image = noise_image(83, 21, 50, 1, 4);
    const PackedFormat format = {83, 21, order};
    put("in", raw_bytes(PackedImage(image.view(), order, 0, 0xFF)));
    const PackedFile source = PackedFile::open("in", format);
    const PackedFile target = PackedFile::create("out", format);
    for (const Block& block :
         {Block{0, 0, 83, 4}, Block{0, 4, 32, 17}, Block{32, 4, 51, 9}, Block{32, 13, 51, 8}}) {
      std::vector<std::uint8_t> bytes(static_cast<std::size_t>(block.row_bytes() * block.height));
      source.read(block, bytes.data());
      target.write(block, bytes.data(), block.row_bytes());
    }
    EXPECT_EQ(bytes_of(target.path()), raw_bytes(PackedImage(image.view(), order)));
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
