#include "support/text.hpp"

#include <gtest/gtest.h>

namespace thinbench {
namespace {

TEST(ExtensionOf, is_in_lower_case_whatever_the_name_has) {
  EXPECT_EQ(extension_of("page.tif"), ".tif");
  EXPECT_EQ(extension_of("SCANS.D/PAGE.TIFF"), ".tiff");
  EXPECT_EQ(extension_of("a.b.Pbm"), ".pbm");
  EXPECT_EQ(extension_of("scans.d/page"), "");
}

}  // namespace
}  // namespace thinbench
