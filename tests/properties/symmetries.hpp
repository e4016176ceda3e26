// What must not matter: which body is called the first, the observer's frame, the units. Each property is a function that
// returns a figure, 0 where all is exact; the tests and the scoreboard call it.
#pragma once

#include "contact.hpp"

namespace contactlaws::test {

/// The precision in which inputs are turned and scaled: wider than T where there is a wider one that is fast.
template <class T>
using Wide = std::conditional_t<(std::numeric_limits<T>::digits < 64), long double, T>;
template <class T>
using Turn = Eigen::Matrix<Wide<T>, 3, 3>;

/// How many values differ between a step and the same step with the bodies swapped.
template <class T>
int changed_by_swap(const ErasedLaw<T>& law, const Instant<T>& now) {
  const auto swapped = [&law](typename ErasedLaw<T>::State state) {
    for (std::size_t i = 0; i < law.state_size(); ++i) state[i] = state[i] * T(law.state_values[i].exchange_sign);
    return state;
  };
  ContactKinematics<T> other = now.kinematics;
  other.normal = -other.normal;
  other.velocity = -other.velocity;
  other.relative_spin = -other.relative_spin;
  // The mean spin stays the same vector, so that about the normal changes sign.
  other.normal_spin = -other.normal_spin;
  const auto seen = law.step(now.pair, other, swapped(now.state));
  const auto expected = swapped(now.step.state);
  int changed = !same<T>(seen.force, -now.step.force) + !same<T>(seen.couple, -now.step.couple);
  changed += seen.normal_elastic != now.step.normal_elastic;
  changed += seen.normal_force != now.step.normal_force;
  changed += seen.sliding != now.step.sliding;
  for (std::size_t i = 0; i < law.state_size(); ++i) changed += seen.state[i] != expected[i];
  return changed;
}

/// A rigid rotation, orthogonal to the precision of Wide<T>.
template <class T>
Turn<T> random_turn(Random& random) {
  const Vec3<double> axis = random.direction();
  const Vec3<double> other = random.direction_across(axis);
  using W = Wide<T>;
  const auto unit = [](const Vec3<W>& v) { return Vec3<W>(v / norm<W>(v)); };
  const Vec3<W> a = unit({W(axis.x()), W(axis.y()), W(axis.z())});
  const Vec3<W> b(W(other.x()), W(other.y()), W(other.z()));
  const Vec3<W> across = unit(b - a * dot<W>(a, b));
  Turn<T> turn;
  turn.col(0) = a;
  turn.col(1) = across;
  turn.col(2) = a.cross(across);
  return turn;
}
/// One of the 24 rotations that exchange axes, exact in any arithmetic.
template <class T>
Turn<T> random_exchange_of_axes(Random& random) {
  const int first = random.integer(0, 2);
  const int second = (first + random.integer(1, 2)) % 3;
  Turn<T> turn = Turn<T>::Zero();
  turn(first, 0) = random.chance(0.5) ? 1 : -1;
  turn(second, 1) = random.chance(0.5) ? 1 : -1;
  turn.col(2) = turn.col(0).cross(turn.col(1));
  return turn;
}

struct FrameErrors {
  double force;  ///< [eps of the largest part of a force on the way]
  double state;  ///< [eps of the largest value of its kind]
};

/// How far a step in a turned frame is from the turned step.
template <class T>
FrameErrors error_in_frame(const ErasedLaw<T>& law, const Instant<T>& now, const Turn<T>& turn) {
  using std::abs;
  const auto turned = [&turn](const T& x, const T& y, const T& z) {
    const Vec3<Wide<T>> v = turn * Vec3<Wide<T>>(x, y, z);
    return Vec3<T>(static_cast<T>(v.x()), static_cast<T>(v.y()), static_cast<T>(v.z()));
  };
  const auto turned_vector = [&turned](const Vec3<T>& v) { return turned(v.x(), v.y(), v.z()); };
  const auto turned_state = [&](typename ErasedLaw<T>::State state) {
    for (std::size_t i = 0; i < law.state_size(); ++i) {
      if (law.state_values[i].kind == ValueKind::scalar) continue;  // else the first of a vector's three
      const Vec3<T> vector = turned(state[i], state[i + 1], state[i + 2]);
      for (int k = 0; k < 3; ++k) state[i + static_cast<std::size_t>(k)] = vector[k];
      i += 2;
    }
    return state;
  };
  if (!(now.force > T(0))) return {0.0, 0.0};
  ContactKinematics<T> other = now.kinematics;
  other.normal = turned_vector(now.kinematics.normal);
  other.velocity = turned_vector(now.kinematics.velocity);
  other.relative_spin = turned_vector(now.kinematics.relative_spin);
  const auto seen = law.step(now.pair, other, turned_state(now.state));
  const T off = norm<T>(seen.force - turned_vector(now.step.force));
  const T couple = norm<T>(seen.couple - turned_vector(now.step.couple)) / now.pair.effective_radius;
  FrameErrors errors{static_cast<double>(T(maximum<T>(off, couple) / now.force / epsilon<T>())), 0.0};
  const auto expected = turned_state(now.step.state);
  for (std::size_t i = 0; i < law.state_size(); ++i) {
    const std::string unit = law.state_values[i].unit;
    const T shear = law.stiffness(now.pair, now.kinematics.overlap, now.state).shear;
    const T size = unit == "N"                   ? now.force
                   : unit == "N m"               ? T(now.force * now.pair.effective_radius)
                   : unit == "m" && shear > T(0) ? maximum<T>(T(now.force / shear), abs(expected[i]))
                   : unit == "1"                 ? T(1)
                                                 : abs(expected[i]);
    const T difference = abs(T(seen.state[i] - expected[i]));
    if (difference > T(0))
      errors.state = maximum(errors.state, static_cast<double>(T(difference / size / epsilon<T>())));
  }
  return errors;
}

/// Other units: a factor on metre, kilogram and second.
template <class T>
struct Units {
  Wide<T> length, mass, time;

