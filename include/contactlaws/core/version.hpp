// SPDX-License-Identifier: MIT
// The library's version: the one place where it is written; CMake and pkg-config read it from here.
#pragma once

#define CONTACTLAWS_VERSION_MAJOR 0  ///< 0 until the interface is stable
#define CONTACTLAWS_VERSION_MINOR 2  ///< grows with the interface
#define CONTACTLAWS_VERSION_PATCH 0  ///< grows with corrections

// Two steps, so that the numbers are put in before they are quoted.
#define CONTACTLAWS_QUOTE(x) #x
#define CONTACTLAWS_QUOTE_VERSION(a, b, c) CONTACTLAWS_QUOTE(a) "." CONTACTLAWS_QUOTE(b) "." CONTACTLAWS_QUOTE(c)

namespace contactlaws {

/// "major.minor.patch"; below 1.0 a minor version may change the interface.
inline constexpr const char* version =
    CONTACTLAWS_QUOTE_VERSION(CONTACTLAWS_VERSION_MAJOR, CONTACTLAWS_VERSION_MINOR, CONTACTLAWS_VERSION_PATCH);

}  // namespace contactlaws
