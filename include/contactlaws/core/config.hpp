// SPDX-License-Identifier: MIT
// What differs between compilers.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) < 201703L
#error "contactlaws needs C++17: compile with -std=c++17 or later"
#endif

/// Force-inlines kernels: a SIMD value that is passed to a real call is spilled to memory. Define it as `inline` where
/// compile time matters more: force-inlined, numbers of 200 bits take six times as long to compile.
#if !defined(CONTACTLAWS_INLINE)
#if defined(__GNUC__) && !defined(__CUDACC__) && !defined(__HIPCC__)
#define CONTACTLAWS_INLINE __attribute__((always_inline)) inline
#else
#define CONTACTLAWS_INLINE inline
#endif
#endif

/// The same for a lambda, after its parameters.
#if defined(__GNUC__) && !defined(__CUDACC__) && !defined(__HIPCC__)
#define CONTACTLAWS_INLINE_LAMBDA __attribute__((always_inline))
#else
#define CONTACTLAWS_INLINE_LAMBDA
#endif

/// Marks a function that runs on the host and, under a GPU compiler, on the device.
#if defined(__CUDACC__) || defined(__HIPCC__)
#define CONTACTLAWS_HD __host__ __device__ CONTACTLAWS_INLINE
#else
#define CONTACTLAWS_HD CONTACTLAWS_INLINE
#endif

/// MSVC only: enables the empty-base optimisation for several bases.
#if defined(_MSC_VER)
#define CONTACTLAWS_EMPTY_BASES __declspec(empty_bases)
#else
#define CONTACTLAWS_EMPTY_BASES
#endif

/// Inlines everything that a function calls, Eigen's functions included: for the loop over packs.
#if defined(__GNUC__) && !defined(__CUDACC__)
#define CONTACTLAWS_FLATTEN __attribute__((flatten))
#else
#define CONTACTLAWS_FLATTEN
#endif