  Wide<T> factor(const std::string& unit) const {
    const Wide<T> force = mass * length / (time * time);
    if (unit == "1" || unit == "rad") return Wide<T>(1);
    if (unit == "m") return length;
    if (unit == "m^3") return length * length * length;
    if (unit == "N") return force;
    if (unit == "N m") return force * length;
    if (unit == "N m s") return force * length * time;
    if (unit == "J/m^2") return force / length;
    if (unit == "N/m") return force / length;
    if (unit == "Pa") return force / (length * length);
    throw std::logic_error("no factor for unit " + unit);
  }
  T operator()(const T& x, const Wide<T>& factor) const { return static_cast<T>(Wide<T>(x) * factor); }
  T operator()(const T& x, const std::string& unit) const { return (*this)(x, factor(unit)); }

  /// Factors 10^k, k from -most to most; or powers of 2, of 4 for lengths, since laws take square roots of single lengths.
  static Units random(Random& random, bool binary, int most) {
    const auto power = [&random](int base, int largest) {
      const int exponent = random.integer(-largest, largest);
      Wide<T> result = 1;
      for (int i = 0; i < std::abs(exponent); ++i) result = result * base;
      return exponent < 0 ? Wide<T>(1 / result) : result;
    };
    Units units;
    units.length = binary ? power(4, most / 2) : power(10, most);
    units.mass = power(binary ? 2 : 10, most);
    units.time = power(binary ? 2 : 10, most);
    return units;
  }
};

struct UnitErrors {
  double force;  ///< [eps of the largest part of a force on the way]
  int changed;   ///< values of the state, the couple, the sliding or the energy that are not exactly scaled
};

/// How far a step in other units is from the step.
template <class T>
UnitErrors error_in_units(const ErasedLaw<T>& law, const Instant<T>& now, const Units<T>& units) {
  const auto scaled = [&](typename ErasedLaw<T>::State state) {
    for (std::size_t i = 0; i < law.state_size(); ++i) state[i] = units(state[i], law.state_values[i].unit);
    return state;
  };
  const auto other = law.clone();
  for (const auto& p : other->parameters()) *p.value = units(*p.value, p.unit);
  const auto& p = now.pair;
  const auto& k = now.kinematics;
  const PairProperties<T> pair{units(p.effective_radius, "m"), units(p.effective_young, "Pa"),
                               units(p.effective_shear, "Pa"), units(p.effective_mass, units.mass),
                               units(p.min_radius, "m"),       units(p.length, "m")};
  ContactKinematics<T> kinematics = k;
  kinematics.overlap = units(k.overlap, "m");
  for (int i = 0; i < 3; ++i) kinematics.velocity[i] = units(k.velocity[i], Wide<T>(units.length / units.time));
  for (int i = 0; i < 3; ++i) kinematics.relative_spin[i] = units(k.relative_spin[i], Wide<T>(1 / units.time));
  kinematics.dt = units(k.dt, units.time);
  kinematics.normal_spin = units(k.normal_spin, Wide<T>(1 / units.time));
  const auto seen = other->step(pair, kinematics, scaled(now.state));

  UnitErrors errors{0.0, 0};
  const T force = units(now.force, "N");
  if (force > T(0))
    for (int i = 0; i < 3; ++i) {
      using std::abs;
      const T off = abs(T(seen.force[i] - units(now.step.force[i], "N")));
      errors.force = maximum(errors.force, static_cast<double>(T(off / force / epsilon<T>())));
    }
  const auto expected = scaled(now.step.state);
  for (std::size_t i = 0; i < law.state_size(); ++i) errors.changed += seen.state[i] != expected[i];
  for (int i = 0; i < 3; ++i) errors.changed += seen.couple[i] != units(now.step.couple[i], "N m");
  errors.changed += seen.sliding != now.step.sliding;
  errors.changed += other->stored_energy(pair, kinematics.overlap, seen.state) !=
                    units(law.stored_energy(p, k.overlap, now.step.state), "N m");
  return errors;
}

}  // namespace contactlaws::test
