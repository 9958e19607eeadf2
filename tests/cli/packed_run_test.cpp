// thinbench run on packed files.
#include <regex>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/made_image.hpp"
#include "support/packed_image.hpp"
#include "typed.hpp"

namespace thinbench {
namespace {

class PackedRun : public Commands {
 protected:
  PackedRun() { put("in.pbm", header + bits(image)); }

  static std::string bits(const ByteImage& pixels, BitOrder order = BitOrder::msb_first) {
    return raw_bytes(PackedImage(pixels.view(), order));
  }

  ByteImage image = noise_image(1203, 900, 85, 16, 3);
  std::string header = "P4 1203\n# drawn\n900\n";
};

TEST_F(PackedRun, thins_pbm_in_memory) {
  const std::string text = output_of("run life in.pbm OUT.PBM --max-iterations 4");
  const std::regex line(R"(life: 1203 x 900, 4 iterations, \d+ foreground pixels before, )"
                        R"(\d+ after, \d+\.\d{3} ms\n)");
  EXPECT_TRUE(std::regex_match(text, line)) << text;
  EXPECT_TRUE(bytes_of("OUT.PBM") ==
              header + bits(thinned(Rule::named("life"), image, {.max_iterations = 4})));
}

TEST_F(PackedRun, thins_raw_bits_in_both_orders) {
  for (const auto& [order, name] :
       {std::pair{BitOrder::msb_first, "msb"}, {BitOrder::lsb_first, "lsb"}}) {
    put("raw", bits(image, order));
    output_of("run thin_zhang_suen raw raw --raw 1203x900 --bit-order " + std::string(name));
    EXPECT_TRUE(bytes_of("raw") == bits(thinned(Rule::zhang_suen, image), order)) << name;
  }
}

TEST_F(PackedRun, files_of_other_formats_are_rejected) {
  const std::string kind = "it is not a binary PBM file (P4), as OUT requires";
  const std::string damaged = "its PBM header is damaged";
  const std::string size = "; expected 1 to 2^40 pixels";
  for (const auto& [bytes, reason] : std::vector<std::pair<std::string, std::string>>{
           {"P5 2 2 255 abcd", kind},
           {"", kind},
           {"P4 12", damaged},
           {"P4 12 3x", damaged},
           {"P4 12 -3\n", "its size is 12 x -3" + size},
           {"P4 0 3\n", "its size is 0 x 3" + size},
           {"P4 9999999999 9999999999\n", "its size is 9999999999 x 9999999999" + size},
           {"P4 12 3\n12345", "it has 13 bytes; its header and 12 x 3 pixels take 14"}}) {
    put("bad.pbm", bytes);
    expect_rejected({1, "run thin_guo_hall bad.pbm out.pbm", {"cannot read 'bad.pbm': " + reason}});
  }
}

TEST_F(PackedRun, what_does_not_apply_to_packed_files_is_rejected) {
  const std::string run = "run thin_guo_hall in.pbm out.pbm ";
  const std::string grey = " does not apply to packed files, whose pixels have one bit";
  expect_rejected({
      {1, "run thin_guo_hall absent.pbm out.pbm", {"'absent.pbm': there is no such file"}},
      {2, run + "--foreground dark", {"--foreground" + grey}},
      {2, run + "--threshold 12", {"--threshold" + grey}},
      {2, run + "--raw 12x", {"--raw: expected WIDTHxHEIGHT of 1 to 2^40 pixels, got '12x'"}},
      {2, run + "--bit-order lsb", {"--raw"}},
  });
}

}  // namespace
}  // namespace thinbench
