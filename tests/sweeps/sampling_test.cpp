#include "sweeps/sampling.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace thinbench {
namespace {

std::vector<Point> few_points() {
  return plan_points({{"size"}, "^(holes|edges_sobel)/", true, 1}, all_operations());
}

TEST(SweepSampling, round_visits_every_point_once_and_inputs_together) {
  const std::vector<Point> points = few_points();
  std::vector<const Point*> all;
  for (const Point& point : points) all.push_back(&point);
  std::vector<const Point*> order = order_of_round(all, 7);
  EXPECT_NE(order, order_of_round(all, 8));
  EXPECT_EQ(order, order_of_round(all, 7));
  std::size_t changes = 0;
  std::set<SweepInput> inputs;
  for (std::size_t i = 0; i < order.size(); ++i) {
    changes += i == 0 || order[i]->input != order[i - 1]->input ? 1U : 0U;
    inputs.insert(order[i]->input);
  }
  EXPECT_EQ(changes, inputs.size());
  EXPECT_NE(order, all);
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, all);
}

TEST(SweepSampling, sample_counts_its_calls_and_refuses_another_result) {
  const std::vector<Point> points = few_points();
  InputStore inputs;
  std::string mismatch;
  auto proof = Prover(inputs).prove(points.front(), mismatch);
  ASSERT_TRUE(proof) << mismatch;
  proof->seconds = kSampleSeconds / 5;
  const Sample sample = Sampler(inputs).take(points.front(), *proof, 3);
  EXPECT_EQ(sample.calls, 5);
  EXPECT_EQ(sample.round, 3);
  EXPECT_GT(sample.ns, 0);
  proof->hash = "another";
  EXPECT_THROW(static_cast<void>(Sampler(inputs).take(points.front(), *proof, 0)),
               std::runtime_error);
}

}  // namespace
}  // namespace thinbench
