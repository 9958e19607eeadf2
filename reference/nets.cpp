#include "decisions.hpp"
#include "reference.hpp"
#include "repeat.hpp"

namespace thinbench::reference {
namespace {

/// The inputs of a net: 1 for foreground neighbours, else 0.
struct Inputs {
  float n[8];
};

Inputs inputs_at(const Matrix& image, Index x, Index y) {
  const Neighbours at = neighbours_at(image, x, y);
  Inputs inputs{};
  for (int i = 0; i < 8; ++i) inputs.n[i] = at.n[i] ? 1.0F : 0.0F;
  return inputs;
}

/// The published procedure, where a net decides which foreground pixels are kept.
template <class Keeps>
int thin_by(const Keeps& keeps, const Repetition& repetition, ConstImageView source,
            ImageView destination) {
  const auto removed = [&](const Matrix& image, Index x, Index y, int) {
    return !keeps(inputs_at(image, x, y));
  };
  return repeat(1, repetition, source, destination, removed);
}

}  // namespace

float two_layer_output(const TwoLayerWeights& net, Activation activation, const float* n) {
  Inputs inputs{};
  for (int i = 0; i < 8; ++i) inputs.n[i] = n[i];
  return activation == Activation::sigmoid ? two_layer_output<Activation::sigmoid>(net, inputs.n)
                                           : two_layer_output<Activation::linear>(net, inputs.n);
}

float activation_output(Activation activation, float x) {
  return activation == Activation::sigmoid ? activated<Activation::sigmoid>(x)
                                           : activated<Activation::linear>(x);
}

int net_two_layer(const TwoLayerWeights& net, Activation activation, const Repetition& repetition,
                  ConstImageView source, ImageView destination) {
  if (activation == Activation::sigmoid) {
    return thin_by(
        [&](const Inputs& inputs) { return two_layer_keeps<Activation::sigmoid>(net, inputs.n); },
        repetition, source, destination);
  }
  return thin_by(
      [&](const Inputs& inputs) { return two_layer_keeps<Activation::linear>(net, inputs.n); },
      repetition, source, destination);
}

int net_single_layer_cluster(const ClusterWeights& cluster, const Repetition& repetition,
                             ConstImageView source, ImageView destination) {
  return thin_by([&](const Inputs& inputs) { return cluster_keeps(cluster, inputs.n); }, repetition,
                 source, destination);
}

}  // namespace thinbench::reference
