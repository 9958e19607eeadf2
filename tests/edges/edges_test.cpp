// Thresholds, packed edges and the preferred variants. opencv_test.cpp checks the references.
#include "thinbench/edges.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "harness/families.hpp"
#include "harness/test_images.hpp"
#include "harness/verify.hpp"
#include "reference.hpp"
#include "support/margins.hpp"
#include "techniques/variants.hpp"

namespace thinbench {
namespace {

using detail::EdgeOperation;
using detail::study::edge_operations;

TEST(EdgeThresholds, every_variant_equals_its_reference_at_extreme_thresholds) {
  const ByteImage image = grey_noise_image(199, 41, 0, 255, 3);
  for (const EdgeOperation& edges : edge_operations()) {
    for (const EdgeThresholds& thresholds :
         {EdgeThresholds{0, 0}, EdgeThresholds{1, 1}, EdgeThresholds{127, 127},
          EdgeThresholds{128, 254}, EdgeThresholds{255, 0}, EdgeThresholds{0, 255}}) {
      const Operation operation = edges_operation(edges, thresholds);
      for (const Variant& variant : operation.variants) {
        if (!variant.unavailable_reason(199).empty()) continue;
        const auto job = variant.make_job(199, 41, variant.threaded ? 3 : 1);
        EXPECT_EQ(find_mismatch(*job, image.view(), expected_of(operation, variant, image.view())),
                  std::nullopt)
            << operation.name << " " << variant.technique << " " << isa_name(variant.isa);
      }
    }
  }
}

TEST(PackedEdges, equal_the_reference_and_leave_the_margin_zero) {
  const ByteImage image = grey_noise_image(131, 20, 0, 255, 5);
  for (const EdgeOperatorInfo& info : kEdgeOperators) {
    ByteImage expected(131, 20);
    reference::edges(info.op)({}, image.view(), expected.view());
    for (const Isa isa : all_isas()) {
      if (!isa_available(isa)) continue;
      detail::PackedEdges packed({{info.op, {}}, isa, 131, 20, 3});
      const detail::ConstBitPlaneView bits = packed.run(image.view());
      for (Index y = 0; y < 20; ++y) {
        for (Index x = 0; x < 131; ++x) {
          const bool is_edge = (bits.row(y)[x / 64] >> (x % 64) & 1) != 0;
          ASSERT_EQ(is_edge, expected.at(x, y) != 0) << info.name << " at " << isa_name(isa);
        }
      }
      EXPECT_TRUE(margin_is_zero(bits)) << info.name << " at " << isa_name(isa);
    }
  }
}

TEST(EdgeVariants, prefer_8_bit_lanes_if_available_and_16_bit_lanes_otherwise) {
  for (const EdgeOperation& operation : edge_operations()) {
    const bool has_8_bit =
        std::any_of(operation.variants.begin(), operation.variants.end(),
                    [](const auto& one) { return one.technique == "simd_8bit"; });
    const auto& chosen = detail::choose_variant(operation.variants, 100, 10, {});
    EXPECT_EQ(chosen.technique, has_8_bit ? "simd_8bit" : "simd_16bit") << operation.name;
  }
}

}  // namespace
}  // namespace thinbench
