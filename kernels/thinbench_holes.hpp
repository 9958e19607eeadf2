// Objects and holes in one header: find them in a picture, let the library choose how.
#pragma once

#include <vector>

#include "catalog.hpp"
#include "dispatch/variant_choice.hpp"
#include "regions/plan.hpp"

namespace thinbench {

/// The variant that fits the wish. Throws std::invalid_argument, naming what is wrong and what
/// there is instead, where none does.
[[nodiscard]] const HolesVariant& choose_variant(const HolesOperation& operation, Index width,
                                                 const VariantRequest& wish = {});

/// Lists that own their regions; see region.hpp for what they hold and how they are numbered.
struct FoundHoles {
  std::vector<Region> objects;
  std::vector<Region> holes;
};

// In all of these 0 is light, anything else dark; outside the image everything is light, objects
// are 8-connected and holes 4-connected. They throw std::invalid_argument for a negative size, a
// stride below the width, a null image, sides above 2^29 or more than 2^32 pixels, and a wish that
// no variant fits; std::bad_alloc where memory is short.
//
// The paper's own relabelling scan is not offered: its count is right on one object with thick
// walls only, and it has 254 labels. It is kept as holes_literal in reference/holes.hpp, to measure
// where it is right.

/// All objects and all holes.
[[nodiscard]] FoundHoles find_holes(ConstImageView source, const VariantRequest& wish = {});

/// All objects alone, for less work.
[[nodiscard]] std::vector<Region> find_components(ConstImageView source,
                                                  const VariantRequest& wish = {});

/// Objects minus holes; euler_number_4 has 4-connected objects and 8-connected holes.
[[nodiscard]] std::int64_t euler_number(ConstImageView source, const VariantRequest& wish = {});
[[nodiscard]] std::int64_t euler_number_4(ConstImageView source, const VariantRequest& wish = {});

/// Objects with all that they enclose, 255 on 0. The two are the same image or do not overlap.
void fill_holes(ConstImageView source, ImageView destination, const VariantRequest& wish = {});

}  // namespace thinbench
