#include "reference.hpp"

#include <array>
#include <limits>

#include "nets/trained_cluster.hpp"

namespace thinbench::reference {
namespace {

constexpr int kNoLimit = std::numeric_limits<int>::max();

template <const TwoLayerWeights& net, Activation activation, int max_iterations>
int two_layer(ConstImageView source, ImageView destination) {
  return net_two_layer(net, activation, max_iterations, source, destination);
}

template <int max_iterations>
int cluster(ConstImageView source, ImageView destination) {
  return net_single_layer_cluster(kTrainedCluster, max_iterations, source, destination);
}

template <int (*function)(Border, ConstImageView, ImageView), Border border>
int thinning(ConstImageView source, ImageView destination) {
  return function(border, source, destination);
}

int scan_all_directions(ConstImageView source, ImageView destination) {
  return skeleton_scan(Directions{}, source, destination);
}

struct NamedThinning {
  std::string_view operation;
  Thinning function;
};

constexpr std::array kThinnings = {
    NamedThinning{"thin_naccache_shinghal", &thin_naccache_shinghal},
    NamedThinning{"thin_zhang_suen", &thinning<&thin_zhang_suen, Border::background>},
    NamedThinning{"thin_zhang_suen_keep_border", &thinning<&thin_zhang_suen, Border::keep>},
    NamedThinning{"thin_guo_hall", &thinning<&thin_guo_hall, Border::background>},
    NamedThinning{"thin_guo_hall_keep_border", &thinning<&thin_guo_hall, Border::keep>},
    NamedThinning{"thin_spta_directional", &thinning<&thin_spta_directional, Border::background>},
    NamedThinning{"thin_mb2", &thinning<&thin_mb2, Border::background>},
    NamedThinning{"thin_spta", &thin_spta},
    NamedThinning{"skeleton_scan", &scan_all_directions},
    NamedThinning{"net_two_layer_sigmoid",
                  &two_layer<kPaperTwoLayer, Activation::sigmoid, kNoLimit>},
    NamedThinning{"net_two_layer_sigmoid_pass",
                  &two_layer<kPaperTwoLayer, Activation::sigmoid, 1>},
    NamedThinning{"net_two_layer_rounded",
                  &two_layer<kRoundedTwoLayer, Activation::sigmoid, kNoLimit>},
    NamedThinning{"net_two_layer_linear",
                  &two_layer<kPaperTwoLayer, Activation::linear, kNoLimit>},
    NamedThinning{"net_two_layer_linear_pass", &two_layer<kPaperTwoLayer, Activation::linear, 1>},
    NamedThinning{"net_single_layer_cluster", &cluster<kNoLimit>},
    NamedThinning{"net_single_layer_cluster_pass", &cluster<1>},
};

}  // namespace

Thinning find_thinning(std::string_view operation) {
  for (const NamedThinning& named : kThinnings) {
    if (named.operation == operation) return named.function;
  }
  return nullptr;
}

}  // namespace thinbench::reference
