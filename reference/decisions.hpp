// The published decisions on one foreground pixel, for any types of truth value and number: the
// references use bool and float; the count of operations uses types that count.
#pragma once

#include <cmath>

#include "thinbench/nets.hpp"

namespace thinbench::reference {

/// The sides of section 3.1, in the order of its expressions.
enum class Side { left, right, top, bottom };

/// B4, B0, B2 or B6 over the neighbours, n[0] east, then anticlockwise; foreground is TRUE.
/// Complemented literals read `m`, which differs from `n` only in the sequential SPTA.
template <class Truth>
Truth expression(Side side, const Truth (&n)[8], const Truth (&m)[8]) {
  switch (side) {
    case Side::left:
      return n[0] && (n[1] || n[2] || n[6] || n[7]) && (n[2] || !m[3]) && (!m[5] || n[6]);
    case Side::right:
      return n[4] && (n[2] || n[3] || n[5] || n[6]) && (n[6] || !m[7]) && (!m[1] || n[2]);
    case Side::top:
      return n[6] && (n[0] || n[4] || n[5] || n[7]) && (n[0] || !m[1]) && (!m[3] || n[4]);
    case Side::bottom:
      break;
  }
  return n[2] && (n[0] || n[1] || n[3] || n[4]) && (n[4] || !m[5]) && (!m[7] || n[0]);
}

/// The neighbour on a side. A pixel is an edge point of the side if it is background.
constexpr int neighbour_on(Side side) {
  constexpr int neighbours[] = {4, 0, 2, 6};
  return neighbours[static_cast<int>(side)];
}

/// Each expression is FALSE for an edge point of its side that is a break or end point.
template <class Truth>
struct Expressions {
  Truth b0, b2, b4, b6;
};

template <class Truth>
Expressions<Truth> expressions_of(const Truth (&n)[8]) {
  return {expression(Side::right, n, n), expression(Side::top, n, n), expression(Side::left, n, n),
          expression(Side::bottom, n, n)};
}

template <class Number, class Truth>
Number false_count(const Expressions<Truth>& b) {
  const auto one_if_false = [](const Truth& truth) { return truth ? Number(0) : Number(1); };
  return one_if_false(b.b0) + one_if_false(b.b2) + one_if_false(b.b4) + one_if_false(b.b6);
}

/// A foreground pixel is kept unless one or two of its expressions are FALSE.
template <class Number>
bool keeps_with(Number false_count) {
  return false_count != Number(1) && false_count != Number(2);
}

/// bias + w0 n0 + w1 n1 + ... + w7 n7, in this order.
template <class Number>
Number net_input(const Neuron& neuron, const Number (&n)[8]) {
  Number sum(neuron.bias);
  for (int i = 0; i < 8; ++i) sum = sum + Number(neuron.weight[i]) * n[i];
  return sum;
}

/// Equation (1) or (2).
template <Activation activation, class Number>
Number activated(Number x) {
  using std::exp;
  if constexpr (activation == Activation::sigmoid) {
    return Number(1.0F) / (Number(1.0F) + exp(-x));
  } else {
    if (x > Number(3.0F)) return Number(1.0F);
    if (x < Number(-3.0F)) return Number(0.0F);
    return Number(0.166F) * x + Number(0.5F);
  }
}

/// Equation (3), for each hidden neuron and for the output.
template <Activation activation, class Number>
Number two_layer_output(const TwoLayerWeights& net, const Number (&n)[8]) {
  Number hidden[8];
  for (int j = 0; j < 8; ++j) hidden[j] = activated<activation>(net_input(net.hidden[j], n));
  return activated<activation>(net_input(net.output, hidden));
}

/// Equation (4): whether a foreground pixel is kept.
template <Activation activation, class Number>
bool two_layer_keeps(const TwoLayerWeights& net, const Number (&n)[8]) {
  return two_layer_output<activation>(net, n) >= Number(0.5F);
}

/// Equations (5) to (7): the descriptor selects the net, which decides whether a foreground pixel
/// is kept.
template <class Number>
bool cluster_keeps(const ClusterWeights& cluster, const Number (&n)[8]) {
  using std::ldexp;
  Number k = n[0] * ldexp(Number(1.0F), 0);
  for (int i = 1; i < 8; ++i) k = k + n[i] * ldexp(Number(1.0F), i);
  const ClusterNet* net = cluster.nets;
  while (k > Number(static_cast<float>(net->last))) ++net;
  return net_input(net->neuron, n) >= Number(0.0F);
}

}  // namespace thinbench::reference
