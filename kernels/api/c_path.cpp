// The C interface of paths.
#include "api/c_arguments.hpp"
#include "thinbench.h"
#include "thinbench/path.hpp"

thinbench_status thinbench_find_path(const thinbench_stack* free, thinbench_pixel start,
                                     thinbench_pixel goal, double width,
                                     const thinbench_execution* execution, thinbench_pixel* pixels,
                                     size_t* count) {
  using namespace thinbench;
  using namespace thinbench::detail;
  return guarded([&] {
    require_pointer(pixels, "pixels");
    require_pointer(count, "count");
    const PathRequest request = {{start.x, start.y}, {goal.x, goal.y}, width};
    const auto path = find_path(image_of(free), request, execution_of(execution));
    *count = path ? path->pixels.size() : 0;
    for (std::size_t i = 0; i < *count; ++i) pixels[i] = {path->pixels[i].x, path->pixels[i].y};
  });
}
