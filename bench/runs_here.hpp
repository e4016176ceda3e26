// SPDX-License-Identifier: MIT
// Whether this machine has the instructions that a benchmark was built with.
#pragma once

namespace bench {

inline bool runs_here() {
#if defined(__AVX512DQ__)
  return __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
#elif defined(__AVX2__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return true;
#endif
}

}  // namespace bench
