// The nets' equations on bytes 0 and 1, as plain loops over strips of a row that compilers
// vectorise at -O3. Compiled for every ISA: the baseline for hand-written SIMD. The equations have
// no branch, so background pixels are computed too.
#include "core/exported.hpp"
#include "rules/exponential.hpp"
#include "techniques/net_kernels.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

constexpr Index kStrip = 64;  // rows are padded to whole strips

/// Background is 0.0, foreground 1.0.
struct StripInputs {
  float n[kNetInputs][kStrip];
};

// Below AVX-512, where make_kernels gives none, nothing uses this and net_input.
[[maybe_unused]] void load_inputs(StripInputs& inputs, const std::uint8_t* here, Index stride) {
  const Index offset[kNetInputs] = {1,  1 - stride, -stride, -1 - stride,
                                    -1, stride - 1, stride,  stride + 1};
  for (int i = 0; i < kNetInputs; ++i) {
    for (Index x = 0; x < kStrip; ++x) inputs.n[i][x] = static_cast<float>(here[x + offset[i]]);
  }
}

[[maybe_unused]] void net_input(const Neuron& neuron, const float (*inputs)[kStrip], float* sum) {
  for (Index x = 0; x < kStrip; ++x) sum[x] = neuron.bias;
  for (int i = 0; i < kNetInputs; ++i) {
    for (Index x = 0; x < kStrip; ++x) sum[x] = sum[x] + neuron.weight[i] * inputs[i][x];
  }
}

template <Activation activation>
float activated(float x) {
  if constexpr (activation == Activation::sigmoid) return sigmoid(x);
  const float inside = 0.166F * x + 0.5F;
  const float at_least_0 = x < -3.0F ? 0.0F : inside;
  return x > 3.0F ? 1.0F : at_least_0;
}

template <Activation activation>
struct TwoLayerStrip {
  static void decide(const NetModel& model, const StripInputs& inputs, std::uint8_t* keep) {
    float hidden[kHiddenNeurons][kStrip];
    for (int j = 0; j < kHiddenNeurons; ++j) {
      net_input(model.two_layer.hidden[j], inputs.n, hidden[j]);
      for (float& value : hidden[j]) value = activated<activation>(value);
    }
    float output[kStrip];
    net_input(model.two_layer.output, hidden, output);
    for (Index x = 0; x < kStrip; ++x) keep[x] = activated<activation>(output[x]) >= 0.5F ? 1 : 0;
  }
};

struct ClusterStrip {
  static void decide(const NetModel& model, const StripInputs& inputs, std::uint8_t* keep) {
    int net[kStrip];
    find_nets(model, inputs, net);
    float sum[kStrip];
    for (Index x = 0; x < kStrip; ++x) sum[x] = model.cluster_column[kNetInputs][net[x]];
    for (int i = 0; i < kNetInputs; ++i) {
      for (Index x = 0; x < kStrip; ++x) {
        sum[x] = sum[x] + model.cluster_column[i][net[x]] * inputs.n[i][x];
      }
    }
    for (Index x = 0; x < kStrip; ++x) keep[x] = sum[x] >= 0.0F ? 1 : 0;
  }

 private:
  static void find_nets(const NetModel& model, const StripInputs& inputs, int* net) {
    float descriptor[kStrip] = {};
    for (int i = 0; i < kNetInputs; ++i) {
      for (Index x = 0; x < kStrip; ++x) {
        descriptor[x] = descriptor[x] + static_cast<float>(1 << i) * inputs.n[i][x];
      }
    }
    for (Index x = 0; x < kStrip; ++x) net[x] = 0;
    for (int run = 0; run + 1 < model.cluster.count; ++run) {
      for (Index x = 0; x < kStrip; ++x) net[x] += descriptor[x] > model.cluster_last[run] ? 1 : 0;
    }
  }
};

template <class Strip>
bool row(const NetModel& model, const std::uint8_t* fixed, const std::uint8_t* here, Index stride,
         std::uint8_t* target, Index count) {
  std::uint8_t changed = 0;
  for (Index x = 0; x < count; x += kStrip) {
    StripInputs inputs;
    load_inputs(inputs, here + x, stride);
    std::uint8_t keep[kStrip];
    Strip::decide(model, inputs, keep);
    if (fixed != nullptr) {
      for (Index i = 0; i < kStrip; ++i) keep[i] |= fixed[x + i];
    }
    for (Index i = 0; i < kStrip; ++i) {
      const std::uint8_t next = here[x + i] & keep[i];
      changed = static_cast<std::uint8_t>(changed | (next ^ here[x + i]));
      target[x + i] = next;
    }
  }
  return changed != 0;
}

template <class Strip>
std::uint64_t pass(const TableRule* rule, const std::uint8_t* fixed,
                   const ConstBytePlaneView& source, const BytePlaneView& target,
                   const Band& band) {
  return for_each_run(band, [&](Index y, Index from, Index to) {
    return row<Strip>(net_of(rule), fixed == nullptr ? nullptr : fixed + from, source.row(y) + from,
                      source.stride, target.row(y) + from, to - from);
  });
}

/// Empty below AVX-512: docs/experiments.md#nets.
consteval AutovecNetKernels make_kernels() {
  constexpr Isa isa = Isa::THINBENCH_ISA;
  if constexpr (isa == Isa::avx512 || isa == Isa::avx512icl) {
    return {{&pass<TwoLayerStrip<Activation::sigmoid>>, &pass<TwoLayerStrip<Activation::linear>>,
             &pass<ClusterStrip>}};
  } else {
    return {};
  }
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const AutovecNetKernels Exported<AutovecNetKernels, Isa::THINBENCH_ISA>::kKernels =
    make_kernels();

}  // namespace thinbench::detail
