// One net in training: the gradient of its error over all vectors, and one step down it.
#pragma once

#include <vector>

#include "training/portable_math.hpp"
#include "training/two_layer_net.hpp"

namespace thinbench {

/// Back-propagation in double precision on a whole table at a time, with a step size for each
/// weight that grows by 1.2 while its derivative keeps its sign and halves when it changes (RPROP:
/// Riedmiller, Braun 1993; the variant that skips the weight once after a change). The error is the
/// cross entropy, with which an output that is wrong and saturated is still corrected.
class BackPropagation {
 public:
  /// Random weights in [-1, 1).
  BackPropagation(const KeepTable& table, int hidden, Random& random);

  /// Shows all vectors and moves all weights; returns how many answers were correct before the
  /// move.
  int epoch();

  /// The weights rounded to hundredths.
  [[nodiscard]] HiddenLayerNet rounded_net() const;

 private:
  [[nodiscard]] double* hidden_row(std::size_t j) { return &weights_[j * kRow]; }
  double answer(std::size_t k);
  void add_gradient(std::size_t k, double output_error);
  void move_weights();

  static constexpr std::size_t kRow = kNetInputs + 1;  // weights of a hidden neuron, then its bias

  const KeepTable& table_;
  std::size_t hidden_;
  std::vector<double> inputs_;    // kRow for each vector, the last always 1
  std::vector<double> weights_;   // hidden rows, then the output's weights and bias
  std::vector<double> gradient_;  // like the weights
  std::vector<double> previous_;  // the gradient of the epoch before
  std::vector<double> step_;
  std::vector<double> answers_;  // of the hidden neurons
};

}  // namespace thinbench
