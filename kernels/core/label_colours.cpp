#include "core/label_colours.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace thinbench::detail {
namespace {

using LabelValue = std::int32_t;
using Colour = LabelColours::Colour;
using Pairs = std::set<std::pair<LabelValue, LabelValue>>;

/// Whether pixels of two rows with the same place have different labels.
bool touch_somewhere(const LabelValue* a, const LabelValue* b, Index count) {
  std::uint32_t found = 0;
  for (Index x = 0; x < count; ++x) {
    found |= static_cast<std::uint32_t>((a[x] != b[x]) & (a[x] != 0) & (b[x] != 0));
  }
  return found != 0;
}

void add_pairs(const LabelValue* a, const LabelValue* b, Index count, Pairs& pairs) {
  if (!touch_somewhere(a, b, count)) return;
  std::pair<LabelValue, LabelValue> last;  // of labels side by side there are many pixels
  for (Index x = 0; x < count; ++x) {
    if (a[x] == b[x] || a[x] == 0 || b[x] == 0) continue;
    const std::pair<LabelValue, LabelValue> pair = std::minmax({a[x], b[x]});
    if (pair != last) pairs.insert(pair);
    last = pair;
  }
}

/// The pairs of labels with pixels that are 8-neighbours, the lower first.
Pairs touching(const ConstLabelView& labels) {
  Pairs pairs;
  const Index width = labels.width;
  if (width == 0) return pairs;  // there may be no rows to point to
  for (Index y = 0; y < labels.height; ++y) {
    const LabelValue* row = labels.row(y);
    add_pairs(row, row + 1, width - 1, pairs);
    if (y + 1 == labels.height) break;
    const LabelValue* below = labels.row(y + 1);
    add_pairs(row, below, width, pairs);
    add_pairs(row, below + 1, width - 1, pairs);
    add_pairs(row + 1, below, width - 1, pairs);
  }
  return pairs;
}

/// The colours of labels that touch others; all others have the first. Labels in ascending order
/// get the lowest colour that none of their neighbours has.
std::unordered_map<LabelValue, Colour> colours_of(const Pairs& pairs) {
  std::unordered_map<LabelValue, std::vector<LabelValue>> lower_neighbours;
  std::set<LabelValue> labels;
  for (const auto& [lower, higher] : pairs) {
    lower_neighbours[higher].push_back(lower);
    labels.insert({lower, higher});
  }
  std::unordered_map<LabelValue, Colour> colours;
  std::vector<Colour> taken;
  for (const LabelValue label : labels) {
    taken.clear();
    for (const LabelValue neighbour : lower_neighbours[label]) taken.push_back(colours[neighbour]);
    std::sort(taken.begin(), taken.end());
    Colour free = 1;
    for (const Colour colour : taken) free += colour == free ? 1 : 0;
    colours[label] = free;
  }
  return colours;
}

}  // namespace

LabelColours::LabelColours(const ConstLabelView& labels)
    : labels_(labels), mask_(labels.width, labels.height) {
  const Pairs pairs = touching(labels);
  if (!pairs.empty()) paint(colours_of(pairs));
}

void LabelColours::paint(const std::unordered_map<LabelValue, Colour>& colours) {
  painted_.resize(static_cast<std::size_t>(labels_.width * labels_.height));
  auto next = painted_.begin();
  LabelValue last = 0;
  Colour colour = 0;
  for (Index y = 0; y < labels_.height; ++y) {
    for (Index x = 0; x < labels_.width; ++x) {
      if (const LabelValue label = labels_.row(y)[x]; label != last) {
        const auto found = colours.find(label);
        colour = label == 0 ? 0 : found == colours.end() ? 1 : found->second;
        count_ = std::max(count_, colour);
        last = label;
      }
      *next++ = colour;
    }
  }
}

void LabelColours::draw_mask_row(Index y, Colour colour) {
  std::uint8_t* const to = mask_.view().row(y);
  const auto draw = [&](const auto* from, auto is_drawn) {
    for (Index x = 0; x < labels_.width; ++x) to[x] = is_drawn(from[x]) ? 255 : 0;
  };
  if (painted_.empty()) {
    draw(labels_.row(y), [](LabelValue label) { return label != 0; });
  } else {
    draw(painted_.data() + y * labels_.width, [colour](Colour at) { return at == colour; });
  }
}

}  // namespace thinbench::detail
