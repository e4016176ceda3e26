// SPDX-License-Identifier: MIT
// The words in which compilers differ.
#pragma once

/// Marks a kernel: it runs on the host and, under a GPU compiler, on the device too; and it is drawn into its caller,
/// since packs live in registers only as long as nothing is called.
#if defined(__CUDACC__) || defined(__HIPCC__)
#define CONTACTLAWS_HD __host__ __device__
#elif defined(__GNUC__)
#define CONTACTLAWS_HD __attribute__((always_inline)) inline
#else
#define CONTACTLAWS_HD inline
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
