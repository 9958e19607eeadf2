#include <cmath>
#include <utility>
#include <vector>

#include "matrix.hpp"
#include "reference.hpp"

namespace thinbench::reference {
namespace {

/// The neighbours of a pixel as numbers, dark is 1: the inputs of every net.
struct Inputs {
  float n[8];
};

Inputs inputs_at(const Matrix& image, Index x, Index y) {
  const auto dark = [&](Index dx, Index dy) { return image.dark(x + dx, y + dy) ? 1.0F : 0.0F; };
  return {{dark(1, 0), dark(1, -1), dark(0, -1), dark(-1, -1), dark(-1, 0), dark(-1, 1), dark(0, 1),
           dark(1, 1)}};
}

/// bias + w0 n0 + w1 n1 + ... + w7 n7, in this order.
float net_input(const Neuron& neuron, const float* n) {
  float sum = neuron.bias;
  for (int i = 0; i < 8; ++i) sum += neuron.weight[i] * n[i];
  return sum;
}

float sigmoid(float x) {
  return 1.0F / (1.0F + std::exp(-x));
}

float linear_threshold(float x) {
  if (x > 3.0F) return 1.0F;
  if (x < -3.0F) return 0.0F;
  return 0.166F * x + 0.5F;
}

template <float (*f)(float)>
float two_layer_output(const TwoLayerWeights& net, const Inputs& inputs) {
  float hidden[8];
  for (int j = 0; j < 8; ++j) hidden[j] = f(net_input(net.hidden[j], inputs.n));
  return f(net_input(net.output, hidden));
}

bool cluster_output(const ClusterWeights& cluster, const Inputs& inputs) {
  float k = 0;
  for (int i = 0; i < 8; ++i) k += inputs.n[i] * std::ldexp(1.0F, i);
  const ClusterNet* net = cluster.nets;
  while (k > static_cast<float>(net->last)) ++net;
  return net_input(net->neuron, inputs.n) >= 0.0F;
}

/// The passes of the printed procedure, with a net to say whether a dark pixel stays.
template <class Stays>
int thin_by(const Stays& stays, int most_passes, ConstByteView source, ByteView destination) {
  Matrix image = matrix_of(source);
  Matrix second(source.width, source.height);
  int passes = 0;
  for (bool flagged = true; flagged && passes < most_passes; ++passes) {
    flagged = false;
    for (Index y = 0; y < source.height; ++y) {
      for (Index x = 0; x < source.width; ++x) {
        const bool dark = image.dark(x, y);
        const bool kept = dark && stays(inputs_at(image, x, y));
        second.set(x, y, kept);
        flagged = flagged || kept != dark;
      }
    }
    std::swap(image, second);
  }
  write_matrix(image, destination);
  return passes;
}

}  // namespace

float two_layer_answer(const TwoLayerWeights& net, Activation activation, const float* n) {
  Inputs inputs{};
  for (int i = 0; i < 8; ++i) inputs.n[i] = n[i];
  return activation == Activation::kSigmoid ? two_layer_output<sigmoid>(net, inputs)
                                            : two_layer_output<linear_threshold>(net, inputs);
}

float activation_answer(Activation activation, float x) {
  return activation == Activation::kSigmoid ? sigmoid(x) : linear_threshold(x);
}

int net_two_layer(const TwoLayerWeights& net, Activation activation, int most_passes,
                  ConstByteView source, ByteView destination) {
  if (activation == Activation::kSigmoid) {
    return thin_by([&](const Inputs& n) { return two_layer_output<sigmoid>(net, n) >= 0.5F; },
                   most_passes, source, destination);
  }
  return thin_by(
      [&](const Inputs& n) { return two_layer_output<linear_threshold>(net, n) >= 0.5F; },
      most_passes, source, destination);
}

int net_single_layer_cluster(const ClusterWeights& cluster, int most_passes, ConstByteView source,
                             ByteView destination) {
  return thin_by([&](const Inputs& n) { return cluster_output(cluster, n); }, most_passes, source,
                 destination);
}

}  // namespace thinbench::reference
