// SPDX-License-Identifier: MIT
// The two words in which compilers differ.
#pragma once

/// Marks a function that runs on the host and, under a GPU compiler, on the device too.
#if defined(__CUDACC__) || defined(__HIPCC__)
#define CONTACTLAWS_HD __host__ __device__
#else
#define CONTACTLAWS_HD
#endif

/// Lets several empty base classes take no room: other compilers need no telling.
#if defined(_MSC_VER)
#define CONTACTLAWS_EMPTY_BASES __declspec(empty_bases)
#else
#define CONTACTLAWS_EMPTY_BASES
#endif
