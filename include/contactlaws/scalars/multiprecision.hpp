// SPDX-License-Identifier: MIT
// High precision: any kernel on Boost.Multiprecision numbers, such as Binary200, the reference of the accuracy tests.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#if !defined(CONTACTLAWS_NO_EIGEN)
#include <boost/multiprecision/eigen.hpp>
#endif

#include "contactlaws/core/scalar.hpp"

namespace contactlaws {

/// A binary number of 200 bits.
using Binary200 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<200, boost::multiprecision::digit_base_2>,
                                  boost::multiprecision::et_off>;

}  // namespace contactlaws
