#include "training/two_layer_training.hpp"

#include "training/back_propagation.hpp"

namespace thinbench {
namespace {

struct Rated {
  HiddenLayerNet net;
  int sigmoid = 0;
  int linear = 0;
};

Rated rate(HiddenLayerNet net, const KeepTable& table) {
  const int sigmoid = agreement(table_of(net, Activation::sigmoid), table);
  const int linear = agreement(table_of(net, Activation::linear), table);
  return {std::move(net), sigmoid, linear};
}

bool better(const Rated& a, const Rated& b) {
  return a.sigmoid != b.sigmoid ? a.sigmoid > b.sigmoid : a.linear > b.linear;
}

}  // namespace

TrainedTwoLayer train_two_layer(const KeepTable& table, const TwoLayerTraining& training) {
  const auto good = [&](const Rated& rated) {
    return rated.sigmoid == kDescriptors && (!training.also_linear || rated.linear == kDescriptors);
  };
  Random random(training.seed);
  Rated best;
  TrainedTwoLayer result;
  for (int start = 0; start <= training.max_restarts && !good(best); ++start) {
    BackPropagation net(table, training.hidden, random);
    int most_right = 0;
    result.restarts = start;
    for (result.epochs = 0; result.epochs < training.max_epochs && !good(best); ++result.epochs) {
      const int right = net.epoch();
      if (right < most_right || (right == most_right && right < kDescriptors)) continue;
      most_right = right;
      Rated rated = rate(net.rounded_net(), table);
      if (better(rated, best)) best = std::move(rated);
    }
    result.total_epochs += result.epochs;
  }
  result.net = std::move(best.net);
  result.right_sigmoid = best.sigmoid;
  result.right_linear = best.linear;
  return result;
}

}  // namespace thinbench
