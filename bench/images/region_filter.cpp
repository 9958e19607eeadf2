#include "picture/region_filter.hpp"

namespace thinbench {

KeptRegions kept_regions(const Regions& found, std::int64_t min_area) {
  const auto is_large = [&](const Region& region) { return region.area >= min_area; };
  KeptRegions kept;
  for (std::size_t i = 0; i < found.objects.size(); ++i) {
    if (is_large(found.objects[i])) kept.objects.push_back(i);
  }
  for (std::size_t i = 0; i < found.holes.size(); ++i) {
    const Region& hole = found.holes[i];
    if (is_large(hole) && is_large(found.objects[hole.enclosing_object - 1]))
      kept.holes.push_back(i);
  }
  return kept;
}

Regions selected(const Regions& found, const KeptRegions& kept) {
  Regions result;
  std::vector<std::uint32_t> new_ids(found.objects.size() + 1);
  for (const std::size_t i : kept.objects) {
    result.objects.push_back(found.objects[i]);
    new_ids[i + 1] = static_cast<std::uint32_t>(result.objects.size());
  }
  for (const std::size_t i : kept.holes) {
    result.holes.push_back(found.holes[i]);
    result.holes.back().enclosing_object = new_ids[found.holes[i].enclosing_object];
  }
  return result;
}

}  // namespace thinbench
