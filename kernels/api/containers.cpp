#include "thinbench/containers.hpp"

namespace thinbench::detail {

#ifdef _GLIBCXX_DEBUG
const bool kLibraryHasDebugContainers = true;
#else
const bool kLibraryHasUsualContainers = true;
#endif

}  // namespace thinbench::detail
