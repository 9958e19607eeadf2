#include <utility>

#include "decisions.hpp"
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

/// The passes of the printed procedure, with a net to say whether a dark pixel stays.
template <class Stays>
int thin_by(const Stays& stays, int max_iterations, ConstImageView source, ImageView destination) {
  Matrix image = matrix_of(source);
  Matrix second(source.width, source.height);
  int passes = 0;
  for (bool flagged = true; flagged && passes < max_iterations; ++passes) {
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
  return activation == Activation::sigmoid ? two_layer_output<Activation::sigmoid>(net, inputs.n)
                                            : two_layer_output<Activation::linear>(net, inputs.n);
}

float activation_answer(Activation activation, float x) {
  return activation == Activation::sigmoid ? activated<Activation::sigmoid>(x)
                                            : activated<Activation::linear>(x);
}

int net_two_layer(const TwoLayerWeights& net, Activation activation, int max_iterations,
                  ConstImageView source, ImageView destination) {
  if (activation == Activation::sigmoid) {
    return thin_by(
        [&](const Inputs& inputs) { return two_layer_keeps<Activation::sigmoid>(net, inputs.n); },
        max_iterations, source, destination);
  }
  return thin_by(
      [&](const Inputs& inputs) { return two_layer_keeps<Activation::linear>(net, inputs.n); },
      max_iterations, source, destination);
}

int net_single_layer_cluster(const ClusterWeights& cluster, int max_iterations, ConstImageView source,
                             ImageView destination) {
  return thin_by([&](const Inputs& inputs) { return cluster_keeps(cluster, inputs.n); },
                 max_iterations, source, destination);
}

}  // namespace thinbench::reference
