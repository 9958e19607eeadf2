// The weights of the paper's nets as plain data. Rule::from_net makes a rule of them.
#pragma once

namespace thinbench {

/// The inputs of a net: the neighbours n0 (east) to n7, anticlockwise; foreground is 1.
inline constexpr int kNetInputs = 8;
inline constexpr int kHiddenNeurons = 8;

/// The activation of the neurons of the two-layer net.
enum class Activation {
  sigmoid,  // equation (1): 1 / (1 + e^-x)
  linear,   // equation (2): 0.166 x + 0.5 within [-3, 3], else 0 or 1
};

/// A neuron. Its net input is bias + weight[0] n0 + ... + weight[7] n7, summed in this order in
/// single precision, with one rounding per operation.
struct Neuron {
  float weight[kNetInputs];
  float bias;
};

/// The 8-8-1 net of section 3.2. A foreground pixel is kept where the output is 0.5 or more.
struct TwoLayerWeights {
  Neuron hidden[kHiddenNeurons];
  Neuron output;  // its inputs are the hidden neurons
};

/// One net of the cluster of section 3.3, for the descriptors from its predecessor's `last` + 1 to
/// `last`. A foreground pixel is kept where the net input is at least 0.
struct ClusterNet {
  int last;
  Neuron neuron;
};

inline constexpr int kMaxClusterNets = 16;

/// `nets[0]` begins at descriptor 0, `nets[count - 1]` ends at 255.
struct ClusterWeights {
  int count;
  ClusterNet nets[kMaxClusterNets];
};

/// Table 1 of the paper.
inline constexpr TwoLayerWeights kPaperTwoLayer = {
    {{{7.18F, 0.56F, 2.16F, -3.48F, 13.69F, -3.62F, 2.02F, 0.54F}, -6.25F},
     {{-2.32F, -0.68F, -6.45F, -0.64F, -2.26F, 4.54F, 10.04F, 4.49F}, 4.88F},
     {{-1.92F, 5.1F, -12.08F, 2.36F, 1.34F, -0.35F, -6.11F, -0.71F}, 1.34F},
     {{-8.38F, 0.21F, 5.35F, 1.45F, 6.78F, 2.46F, -2.52F, -0.92F}, 1.45F},
     {{9.19F, -3.36F, 0.93F, 0.58F, 3.45F, 0.2F, 2.05F, -4.7F}, -0.65F},
     {{6.7F, 0.37F, 5.54F, 1.33F, -2.06F, -1.23F, -2.78F, 1.81F}, -4.38F},
     {{3.31F, 2.47F, 0.55F, -0.99F, 7.86F, 0.89F, -4.73F, -0.08F}, -4.75F},
     {{-1.11F, 0.72F, 6.8F, -1.31F, 2.96F, 2.56F, 2.03F, 1.94F}, -3.09F}},
    {{-19.88F, 18.22F, 14.24F, 11.98F, -13.4F, 15.2F, 8.96F, -11.04F}, -0.75F}};

}  // namespace thinbench
