#include "training/back_propagation.hpp"

#include <algorithm>
#include <cmath>

namespace thinbench {
namespace {

double sigmoid_of(double x) {
  return 1.0 / (1.0 + portable_exp(-x));
}

float hundredths(double value) {
  return static_cast<float>(std::round(value * 100) / 100);
}

}  // namespace

BackPropagation::BackPropagation(const KeepTable& table, int hidden, Random& random)
    : table_(table), hidden_(static_cast<std::size_t>(hidden)), answers_(hidden_) {
  constexpr double kFirstStep = 0.02;
  weights_.resize(hidden_ * kRow + hidden_ + 1);
  for (double& weight : weights_) weight = random.symmetric(1.0);
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

}  // namespace thinbench
