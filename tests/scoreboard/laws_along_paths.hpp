// Laws stepped along the random paths of law_properties.hpp, for the scoreboard's programs.
#pragma once

#include "law_properties.hpp"
#include "row.hpp"

namespace contactlaws::test {

template <class T>
double length_of(const Vec3<T>& v) {
  return static_cast<double>(norm<T>(v));
}

/// The largest of the parts whose sum a step returns: what its roundings are in proportion to [N].
template <class State>
double largest_part(const Step<double, State>& step) {
  const double dashpot = step.normal_force - step.normal_elastic;
  return std::max({step.force.norm(), step.normal_elastic, std::abs(dashpot), step.bridge_force});
}

/// Values as a host stores them, compared bit by bit; the sign of a zero says nothing.
template <class T, std::size_t N>
bool same_values(const std::array<T, N>& a, const std::array<T, N>& b) {
  for (std::size_t i = 0; i < N; ++i)
    if (a[i] != b[i] && !(a[i] != a[i] && b[i] != b[i])) return false;
  return true;
}
template <class T>
std::array<T, 3> values_of(const Vec3<T>& v) {
  return {v.x(), v.y(), v.z()};
}
template <class Law>
auto stored(const typename Law::State& state) {
  std::array<typename Law::Scalar, Law::state_size> values{};
  Law::store(state, values.data());
  return values;
}

}  // namespace contactlaws::test
