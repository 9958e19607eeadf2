// Textbook two-pass labelling of bytes: the first pass takes provisional labels from the neighbours
// already visited and joins them in a union-find forest; the second adds every pixel to its region.
//
// Cost per pixel: up to 4 look-ups of neighbours' labels, 4 bytes written and read again, and 12
// operations to sum, with unpredictable branches. The baseline for run-based labelling:
// docs/experiments.md#regions.
#include <algorithm>

#include "techniques/regions.hpp"

namespace thinbench::detail {

UnionFind::UnionFind(Index width, Index height)
    : image_(width, height), labels_(width, height), store_(width) {}

void UnionFind::find(const ConstImageView& source, bool with_holes, Regions& found) {
  label(source);
  store_.list_objects(found.objects);
  store_.list_holes(found.holes);
  const LabelTables& tables = store_.tables();
  for (Index y = 0; y < source.height; ++y) {
    const std::uint8_t* const pixels = image_.view().row(y);
    const Label* const labels = labels_.row(y);
    for (Index x = 0; x < source.width; ++x) {
      const Label number = tables.of_colour[pixels[x]].parents[labels[x]];
      if (pixels[x] != 0) {
        add_run(found.objects[number], x, x + 1, y);
      } else if (number != 0) {
        add_run(found.holes[number - 1], x, x + 1, y);
      }
    }
  }
  if (!with_holes) found.holes.clear();
}

void UnionFind::fill(const ConstImageView& source, const ImageView& destination) {
  label(source);
  const Label* const parents = store_.tables().of_colour[0].parents;
  for (Label label = 0; label < store_.tables().of_colour[0].count; ++label) {
    store_.tables().of_colour[0].parents[label] = parents[parents[label]];
  }
  for (Index y = 0; y < source.height; ++y) {
    const std::uint8_t* const pixels = image_.view().row(y);
    const Label* const labels = labels_.row(y);
    std::transform(pixels, pixels + source.width, labels, destination.row(y),
                   [&](std::uint8_t pixel, Label label) -> std::uint8_t {
                     return pixel != 0 || parents[label] != 0 ? 255 : 0;
                   });
  }
}

/// The first scan; joins background at the image border with the outside.
void UnionFind::label(const ConstImageView& source) {
  plane_conversion<std::uint8_t>(Isa::baseline).read(source, image_.view());
  store_.clear();
  for (Index y = 0; y < source.height; ++y) {
    store_.make_room((source.width + 1) / 2);
    label_row(y);
  }
  if (source.height > 0) join_lower_border();
}

void UnionFind::label_row(Index y) {
  const Index width = image_.view().width;
  const std::uint8_t* const pixels = image_.view().row(y);
  Label* const labels = labels_.row(y);
  for (Index x = 0; x < width; ++x) {
    labels[x] = pixels[x] != 0 ? foreground_label(pixels + x, labels + x, y)
                               : background_label(pixels + x, labels + x, y);
  }
  if (width > 0 && pixels[width - 1] == 0) {
    unite(store_.tables().of_colour[0].parents, 0, labels[width - 1]);
  }
}

Label UnionFind::foreground_label(const std::uint8_t* pixel, const Label* label, Index y) {
  LabelTable& table = store_.tables().of_colour[1];
  const std::uint8_t* const north = pixel - image_.view().stride;
  const Label* const label_north = label - labels_.stride();
  if (north[0] != 0) return label_north[0];  // already joined with the other three
  const bool east = north[1] != 0;
  Label joined = 0;
  if (pixel[-1] != 0) {
    joined = label[-1];
  } else if (north[-1] != 0) {
    joined = label_north[-1];
  } else {
    return east ? label_north[1] : new_label(table, y, 0);
  }
  return east ? unite(table.parents, joined, label_north[1]) : joined;
}

Label UnionFind::background_label(const std::uint8_t* pixel, const Label* label, Index y) {
  LabelTable& table = store_.tables().of_colour[0];
  const bool west = pixel[-1] == 0;
  if (pixel[-image_.view().stride] != 0) return west ? label[-1] : new_label(table, y, label[-1]);
  const Label north = label[-labels_.stride()];
  return west ? unite(table.parents, label[-1], north) : north;
}

void UnionFind::join_lower_border() {
  Label* const parents = store_.tables().of_colour[0].parents;
  const Index y = image_.view().height - 1;
  const std::uint8_t* const pixels = image_.view().row(y);
  const Label* const labels = labels_.row(y);
  for (Index x = 0; x < image_.view().width; ++x) {
    if (pixels[x] == 0) unite(parents, 0, labels[x]);
  }
}

}  // namespace thinbench::detail
