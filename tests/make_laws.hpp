// The hill laws of the tests, by position: friction [1], suction [Pa], damping constant [1].
#pragma once

#include "contactlaws/laws.hpp"

namespace contactlaws::test {

template <class T>
DryHill<T> dry_hill(double friction, double damping_constant = 0.0) {
  DryHillProperties<T> properties;
  properties.friction = T(friction);
  properties.damping_constant = T(damping_constant);
  return contactlaws::dry_hill(properties);
}

template <class T>
Hill<T> hill(double friction, double suction, double damping_constant) {
  HillProperties<T> properties;
  properties.friction = T(friction);
  properties.suction = T(suction);
  properties.damping_constant = T(damping_constant);
  return contactlaws::hill(properties);
}

}  // namespace contactlaws::test
