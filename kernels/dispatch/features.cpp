#include "dispatch/features.hpp"

namespace thinbench::detail {
namespace {

Features if_true(bool available, Features feature) {
  return available ? feature : Features::none;
}

}  // namespace

// The compiler's support library reports AVX and AVX-512 as missing where the operating system does
// not save their registers.
Features detect_features() {
  __builtin_cpu_init();
  return if_true(__builtin_cpu_supports("sse4.2"), Features::sse4_2) |
         if_true(__builtin_cpu_supports("popcnt"), Features::popcnt) |
         if_true(__builtin_cpu_supports("avx2"), Features::avx2) |
         if_true(__builtin_cpu_supports("bmi"), Features::bmi) |
         if_true(__builtin_cpu_supports("bmi2"), Features::bmi2) |
         if_true(__builtin_cpu_supports("avx512f"), Features::avx512f) |
         if_true(__builtin_cpu_supports("avx512cd"), Features::avx512cd) |
         if_true(__builtin_cpu_supports("avx512dq"), Features::avx512dq) |
         if_true(__builtin_cpu_supports("avx512bw"), Features::avx512bw) |
         if_true(__builtin_cpu_supports("avx512vl"), Features::avx512vl) |
         if_true(__builtin_cpu_supports("avx512vbmi"), Features::avx512vbmi) |
         if_true(__builtin_cpu_supports("avx512vbmi2"), Features::avx512vbmi2) |
         if_true(__builtin_cpu_supports("avx512vnni"), Features::avx512vnni) |
         if_true(__builtin_cpu_supports("avx512bitalg"), Features::avx512bitalg) |
         if_true(__builtin_cpu_supports("avx512vpopcntdq"), Features::avx512vpopcntdq) |
         if_true(__builtin_cpu_supports("gfni"), Features::gfni);
}

}  // namespace thinbench::detail
