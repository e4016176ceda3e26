// Finds the largest error of a kernel among many inputs, against 200 bits.
//
// A hundred million runs at 200 bits would take hours a kernel. The same template on long double is good to some thousandth
// of an ULP of double: it sieves, and whatever comes near the record is judged by 200 bits, as is one input in 4096, which
// shows how far the sieve is to be trusted.
#pragma once

#include <array>
#include <limits>

#include "oracle.hpp"
#include "random.hpp"
#include "row.hpp"

namespace contactlaws::test {

using Sieve = long double;
static_assert(std::numeric_limits<Sieve>::digits >= 64, "the sieve needs eleven bits more than a double");

/// An ULP of T at |exact|; below the normal numbers the smallest denormal. At the edge of a binade the sieve, which cannot
/// tell on which side it is, takes the smaller.
template <class T, class Exact>
Exact ulp_at(const Exact& exact) {
  using std::frexp;
  using std::ldexp;
  int exponent = std::numeric_limits<T>::min_exponent;
  if (exact != 0) {
    int own = 0;
    frexp(Exact(exact * Exact(std::is_same_v<Exact, Sieve> ? 1 - 0x1p-50L : 1)), &own);
    if (own > exponent) exponent = own;
  }
  return ldexp(Exact(1), exponent - std::numeric_limits<T>::digits);
}

/// Of what a kernel returns, whether it is a vector: Vec3<T> does not deduce T.
template <class Result, class = void>
inline constexpr bool is_vector = false;
template <class Result>
inline constexpr bool is_vector<Result, std::void_t<decltype(std::declval<const Result&>().x())>> = true;

/// |computed - exact| in ULP of T; of vectors, over their length, in eps.
template <class T, class Computed, class Exact>
double distance(const Computed& computed, const Exact& exact) {
  if constexpr (is_vector<Exact>) {
    using Scalar = std::decay_t<decltype(exact.x())>;
    const Vec3<Scalar> off(Scalar(computed.x()) - exact.x(), Scalar(computed.y()) - exact.y(),
                           Scalar(computed.z()) - exact.z());
    return static_cast<double>(Scalar(norm<Scalar>(off) / norm<Scalar>(exact))) /
           static_cast<double>(std::numeric_limits<T>::epsilon());
  } else {
    using std::abs;
    return static_cast<double>(Exact(abs(Exact(Exact(computed) - exact)) / ulp_at<T, Exact>(exact)));
  }
}

template <class Result>
constexpr const char* unit_of(const Result&) {
  return is_vector<Result> ? "eps of the length" : "ULP";
}

template <class T, class Result>
bool fits(const Result& exact) {
  const Sieve most = std::numeric_limits<T>::max();
  if constexpr (is_vector<Result>) {
    return norm<Sieve>(exact) <= most;
  } else {
    return std::abs(exact) <= most;
  }
}

template <class S, class T, std::size_t N>
std::array<S, N> as(const std::array<T, N>& inputs) {
  std::array<S, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = S(inputs[i]);
  return result;
}

/// Runs `kernel`, a function of an array of any scalar, on `count` inputs that `draw(random)` draws, and reports.
/// `inputs` names them. Where the exact result leaves the range of T, T's result is not judged.
template <class T, class Kernel, class Draw>
void judge(Row row, const std::string& inputs, const Kernel& kernel, const Draw& draw) {
  Random random;
  row.name += precision_name<T>();
  row.figure = 0.0;
  double doubt = 0.0;
  const double slack = 0.1;  // far more than a sieve of 64 bits is off, unless `doubt` says otherwise
  for (std::int64_t i = 0; i < row.count; ++i) {
    const auto input = draw(random);
    const auto computed = kernel(input);
    const auto sieve = kernel(as<Sieve>(input));
    if (!fits<T>(sieve)) continue;
    row.unit = unit_of(computed);
    if (distance<T>(computed, sieve) < row.figure - slack && i % 4096 != 0) continue;
    const auto exact = kernel(as<Binary200>(input));
    const double error = distance<T>(computed, exact);
    doubt = std::max(doubt, distance<T>(sieve, exact));
    if (error <= row.figure || std::isnan(row.figure)) continue;  // a NaN is seen, and stays
    row.figure = error;
    std::istringstream names(inputs);
    row.worst.clear();
    for (const auto& value : input) {
      std::string name;
      names >> name;
      row.worst += (row.worst.empty() ? "" : ", ") + name + " = " + text_of(value);
    }
  }
  if (doubt > slack) row.reason += text_of(" [the sieve is off by up to ", doubt, " ULP]");
  report(row);
}

}  // namespace contactlaws::test
