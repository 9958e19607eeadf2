// Nets on xsimd batches, pixels across lanes, compiled once for every instruction-set level.
//
// float_bits reads packed bits. Where BMI2 is present (the AVX2 level and up) the dark pixels of a
// word are gathered first (one pext for each neighbour), so that no lane computes a light pixel,
// and decisions are scattered back by pdep: about 20 operations a word against 140 a batch of 16
// that they save. float_bytes reads bytes 0/1, passes over batches without a dark pixel, and
// multiplies.
#include "nets/float_nets.hpp"
#include "nets/model_passes.hpp"
#include "nets/packed_words.hpp"

namespace thinbench {
namespace {

[[gnu::always_inline]] inline MaskInputs mask_inputs(const PackedNeighbours& from, Index first) {
  MaskInputs inputs;
  for (int i = 0; i < kNetInputs; ++i) inputs.mask[i] = lane_mask(from.n[i] >> first);
  return inputs;
}

/// Decisions for the dark pixels of one word; garbage elsewhere is cut by the caller's AND.
template <class Net>
[[gnu::always_inline]] inline std::uint64_t decide_word(const RuleModel& model, std::uint64_t dark,
                                                        PackedNeighbours neighbours) {
  std::uint64_t stays = 0;
#ifdef __BMI2__
  for (std::uint64_t& n : neighbours.n) n = _pext_u64(n, dark);
  const Index count = __builtin_popcountll(dark);
  for (Index first = 0; first < count; first += kFloatLanes) {
    stays |= Net::decide(model, mask_inputs(neighbours, first)) << first;
  }
  return _pdep_u64(stays, dark);
#else
  constexpr std::uint64_t lanes = (std::uint64_t{1} << kFloatLanes) - 1;
  for (Index first = 0; first < kWordBits; first += kFloatLanes) {
    if ((dark >> first & lanes) == 0) continue;
    stays |= Net::decide(model, mask_inputs(neighbours, first)) << first;
  }
  return stays;
#endif
}

template <class Net>
std::uint64_t float_bits(const RuleModel* model, const ConstBitPlaneView& source,
                         const BitPlaneView& target, const Band& band) {
  const Index stride = source.stride;
  return for_each_run(band, [&](Index y, Index from, Index to) {
    return decide_words(source.row(y), target.row(y), from, to,
                        [&](std::uint64_t dark, const std::uint64_t* here) {
                          return decide_word<Net>(*model, dark, packed_neighbours(here, stride));
                        });
  });
}

[[gnu::always_inline]] inline NumberInputs number_inputs(const std::uint8_t* here, Index stride) {
  const std::uint8_t* above = here - stride;
  const std::uint8_t* below = here + stride;
  return {{load_bytes(here + 1), load_bytes(above + 1), load_bytes(above), load_bytes(above - 1),
           load_bytes(here - 1), load_bytes(below - 1), load_bytes(below), load_bytes(below + 1)}};
}

template <class Net>
bool float_bytes_row(const RuleModel& model, const std::uint8_t* here, Index stride,
                     std::uint8_t* target, Index count) {
  bool changed = false;
  for (Index x = 0; x < count; x += kFloatLanes) {
    const std::uint64_t dark = bits_of(load_bytes(here + x) != FloatBatch(0.0F));
    const std::uint64_t stays =
        dark == 0 ? 0 : dark & Net::decide(model, number_inputs(here + x, stride));
    changed = changed || stays != dark;
    for (Index i = 0; i < kFloatLanes; ++i) target[x + i] = stays >> i & 1;
  }
  return changed;
}

template <class Net>
std::uint64_t float_bytes(const RuleModel* model, const ConstBytePlaneView& source,
                          const BytePlaneView& target, const Band& band) {
  return for_each_run(band, [&](Index y, Index from, Index to) {
    return float_bytes_row<Net>(*model, source.row(y) + from, source.stride, target.row(y) + from,
                                to - from);
  });
}

using Sigmoid = TwoLayerNet<Activation::kSigmoid>;
using Linear = TwoLayerNet<Activation::kLinear>;

/// Descriptors 0 to 255, a batch at a time.
template <Activation activation>
void hidden_values(const RuleModel& model, float* values) {
  for (Index first = 0; first < 256; first += kFloatLanes) {
    PackedNeighbours neighbours{};
    for (Index lane = 0; lane < kFloatLanes; ++lane) {
      for (int i = 0; i < kNetInputs; ++i) {
        neighbours.n[i] |= static_cast<std::uint64_t>((first + lane) >> i & 1) << lane;
      }
    }
    const MaskInputs inputs = mask_inputs(neighbours, 0);
    for (int j = 0; j < kHiddenNeurons; ++j) {
      TwoLayerNet<activation>::hidden(model, inputs, j).store_unaligned(values + 256 * j + first);
    }
  }
}

}  // namespace

template <>
constinit const HiddenValues IsaModelPasses<kThisIsa>::kHiddenValues = {
    &hidden_values<Activation::kSigmoid>, &hidden_values<Activation::kLinear>};

template <>
constinit const NetPasses<std::uint64_t> IsaModelPasses<kThisIsa>::kFloatBits = {
    &float_bits<Sigmoid>, &float_bits<Linear>, &float_bits<ClusterOfNets>};

template <>
constinit const NetPasses<std::uint8_t> IsaModelPasses<kThisIsa>::kFloatBytes = {
    &float_bytes<Sigmoid>, &float_bytes<Linear>, &float_bytes<ClusterOfNets>};

}  // namespace thinbench
