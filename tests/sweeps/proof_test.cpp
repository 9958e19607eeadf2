#include "sweeps/proof.hpp"

#include <gtest/gtest.h>

#include "timing/broken_operation.hpp"

namespace thinbench {
namespace {

const SweepInput kSmallScene{Picture::scene, 100, 80};

Point point_of(const Operation& operation, std::string_view technique, Isa isa = Isa::baseline) {
  for (const Variant& variant : operation.variants) {
    if (variant.technique == technique && variant.isa == isa && !variant.threaded) {
      return {"size", 100, {}, kSmallScene, &operation, &variant, 1};
    }
  }
  throw std::logic_error("no such row");
}

TEST(SweepProof, affordable_reference_is_what_rows_are_compared_with) {
  InputStore inputs;
  Prover prover(inputs);
  std::string mismatch;
  const Operation& operation = operation_of("thin_guo_hall");
  const auto scalar = prover.prove(point_of(operation, "bitpacked"), mismatch);
  const auto packed = prover.prove(point_of(operation, "simd_bitpacked"), mismatch);
  ASSERT_TRUE(scalar && packed) << mismatch;
  EXPECT_EQ(scalar->against, "reference");
  EXPECT_EQ(packed->against, "reference");
  EXPECT_EQ(packed->hash, scalar->hash);
  EXPECT_GT(packed->seconds, 0);
}

TEST(SweepProof, another_row_stands_in_for_a_reference_that_takes_long_and_is_named) {
  InputStore inputs;
  Prover prover(inputs, kSmallScene.pixels());  // one pass
  std::string mismatch;
  const Operation& operation = operation_of("thin_guo_hall");
  const auto packed = prover.prove(point_of(operation, "simd_bitpacked"), mismatch);
  const auto scalar = prover.prove(point_of(operation, "bitpacked"), mismatch);
  ASSERT_TRUE(scalar && packed) << mismatch;
  EXPECT_EQ(packed->against, "bitpacked/baseline");
  EXPECT_NE(scalar->against, "bitpacked/baseline");
  EXPECT_NE(scalar->against, "reference");
  EXPECT_EQ(scalar->hash, packed->hash);
}

TEST(SweepProof, row_that_is_not_equal_has_no_proof) {
  InputStore inputs;
  const std::vector<Operation> operations = copy_operations();
  std::string mismatch;
  Prover prover(inputs);
  EXPECT_TRUE(prover.prove(point_of(operations[0], "good"), mismatch));
  EXPECT_FALSE(prover.prove(point_of(operations[0], "bad"), mismatch));
  EXPECT_NE(mismatch.find("copy/bad/baseline/1 on scene 100x80 against reference: "),
            std::string::npos)
      << mismatch;
}

TEST(SweepProof, no_row_is_compared_with_itself) {
  InputStore inputs;
  std::vector<Operation> operations = copy_operations();
  operations[0].variants = {copy_variant("bad", true)};
  std::string mismatch;
  EXPECT_FALSE(Prover(inputs, 0).prove(point_of(operations[0], "bad"), mismatch));
}

}  // namespace
}  // namespace thinbench
