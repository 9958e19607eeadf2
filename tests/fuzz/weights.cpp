// Files of weights: weights that are written and read back the same and make a net, or one line
// that says what is wrong.
#include <stdexcept>

#include "byte_source.hpp"
#include "rules/weights_file.hpp"
#include "thinbench/rule.hpp"
#include "training/weights_text.hpp"

namespace thinbench {
namespace {

void make_net(const TwoLayerWeights& weights) {
  static_cast<void>(Rule::from_net(weights, Activation::linear));
}

void make_net(const ClusterWeights& weights) {
  static_cast<void>(Rule::from_net(weights));
}

void read(const std::string& text) {
  std::visit(
      [](const auto& weights) {
        const std::string written = weights_json(weights, "test");
        const auto again =
            std::get<std::decay_t<decltype(weights)>>(parse_weights(written, "again"));
        must(weights_json(again, "test") == written, "weights change when they are written");
        make_net(weights);
      },
      parse_weights(text, "input"));
}

}  // namespace

void try_input(ByteSource& input) {
  must_succeed_or_explain<std::runtime_error>([&] { read(input.rest()); });
}

}  // namespace thinbench
