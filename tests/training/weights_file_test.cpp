#include "rules/weights_file.hpp"

#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "rules/trained_cluster.hpp"
#include "support/own_directory.hpp"
#include "support/rejection.hpp"
#include "support/whole_file.hpp"
#include "training/weights_text.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

void expect_equal(const Neuron& a, const Neuron& b) {
  for (int i = 0; i < kNetInputs; ++i) EXPECT_EQ(a.weight[i], b.weight[i]) << i;
  EXPECT_EQ(a.bias, b.bias);
}

std::string error_of(const std::string& text) {
  return rejection_of<std::runtime_error>([&] { (void)parse_weights(text, "weights.json"); });
}

/// What is put in a place of good weights, and what is wrong then, after the name of the file.
struct Change {
  const char* pointer;
  Json value;  // discarded: the place is deleted
  std::string expected;
};

template <class Weights>
void expect_errors(const Weights& weights, const std::vector<Change>& changes) {
  for (const auto& [pointer, value, expected] : changes) {
    Json json = Json::parse(weights_json(weights, "test"));
    const Json::json_pointer where(pointer);
    if (value.is_discarded()) {
      json.at(where.parent_pointer()).erase(where.back());
    } else {
      json[where] = value;
    }
    EXPECT_EQ(error_of(json.dump()), "weights.json: " + expected);
  }
}

const Json kMissing = Json(Json::value_t::discarded);

using WeightsFiles = OwnDirectory;

TEST_F(WeightsFiles, read_back_bit_for_bit) {
  write_whole_file("two_layer.json", weights_json(kPaperTwoLayer, "by \"hand\""));
  const auto two_layer = std::get<TwoLayerWeights>(read_weights("two_layer.json"));
  for (int j = 0; j < kHiddenNeurons; ++j) {
    expect_equal(two_layer.hidden[j], kPaperTwoLayer.hidden[j]);
  }
  expect_equal(two_layer.output, kPaperTwoLayer.output);
  write_whole_file("cluster.json", weights_json(detail::kTrainedCluster, "a test"));
  const auto cluster = std::get<ClusterWeights>(read_weights("cluster.json"));
  ASSERT_EQ(cluster.count, detail::kTrainedCluster.count);
  for (int n = 0; n < cluster.count; ++n) {
    EXPECT_EQ(cluster.nets[n].last, detail::kTrainedCluster.nets[n].last);
    expect_equal(cluster.nets[n].neuron, detail::kTrainedCluster.nets[n].neuron);
  }
  EXPECT_THROW((void)read_weights("absent.json"), std::runtime_error);
  EXPECT_THROW((void)read_weights("."), std::runtime_error);
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

TEST(WeightsFile, malformed_weights_are_rejected_with_the_field_named) {
  expect_errors(
      kPaperTwoLayer,
      {
          {"/hidden/3/weights",
           {1, 2, 3, 4, 5, 6, 7},
           "hidden[3].weights has 7 numbers; it must have 8"},
          {"/hidden", Json(9, Json::object()), "hidden has 9 neurons; it must have 8"},
          {"/hidden/2/bias", kMissing, "hidden[2].bias is missing"},
          {"/output", kMissing, "output is missing"},
          {"/output", 7, "output must be an object"},
          {"/hidden", "NaN", "hidden must be a list"},
          {"/output/bias", "NaN", "output.bias must be a number"},
          {"/output/weights/5", nullptr, "output.weights[5] must be a number"},
          {"/hidden/0/weights/1", 1e39, "hidden[0].weights[1] is 1e+39; the largest is 1e30"},
          {"/kind", "three_layer", "kind must be \"two_layer\" or \"cluster\""},
          {"/kind", kMissing, "kind is missing"},
          {"/schema", 2, "schema must be 1, the only version there is"},
          {"/schema", kMissing, "schema is missing"},
      });
  const std::string order = ": the runs cover 0 to 255 in order";
  expect_errors(
      detail::kTrainedCluster,
      {
          {"/nets/0/first", 1, "nets[0].first must be 0" + order},
          {"/nets/2/first", 90, "nets[2].first must be 85" + order},
          {"/nets/11/last", 250, "nets[11].last must be 255: the last run ends there"},
          {"/nets/1/last", 60, "nets[1].last must lie between 68 and 255"},
          {"/nets/1/last", 84.5, "nets[1].last must be an integer"},
          {"/nets/1/weights", Json::array(), "nets[1].weights has 0 numbers; it must have 8"},
          {"/nets", Json(17, Json::object()), "nets has 17 nets; it must have 1 to 16"},
          {"/nets", Json::array(), "nets has 0 nets; it must have 1 to 16"},
      });
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

TEST(WeightsFile, table_has_the_layout_of_table_1) {
  const std::string table = table_markdown(to_net(kPaperTwoLayer));
  EXPECT_EQ(table.find("|  | W0 | W1 | W2 | W3 | W4 | W5 | W6 | W7 | B |\n"), 0U);
  EXPECT_NE(
      table.find("| Hid0 | 7.18 | 0.56 | 2.16 | -3.48 | 13.69 | -3.62 | 2.02 | 0.54 | -6.25 |\n"),
      std::string::npos);
  EXPECT_NE(table.find("| Out | -19.88 |"), std::string::npos);
}

}  // namespace
}  // namespace thinbench
