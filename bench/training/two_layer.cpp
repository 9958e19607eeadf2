#include "training/two_layer.hpp"

#include <algorithm>
#include <cmath>
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

namespace {

double sigmoid_of(double x) {
  return 1.0 / (1.0 + portable_exp(-x));
}

float hundredths(double value) {
  return static_cast<float>(std::round(value * 100) / 100);
}

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

BackPropagation::BackPropagation(const KeepTable& table, int hidden, Random& random)
    : table_(table), hidden_(static_cast<std::size_t>(hidden)), answers_(hidden_) {
  constexpr double kFirstStep = 0.02;
  weights_.resize(hidden_ * kRow + hidden_ + 1);
  for (double& weight : weights_) weight = symmetric(random);
  previous_.assign(weights_.size(), 0.0);
  step_.assign(weights_.size(), kFirstStep);
  for (int k = 0; k < kDescriptors; ++k) {
    for (int i = 0; i < kNetInputs; ++i) inputs_.push_back(neighbour(k, i));
    inputs_.push_back(1.0);
  }
}

double BackPropagation::answer(std::size_t k) {
  const double* input = &inputs_[k * kRow];
  const double* output = hidden_row(hidden_);
  double out = output[hidden_];
  for (std::size_t j = 0; j < hidden_; ++j) {
    const double* row = hidden_row(j);
    double sum = 0;
    for (std::size_t i = 0; i < kRow; ++i) sum += row[i] * input[i];
    answers_[j] = sigmoid_of(sum);
    out += output[j] * answers_[j];
  }
  return sigmoid_of(out);
}

void BackPropagation::add_gradient(std::size_t k, double output_error) {
  const double* input = &inputs_[k * kRow];
  const double* output = hidden_row(hidden_);
  double* output_gradient = &gradient_[hidden_ * kRow];
  for (std::size_t j = 0; j < hidden_; ++j) {
    const double hidden_error = output_error * output[j] * answers_[j] * (1 - answers_[j]);
    double* row = &gradient_[j * kRow];
    for (std::size_t i = 0; i < kRow; ++i) row[i] += hidden_error * input[i];
    output_gradient[j] += output_error * answers_[j];
  }
  output_gradient[hidden_] += output_error;
}

void BackPropagation::move_weights() {
  constexpr double kGrow = 1.2;
  constexpr double kShrink = 0.5;
  constexpr double kSmallestStep = 1e-6;
  constexpr double kLargestStep = 0.03;  // keeps weights about as small as the paper's
  for (std::size_t w = 0; w < weights_.size(); ++w) {
    const double turn = gradient_[w] * previous_[w];
    if (turn > 0) step_[w] = std::min(step_[w] * kGrow, kLargestStep);
    if (turn < 0) {
      step_[w] = std::max(step_[w] * kShrink, kSmallestStep);
      gradient_[w] = 0;
    }
    if (gradient_[w] > 0) weights_[w] -= step_[w];
    if (gradient_[w] < 0) weights_[w] += step_[w];
  }
}

int BackPropagation::epoch() {
  gradient_.assign(weights_.size(), 0.0);
  int correct = 0;
  for (std::size_t k = 0; k < table_.size(); ++k) {
    const double out = answer(k);
    correct += (out >= 0.5) == table_[k] ? 1 : 0;
    add_gradient(k, out - (table_[k] ? 1.0 : 0.0));
  }
  move_weights();
  std::swap(previous_, gradient_);
  return correct;
}

HiddenLayerNet BackPropagation::rounded_net() const {
  HiddenLayerNet net;
  for (std::size_t j = 0; j < hidden_; ++j) {
    Neuron neuron{};
    for (std::size_t i = 0; i < kNetInputs; ++i) {
      neuron.weight[i] = hundredths(weights_[j * kRow + i]);
    }
    neuron.bias = hundredths(weights_[j * kRow + kNetInputs]);
    net.hidden.push_back(neuron);
    net.output_weight.push_back(hundredths(weights_[hidden_ * kRow + j]));
  }
  net.output_bias = hundredths(weights_.back());
  return net;
}

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
    int max_right = 0;
    result.restarts = start;
    for (result.epochs = 0; result.epochs < training.max_epochs && !good(best); ++result.epochs) {
      const int right = net.epoch();
      if (right < max_right || (right == max_right && right < kDescriptors)) continue;
      max_right = right;
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
