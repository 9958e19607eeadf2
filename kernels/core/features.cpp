#include "core/features.hpp"

#if defined(__aarch64__)
#if __has_include(<sys/auxv.h>)
#include <sys/auxv.h>
#elif __has_include(<sys/sysctl.h>)
#include <cstddef>

#include <sys/sysctl.h>
#endif
#endif

namespace thinbench::detail {

#if defined(__x86_64__)

// __builtin_cpu_supports also checks what the operating system saves (XCR0).
Features detect_features() {
  __builtin_cpu_init();
  Features found = 0;
  const auto add = [&found](bool supported, Features one) { found |= supported ? one : 0; };
  add(__builtin_cpu_supports("sse4.2"), feature("sse4.2"));
  add(__builtin_cpu_supports("popcnt"), feature("popcnt"));
  add(__builtin_cpu_supports("avx2"), feature("avx2"));
  add(__builtin_cpu_supports("bmi"), feature("bmi"));
  add(__builtin_cpu_supports("bmi2"), feature("bmi2"));
  add(__builtin_cpu_supports("avx512f"), feature("avx512f"));
  add(__builtin_cpu_supports("avx512cd"), feature("avx512cd"));
  add(__builtin_cpu_supports("avx512dq"), feature("avx512dq"));
  add(__builtin_cpu_supports("avx512bw"), feature("avx512bw"));
  add(__builtin_cpu_supports("avx512vl"), feature("avx512vl"));
  add(__builtin_cpu_supports("avx512vbmi"), feature("avx512vbmi"));
  add(__builtin_cpu_supports("avx512vbmi2"), feature("avx512vbmi2"));
  add(__builtin_cpu_supports("avx512vnni"), feature("avx512vnni"));
  add(__builtin_cpu_supports("avx512bitalg"), feature("avx512bitalg"));
  add(__builtin_cpu_supports("avx512vpopcntdq"), feature("avx512vpopcntdq"));
  add(__builtin_cpu_supports("gfni"), feature("gfni"));
  return found;
}

#elif defined(__aarch64__)

Features detect_features() {
#if __has_include(<sys/auxv.h>)
  const bool has_sha3 = (getauxval(AT_HWCAP) & HWCAP_SHA3) != 0;
#elif __has_include(<sys/sysctl.h>)
  int has_sha3 = 0;
  std::size_t bytes = sizeof(has_sha3);
  if (sysctlbyname("hw.optional.armv8_2_sha3", &has_sha3, &bytes, nullptr, 0) != 0) has_sha3 = 0;
#else
  const bool has_sha3 = false;
#endif
  return has_sha3 ? feature("sha3") : 0;
}

#else

Features detect_features() {
  return 0;
}

#endif

}  // namespace thinbench::detail
