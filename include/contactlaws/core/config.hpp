// SPDX-License-Identifier: MIT
// The words in which compilers differ.
#pragma once

/// Kernels are drawn into their callers, since packs live in registers only as long as nothing is called. Define it as
/// `inline` where compile time matters more: numbers of 200 bits take six times as long to compile drawn in.
#if !defined(CONTACTLAWS_INLINE)
#if defined(__GNUC__) && !defined(__CUDACC__) && !defined(__HIPCC__)
#define CONTACTLAWS_INLINE __attribute__((always_inline)) inline
#else
#define CONTACTLAWS_INLINE inline
#endif
#endif

/// Marks a kernel: it runs on the host and, under a GPU compiler, on the device too.
#if defined(__CUDACC__) || defined(__HIPCC__)
#define CONTACTLAWS_HD __host__ __device__ CONTACTLAWS_INLINE
#else
#define CONTACTLAWS_HD CONTACTLAWS_INLINE
#endif

/// Lets several empty base classes take no room: other compilers need no telling.
#if defined(_MSC_VER)
#define CONTACTLAWS_EMPTY_BASES __declspec(empty_bases)
#else
#define CONTACTLAWS_EMPTY_BASES
#endif

/// Draws everything that a function calls, Eigen's too, into its body: the loop over packs.
#if defined(__GNUC__) && !defined(__CUDACC__)
#define CONTACTLAWS_FLATTEN __attribute__((flatten))
#else
#define CONTACTLAWS_FLATTEN
#endif
