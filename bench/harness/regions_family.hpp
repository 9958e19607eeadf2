// Objects, holes, Euler numbers and filling as the harness sees them: lists as rows of numbers, a
// number, or an image.
#pragma once

#include <vector>

#include "harness/operation.hpp"
#include "regions/label_store.hpp"

namespace thinbench {

[[nodiscard]] std::vector<Operation> regions_family();

/// Lists as numbers: how many objects and holes there are, and then every member of each.
[[nodiscard]] std::vector<std::int64_t> numbers_of(const detail::RegionLists& lists);
/// What number `index` of these is, in words.
[[nodiscard]] std::string name_of_region_number(std::size_t index);

}  // namespace thinbench
