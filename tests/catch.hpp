/// Catch2, version 2 or 3, with the same names.
#pragma once

#if defined(__clang__)
#pragma clang diagnostic ignored "-Wc++20-extensions"  // TEMPLATE_TEST_CASE leaves variadic arguments out
#endif

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;
#else
#include <catch2/catch.hpp>
inline auto ContainsSubstring(const std::string& text) { return Catch::Matchers::Contains(text); }
#endif
