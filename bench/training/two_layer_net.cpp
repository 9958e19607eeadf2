#include "training/two_layer_net.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "training/portable_math.hpp"

namespace thinbench {

HiddenLayerNet to_net(const TwoLayerWeights& weights) {
  HiddenLayerNet net;
  net.hidden.assign(std::begin(weights.hidden), std::end(weights.hidden));
  net.output_weight.assign(std::begin(weights.output.weight), std::end(weights.output.weight));
  net.output_bias = weights.output.bias;
  return net;
}

TwoLayerWeights to_weights(const HiddenLayerNet& net) {
  if (net.hidden.size() != static_cast<std::size_t>(kHiddenNeurons)) {
    throw std::invalid_argument("weights of a two-layer net are for 8 hidden neurons, not " +
                                std::to_string(net.hidden.size()));
  }
  TwoLayerWeights weights{};
  std::copy(net.hidden.begin(), net.hidden.end(), weights.hidden);
  std::copy(net.output_weight.begin(), net.output_weight.end(), weights.output.weight);
  weights.output.bias = net.output_bias;
  return weights;
}

float activate(float x, Activation activation) {
  if (activation == Activation::sigmoid) {
    return 1.0F / (1.0F + static_cast<float>(portable_exp(static_cast<double>(-x))));
  }
  if (x > 3.0F) return 1.0F;
  if (x < -3.0F) return 0.0F;
  return 0.166F * x + 0.5F;
}

bool net_keeps(const HiddenLayerNet& net, const float (&n)[kNetInputs], Activation activation) {
  float out = net.output_bias;
  for (std::size_t j = 0; j < net.hidden.size(); ++j) {
    float sum = net.hidden[j].bias;
    for (int i = 0; i < kNetInputs; ++i) sum += net.hidden[j].weight[i] * n[i];
    out += net.output_weight[j] * activate(sum, activation);
  }
  return activate(out, activation) >= 0.5F;
}

KeepTable table_of(const HiddenLayerNet& net, Activation activation) {
  KeepTable table{};
  for (int k = 0; k < kDescriptors; ++k) {
    float n[kNetInputs];
    for (int i = 0; i < kNetInputs; ++i) n[i] = static_cast<float>(neighbour(k, i));
    table[static_cast<std::size_t>(k)] = net_keeps(net, n, activation);
  }
  return table;
}

int agreement(const KeepTable& a, const KeepTable& b) {
  int equal = 0;
  for (std::size_t k = 0; k < a.size(); ++k) equal += a[k] == b[k] ? 1 : 0;
  return equal;
}

}  // namespace thinbench
