// The random paths that every law is tried on, and the largest figure of a property along them.
#pragma once

#include <cstdint>
#include <sstream>

#include "erased_law.hpp"
#include "random.hpp"

namespace contactlaws::test {

/// What a contact goes through. The normal turns and twists, the overlap wanders, the bodies stick, slip, roll and
/// now and then part; and a bridge is wetted at the start, or not.
struct Path {
  PairProperties<double> pair;
  std::vector<ContactKinematics<double>> steps;
  bool wet;
};

inline Path random_path(Random& random, int length) {
  Path path{random_pair(random), {}, false};
  path.wet = random.chance(0.7);
  const double deep = path.pair.effective_radius * random.log_uniform(1e-4, 1e-2);
  const double stiffness = path.pair.effective_young * std::sqrt(path.pair.effective_radius * deep);
  const double dt = random.log_uniform(0.01, 1.0) * std::sqrt(path.pair.effective_mass / stiffness);
  Vec3<double> normal = random.direction();
  for (int i = 0; i < length; ++i) {
    const double turn = random.uniform(0.0, 0.1);
    normal = (normal + turn * random.direction()).normalized();
    const bool open = random.chance(0.1);
    const double overlap = deep * (open ? random.uniform(-1.0, 0.0) : random.uniform(0.2, 1.0));
    const double speed = deep / dt * random.log_uniform(1e-3, 0.3);
    const Vec3<double> velocity = speed * random.direction();
    const double spin = random.uniform(-0.1, 0.1) / dt;
    const double roll = random.log_uniform(1e-3, 0.3) * deep / path.pair.effective_radius / dt;
    path.steps.push_back({normal, overlap, velocity, dt, spin, roll * random.direction()});
  }
  return path;
}

/// The state in which a contact of this law starts the path.
template <class T>
typename ErasedLaw<T>::State start(const ErasedLaw<T>& law, const Path& path) {
  auto state = law.virgin();
  if (law.bridges && path.wet) law.make_wet(state, T(0), T(0));
  return state;
}

/// The forces whose sum a step returns: what its roundings are in proportion to [N].
template <class T, class State>
T force_scale(const Step<T, State>& step) {
  using std::abs;
  return norm<T>(step.force) + abs(step.normal_elastic) + abs(step.normal_force) + step.bridge_force;
}

/// One step of a contact in the midst of a path.
template <class T>
struct Instant {
  PairProperties<T> pair;
  ContactKinematics<T> kinematics;
  typename ErasedLaw<T>::State state;  ///< before the step
  Step<T, typename ErasedLaw<T>::State> step;
  T force;  ///< the largest force_scale so far, which errors of the history are in proportion to [N]
};

template <class T>
T epsilon() {
  return std::numeric_limits<T>::epsilon();
}

/// The largest figure, and where it was met. A NaN is larger than all, and stays.
struct Worst {
  double figure = 0.0;
  std::string where = {};
  std::int64_t tried = 0;

  template <class... Place>
  void see(double error, const Place&... place) {
    ++tried;
    if (error <= figure || std::isnan(figure)) return;
    figure = error;
    std::ostringstream text;
    ((text << place), ...);
    where = text.str();
  }
};

/// The same generator for the same two names, whatever ran before.
inline Random random_for(const std::string& property, const std::string& law) {
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a
  for (const char c : property + '/' + law) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return Random(hash);
}

/// The largest of `property(law, instant, random)` over `count` instants of each law on T.
template <class T, class Property>
Worst worst_of(const std::string& name, std::int64_t count, const Property& property) {
  constexpr int length = 10;
  Worst worst;
  for (const auto& law : all_laws<T>()) {
    Random random = random_for(name, law->name);
    for (std::int64_t tried = 0; tried < count;) {
      const Path path = random_path(random, length);
      Instant<T> now{path.pair.cast<T>(), {}, start(*law, path), {}, T(0)};
      for (const auto& kinematics : path.steps) {
        now.kinematics = kinematics.template cast<T>();
        now.kinematics.normal = now.kinematics.normal / norm<T>(now.kinematics.normal);
        now.step = law->step(now.pair, now.kinematics, now.state);
        now.force = maximum<T>(now.force, force_scale(now.step));
        worst.see(static_cast<double>(property(*law, now, random)), law->name, ", instant ", ++tried);
        now.state = now.step.state;
      }
    }
  }
  return worst;
}

}  // namespace contactlaws::test
