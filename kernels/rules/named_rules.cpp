// The tables of named rules, each computed from its definition.

#include "thinbench/named_rules.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "rules/nets.hpp"
#include "rules/trained_cluster.hpp"
#include "rules/window.hpp"
#include "thinbench/rule_notation.hpp"

namespace thinbench {
namespace {

using detail::pixel_of;
using detail::WindowPattern;

/// The neighbours n0 (east) to n7, anticlockwise.
using Ring = std::array<bool, 8>;

constexpr Ring ring_of(std::size_t window) {
  Ring ring{};
  for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = pixel_of(window, kDescriptorOrder[i]);
  return ring;
}

constexpr bool centre(std::size_t window) {
  return pixel_of(window, WindowTable::kCentre);
}

constexpr bool is_inside(std::size_t window) {
  const Ring n = ring_of(window);
  return n[0] && n[2] && n[4] && n[6];
}

/// The number of changes from background to foreground around the pixel.
constexpr int transitions(const Ring& n) {
  int count = 0;
  for (std::size_t i = 0; i < 8; ++i) count += !n[i] && n[(i + 1) % 8] ? 1 : 0;
  return count;
}

/// The number of 8-connected parts of the neighbours, without the pixel itself: each begins,
/// anticlockwise, behind a background 4-neighbour. Four foreground 4-neighbours: one part.
constexpr int parts(const Ring& n) {
  int count = 0;
  for (std::size_t i = 0; i < 8; i += 2) count += !n[i] && (n[i + 1] || n[(i + 2) % 8]) ? 1 : 0;
  return count;
}

/// Only the two corners of one side are foreground.
constexpr bool is_gap_of_side(const Ring& n) {
  for (std::size_t i = 1; i < 8; i += 2) {
    if (n[i] && n[(i + 2) % 8] && std::count(n.begin(), n.end(), true) == 2) return true;
  }
  return false;
}

/// Pixels become foreground that join neighbours which are not connected without them; 119 windows.
/// The pixel between the two corners of a side becomes foreground, the one in front of it does not.
constexpr WindowTable kBridge[] = {make_window_table([](std::size_t window) {
  const Ring n = ring_of(window);
  return centre(window) || (parts(n) >= 2 && !is_gap_of_side(n));
})};

/// Isolated pixels vanish.
constexpr WindowTable kClean[] = {make_window_table(
    [](std::size_t window) { return centre(window) && (window & detail::kRingBits) != 0; })};

/// Pixels become foreground on which background is connected by a corner only.
constexpr WindowTable kDiag[] = {make_window_table([](std::size_t window) {
  const Ring n = ring_of(window);
  bool fills = false;
  for (std::size_t i = 0; i < 8; i += 2) fills = fills || (n[i] && !n[i + 1] && n[(i + 2) % 8]);
  return centre(window) || fills;
})};

constexpr WindowTable kDilate[] = {
    make_window_table([](std::size_t window) { return window != 0; })};

/// Pixels remain whose foreground neighbours are consecutive around them, or that have none.
constexpr WindowTable kEndpoints[] = {make_window_table([](std::size_t window) {
  const bool surrounded = (window & detail::kRingBits) == detail::kRingBits;
  return centre(window) && transitions(ring_of(window)) <= 1 && !surrounded;
})};

constexpr WindowTable kErode[] = {
    make_window_table([](std::size_t window) { return window + 1 == WindowTable::kWindows; })};

/// Pixels with four foreground 4-neighbours become foreground.
constexpr WindowTable kFill[] = {
    make_window_table([](std::size_t window) { return centre(window) || is_inside(window); })};

/// The middle of an H, upright or not, vanishes.
constexpr WindowTable kHbreak[] = {make_window_table([](std::size_t window) {
  const std::size_t lying = detail::pattern_of("111 .1. 111").foreground;
  const bool is_h = window == lying || window == detail::permuted(lying, detail::kRotateBy90);
  return centre(window) && !is_h;
})};

/// Foreground where five or more of the nine pixels are.
constexpr WindowTable kMajority[] = {
    make_window_table([](std::size_t window) { return std::popcount(window) >= 5; })};

/// Pixels with four foreground 4-neighbours vanish: the outline remains.
constexpr WindowTable kRemove[] = {
    make_window_table([](std::size_t window) { return centre(window) && !is_inside(window); })};

/// Pixels vanish whose only neighbour is a diagonal one.
constexpr WindowTable kSpur[] = {make_window_table([](std::size_t window) {
  const Ring n = ring_of(window);
  const bool diagonal = n[1] || n[3] || n[5] || n[7];
  const bool single = std::count(n.begin(), n.end(), true) == 1;
  return centre(window) && !(diagonal && single);
})};

/// Guo and Hall's conditions with the neighbours as Lam, Lee and Suen number them.
constexpr bool is_removed_by_guo_hall(const Ring& n) {
  int n1 = 0, n2 = 0;
  for (std::size_t i = 0; i < 8; i += 2) {
    n1 += n[i] || n[i + 1] ? 1 : 0;
    n2 += n[i + 1] || n[(i + 2) % 8] ? 1 : 0;
  }
  const int n_min = std::min(n1, n2);
  return parts(n) == 1 && n_min >= 2 && n_min <= 3 && !((n[1] || n[2] || !n[7]) && n[0]);
}

/// The second sub-iteration is the first rotated by 180 degrees.
constexpr WindowTable make_thin(int sub_iteration) {
  return make_window_table([sub_iteration](std::size_t window) {
    Ring n = ring_of(window);
    if (sub_iteration == 1) std::rotate(n.begin(), n.begin() + 4, n.end());
    return centre(window) && !is_removed_by_guo_hall(n);
  });
}

constexpr WindowTable kThin[] = {make_thin(0), make_thin(1)};

/// Removes the pixels that match a structuring element.
constexpr WindowTable removing(const WindowPattern& element) {
  return make_window_table(
      [&](std::size_t window) { return centre(window) && !element.matches(window); });
}

using EightTables = std::array<WindowTable, 8>;

constexpr EightTables make_gonzalez_woods() {
  EightTables tables;
  WindowPattern element = detail::pattern_of("000 .1. 111");
  for (WindowTable& table : tables) {
    table = removing(element);
    element = permuted(element, detail::kRotateBy45);
  }
  return tables;
}

/// Two elements in four rotations by 90 degrees: both, then both rotated, and so on; otherwise all
/// of the first, then all of the second.
constexpr EightTables make_rotations(std::string_view first, std::string_view second,
                                     bool alternate) {
  EightTables tables;
  WindowPattern side = detail::pattern_of(first);
  WindowPattern corner = detail::pattern_of(second);
  for (std::size_t i = 0; i < 4; ++i) {
    tables[alternate ? 2 * i : i] = removing(side);
    tables[alternate ? 2 * i + 1 : i + 4] = removing(corner);
    side = permuted(side, detail::kRotateBy90);
    corner = permuted(corner, detail::kRotateBy90);
  }
  return tables;
}

constexpr EightTables kGonzalezWoods = make_gonzalez_woods();
constexpr EightTables kGolayL = make_rotations("000 .1. 111", ".00 110 .1.", true);
constexpr EightTables kPrune = make_rotations(".00 110 .00", "100 010 000", false);

constexpr WindowTable kLife[] = {make_window_table([](std::size_t window) {
  const int neighbours = std::popcount(window & detail::kRingBits);
  return neighbours == 3 || (centre(window) && neighbours == 2);
})};

constexpr WindowTable kSigmoidNet[] = {detail::decisions_of(kPaperTwoLayer, Activation::sigmoid)};
constexpr WindowTable kLinearNet[] = {detail::decisions_of(kPaperTwoLayer, Activation::linear)};
constexpr WindowTable kCluster[] = {detail::decisions_of(detail::kTrainedCluster)};

constexpr std::string_view kPaper =
    "Lazea, Muresan and Lupu, Image processing algorithms used in robotics applications, 1999";
constexpr std::string_view kBwmorph = "bwmorph of Octave's image package";
constexpr std::string_view kPratt =
    "bwmorph of Octave's image package; Pratt, Digital Image Processing";
constexpr std::string_view kGonzalez = "Gonzalez and Woods, Digital Image Processing, section 9.5";

constexpr NamedRule kNamedRules[] = {
    {"bridge", "joins neighbours that are not connected", kPratt, kBridge},
    {"clean", "removes isolated pixels", kBwmorph, kClean},
    {"diag", "fills where background is connected by a corner only", kPratt, kDiag},
    {"dilate", "foreground where any of the nine pixels is", kBwmorph, kDilate},
    {"endpoints", "keeps end points", kBwmorph, kEndpoints},
    {"erode", "foreground where all nine pixels are", kBwmorph, kErode, Border::foreground},
    {"fill", "fills holes of one pixel", kBwmorph, kFill},
    {"golay_l", "thinning by the elements L of Golay's alphabet on the square grid",
     "Sonka, Hlavac and Boyle, Image Processing, Analysis, and Machine Vision", kGolayL,
     Border::background, kUnlimited},
    {"gonzalez_woods", "thinning by one element in eight rotations", kGonzalez, kGonzalezWoods,
     Border::background, kUnlimited},
    {"hbreak", "removes the middle of an H", kBwmorph, kHbreak},
    {"life", "Conway's game of life, B3/S23", "Gardner, Scientific American 223(4), 1970", kLife},
    {"majority", "foreground where five or more of the nine pixels are", kBwmorph, kMajority},
    {"net_single_layer_cluster", "the cluster of twelve single-layer nets, equations (5) to (7)",
     kPaper, kCluster, Border::background, kUnlimited},
    {"net_two_layer_linear", "the two-layer net of Table 1 with linear threshold (2)", kPaper,
     kLinearNet, Border::background, kUnlimited},
    {"net_two_layer_sigmoid", "the two-layer net of Table 1 with sigmoid (1)", kPaper, kSigmoidNet,
     Border::background, kUnlimited},
    {"prune", "removes end points, eight kinds one after the other", kGonzalez, kPrune},
    {"remove", "removes inner pixels, so that outlines remain", kBwmorph, kRemove},
    {"spur", "removes pixels whose only neighbour is a diagonal one", kBwmorph, kSpur},
    {"thin", "Guo and Hall's thinning, as the rule guo_hall_skimage",
     "Guo and Hall, CACM 32(3), 1989; Lam, Lee and Suen, IEEE PAMI 14(9), 1992", kThin,
     Border::background, kUnlimited},
};

}  // namespace

std::span<const NamedRule> named_rules() {
  return kNamedRules;
}

const NamedRule* find_named_rule(std::string_view name) {
  const auto* const found = std::find_if(std::begin(kNamedRules), std::end(kNamedRules),
                                         [&](const NamedRule& rule) { return rule.name == name; });
  return found == std::end(kNamedRules) ? nullptr : found;
}

}  // namespace thinbench
