// The judge of accuracy: the same template at 200 bits, and the distance to it in units in the last place (ULP).
#pragma once

#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>

#include "contactlaws/scalars/multiprecision.hpp"

namespace contactlaws::test {

/// |computed - exact| in ULP of T at `exact`; below the normal numbers a ULP is the smallest denormal.
template <class T>
double ulps(const T& computed, const Binary200& exact) {
  int exponent = std::numeric_limits<T>::min_exponent;
  if (exact != 0) {
    int own = 0;
    frexp(exact, &own);
    if (own > exponent) exponent = own;
  }
  const Binary200 unit = ldexp(Binary200(1), exponent - std::numeric_limits<T>::digits);
  return static_cast<double>(abs(Binary200(computed) - exact) / unit);
}

/// Whether T can hold `exact` without overflow.
template <class T>
bool holds(const Binary200& exact) {
  return abs(exact) < Binary200(std::numeric_limits<T>::max());
}

/// The largest error of a kernel, and where it was met; said once, at the end.
class Worst {
 public:
  explicit Worst(const std::string& kernel) : kernel_(kernel) {}
  ~Worst() { std::cout << kernel_ << ": " << error_ << " ULP at" << input_ << '\n'; }
  Worst(const Worst&) = delete;
  Worst& operator=(const Worst&) = delete;

  template <class... Inputs>
  void see(double error, const Inputs&... inputs) {
    if (error <= error_ || std::isnan(error_)) return;  // a NaN is seen, and stays
    error_ = error;
    std::ostringstream text;
    text.precision(17);
    ((text << ' ' << inputs), ...);
    input_ = text.str();
  }
  double error() const { return error_; }

 private:
  std::string kernel_, input_;
  double error_ = 0.0;
};

template <class T>
std::string precision_name() {
  return std::numeric_limits<T>::digits == 24 ? " (float)" : " (double)";
}

}  // namespace contactlaws::test
