#include "rules/weights_file.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "rules/trained_cluster.hpp"
#include "support/whole_file.hpp"
#include "training/weights_text.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

void expect_equal(const Neuron& a, const Neuron& b) {
  for (int i = 0; i < kNetInputs; ++i) EXPECT_EQ(a.weight[i], b.weight[i]) << i;
  EXPECT_EQ(a.bias, b.bias);
}

/// The error's line, or "accepted".
std::string error_of(const std::string& text) {
  try {
    (void)parse_weights(text, "weights.json");
    return "accepted";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

/// The error after replacing what `pointer` names in good weights; null deletes it.
template <class Weights>
std::string error_with(const Weights& weights, const std::string& pointer, const Json& value) {
  Json json = Json::parse(weights_json(weights, "test"));
  const Json::json_pointer where(pointer);
  if (value.is_discarded()) {
    json.at(where.parent_pointer()).erase(where.back());
  } else {
    json[where] = value;
  }
  return error_of(json.dump());
}

const Json kMissing = Json(Json::value_t::discarded);

TEST(WeightsFile, two_layer_weights_read_back_bit_for_bit) {
  const std::string path = testing::TempDir() + "two_layer_weights.json";
  write_whole_file(path, weights_json(kPaperTwoLayer, "by \"hand\""));
  const auto weights = std::get<TwoLayerWeights>(read_weights(path));
  for (int j = 0; j < kHiddenNeurons; ++j)
    expect_equal(weights.hidden[j], kPaperTwoLayer.hidden[j]);
  expect_equal(weights.output, kPaperTwoLayer.output);
}

TEST(WeightsFile, cluster_weights_read_back_bit_for_bit) {
  const std::string path = testing::TempDir() + "cluster_weights.json";
  write_whole_file(path, weights_json(detail::kTrainedCluster, "thinbench-study train cluster"));
  const auto weights = std::get<ClusterWeights>(read_weights(path));
  ASSERT_EQ(weights.count, detail::kTrainedCluster.count);
  for (int n = 0; n < weights.count; ++n) {
    EXPECT_EQ(weights.nets[n].last, detail::kTrainedCluster.nets[n].last);
    expect_equal(weights.nets[n].neuron, detail::kTrainedCluster.nets[n].neuron);
  }
}

TEST(WeightsFile, awkward_floats_read_back_bit_for_bit) {
  TwoLayerWeights weights = kPaperTwoLayer;
  weights.output = {{0.1F, 1.0F / 3, 1e-30F, 1e30F, 16777217.0F, -1e-45F, 1.17549435e-38F, 3e-5F},
                    std::numeric_limits<float>::epsilon()};
  const AnyWeights read = parse_weights(weights_json(weights, ""), "weights.json");
  expect_equal(std::get<TwoLayerWeights>(read).output, weights.output);
}

TEST(WeightsFile, negative_zeros_become_zeros_that_read_back) {
  Json json = Json::parse(weights_json(kPaperTwoLayer, ""));
  json["output"]["bias"] = -0.0;
  const AnyWeights read = parse_weights(json.dump(), "weights.json");
  const std::string written = weights_json(std::get<TwoLayerWeights>(read), "");
  const AnyWeights again = parse_weights(written, "weights.json");
  EXPECT_EQ(weights_json(std::get<TwoLayerWeights>(again), ""), written);
  EXPECT_FALSE(std::signbit(std::get<TwoLayerWeights>(read).output.bias));
}

TEST(WeightsFile, malformed_two_layer_weights_are_rejected_with_the_field_named) {
  const auto error = [](const std::string& pointer, const Json& value) {
    return error_with(kPaperTwoLayer, pointer, value);
  };
  EXPECT_EQ(error("/hidden/3/weights", {1, 2, 3, 4, 5, 6, 7}),
            "weights.json: hidden[3].weights has 7 numbers; it must have 8");
  EXPECT_EQ(error("/hidden", Json(9, Json::object())),
            "weights.json: hidden has 9 neurons; it must have 8");
  EXPECT_EQ(error("/hidden/2/bias", kMissing), "weights.json: hidden[2].bias is missing");
  EXPECT_EQ(error("/output", kMissing), "weights.json: output is missing");
  EXPECT_EQ(error("/output", 7), "weights.json: output must be an object");
  EXPECT_EQ(error("/hidden", "NaN"), "weights.json: hidden must be a list");
  EXPECT_EQ(error("/output/bias", "NaN"), "weights.json: output.bias must be a number");
  EXPECT_EQ(error("/output/weights/5", nullptr),
            "weights.json: output.weights[5] must be a number");
  EXPECT_EQ(error("/hidden/0/weights/1", 1e39),
            "weights.json: hidden[0].weights[1] is 1e+39; the largest is 1e30");
}

TEST(WeightsFile, malformed_clusters_are_rejected_with_the_field_named) {
  const auto error = [](const std::string& pointer, const Json& value) {
    return error_with(detail::kTrainedCluster, pointer, value);
  };
  EXPECT_EQ(error("/nets/0/first", 1),
            "weights.json: nets[0].first must be 0: the runs cover 0 to 255 in order");
  EXPECT_EQ(error("/nets/2/first", 90),
            "weights.json: nets[2].first must be 85: the runs cover 0 to 255 in order");
  EXPECT_EQ(error("/nets/11/last", 250),
            "weights.json: nets[11].last must be 255: the last run ends there");
  EXPECT_EQ(error("/nets/1/last", 60), "weights.json: nets[1].last must lie between 68 and 255");
  EXPECT_EQ(error("/nets/1/last", 84.5), "weights.json: nets[1].last must be an integer");
  EXPECT_EQ(error("/nets/1/weights", Json::array()),
            "weights.json: nets[1].weights has 0 numbers; it must have 8");
  EXPECT_EQ(error("/nets", Json(17, Json::object())),
            "weights.json: nets has 17 nets; it must have 1 to 16");
  EXPECT_EQ(error("/nets", Json::array()), "weights.json: nets has 0 nets; it must have 1 to 16");
}

TEST(WeightsFile, unknown_kinds_and_versions_are_rejected) {
  EXPECT_EQ(error_with(kPaperTwoLayer, "/kind", "three_layer"),
            "weights.json: kind must be \"two_layer\" or \"cluster\"");
  EXPECT_EQ(error_with(kPaperTwoLayer, "/kind", kMissing), "weights.json: kind is missing");
  EXPECT_EQ(error_with(kPaperTwoLayer, "/schema", 2),
            "weights.json: schema must be 1, the only version there is");
  EXPECT_EQ(error_with(kPaperTwoLayer, "/schema", kMissing), "weights.json: schema is missing");
  EXPECT_EQ(error_of("[]"), "weights.json: the outermost value must be an object");
}

TEST(WeightsFile, what_is_not_json_is_rejected_with_the_place) {
  const std::string good = weights_json(kPaperTwoLayer, "test");
  for (std::size_t size = 0; size + 2 < good.size(); size += 7) {
    EXPECT_EQ(error_of(good.substr(0, size)).find("weights.json: not JSON, or truncated, at byte "),
              0U)
        << size;
  }
  EXPECT_EQ(error_of("{\"schema\": NaN}"),
            "weights.json: not JSON, or truncated, at byte 12 of 15");
  EXPECT_EQ(error_of("{\"schema\": 1e400}"), "weights.json: a number is too large to read");
}

TEST(WeightsFile, missing_files_are_named) {
  EXPECT_THROW((void)read_weights(testing::TempDir() + "no_such_weights.json"), std::runtime_error);
  EXPECT_THROW((void)read_weights(testing::TempDir()), std::runtime_error);
  EXPECT_THROW(write_whole_file(testing::TempDir() + "no_such_directory/x", ""),
               std::runtime_error);
}

TEST(WeightsFile, table_has_the_layout_of_table_1) {
  const std::string table = table_markdown(kPaperTwoLayer);
  EXPECT_EQ(table.find("|  | W0 | W1 | W2 | W3 | W4 | W5 | W6 | W7 | B |\n"), 0U);
  EXPECT_NE(
      table.find("| Hid0 | 7.18 | 0.56 | 2.16 | -3.48 | 13.69 | -3.62 | 2.02 | 0.54 | -6.25 |\n"),
      std::string::npos);
  EXPECT_NE(table.find("| Out | -19.88 |"), std::string::npos);
}

}  // namespace
}  // namespace thinbench
