#include "thinbench/containers.hpp"

namespace thinbench::detail {

#ifdef _GLIBCXX_DEBUG
const bool kInterface_1_0_debug = true;
#else
const bool kInterface_1_0 = true;
#endif

}  // namespace thinbench::detail
