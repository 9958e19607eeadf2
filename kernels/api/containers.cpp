#include "thinbench/containers.hpp"

namespace thinbench::detail {

#ifdef _GLIBCXX_DEBUG
const bool kInterface1x0Debug = true;
#else
const bool kInterface1x0 = true;
#endif

}  // namespace thinbench::detail
