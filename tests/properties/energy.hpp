// The energy that a contact gains on closed loops: the tests and the scoreboard call it.
//
// Undamped granite grains move over overlaps and along one tangent. Between the same two overlaps the elastic normal force
// does the same work there and back by the trapezoidal rule, and a spring's shear force is linear in its slip, for which the
// rule is exact: a closed loop without slip enters the shear energy alone.
#pragma once

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "contactlaws/energy.hpp"
#include "contactlaws/normal/hertz.hpp"
#include "random.hpp"

namespace contactlaws::test {

/// A contact of granite grains whose energy is entered step by step.
template <class Law>
struct MovedContact {
  using T = typename Law::Scalar;

  Law law;
  PairProperties<T> pair = granite_pair<T>();
  typename Law::State state{};
  EnergyLedger<T> ledger{};
  T overlap = T(0);
  T largest = T(0);  ///< shear energy so far [J]

  /// With this coefficient of friction [1].
  explicit MovedContact(double friction, const Law& with = Law{}) : law(with) { law.shear.friction = T(friction); }

  /// To an overlap, with a slip along x [m]. The shear force against it [N].
  T move(const T& to, const T& slip) {
    const ContactKinematics<T> k{{T(0), T(0), T(1)}, to, {slip, T(0), T(overlap - to)}, T(1)};
    const auto step = law.step(pair, k, state);
    ledger.enter(law, pair, k, step);
    state = step.state;
    overlap = to;
    const T in_spring = step.force.x() * step.force.x() / (T(2) * law.stiffness(pair, to, state).shear);
    if (to > T(0)) largest = maximum<T>(largest, in_spring);
    return -step.force.x();
  }
};

template <class Shear>
using Undamped = ContactLaw<Hertz<decltype(Shear::friction)>, NoDashpots<decltype(Shear::friction)>, Shear>;

/// A closed loop: from touch up to a line of a grid of overlaps, a walk over lines and slips, all slip undone, down to touch.
struct ClosedLoop {
  double friction;
  std::vector<std::pair<int, double>> moves;  ///< grid line [10 um], slip [um]

  ClosedLoop(Random& random, bool sticks) : friction(sticks ? 1e6 : random.uniform(0.1, 1.0)) {
    int level = random.integer(1, 10);
    for (int up = 1; up <= level; ++up) moves.emplace_back(up, 0.0);
    double strain = 0.0;
    const int length = random.integer(2, 31);
    for (int i = 0; i < length; ++i) {
      if (random.chance(0.5)) {
        level += level == 1 || random.chance(0.5) ? 1 : -1;
        moves.emplace_back(level, 0.0);
      } else {
        const double slip = std::round(random.uniform(-200.0, 200.0)) / 128.0;  // sums of these are exact
        strain += slip;
        moves.emplace_back(level, slip);
      }
    }
    moves.emplace_back(level, -strain);
    while (level-- > 0) moves.emplace_back(level, 0.0);
  }

  /// The energy gained, in the largest shear energy on the way.
  template <class Law>
  double gain() const {
    using T = typename Law::Scalar;
    MovedContact<Law> contact(friction);
    for (const auto& [line, slip] : moves) contact.move(T(line) / T(100000), T(slip) / T(1000000));
    // Below a billionth of a joule there is only the rounding of the normal work, some 0.1 J.
    return contact.largest > T(1e-9) ? static_cast<double>(T(-contact.ledger.dissipated() / contact.largest)) : 0.0;
  }

  std::string text() const {
    std::ostringstream all;
    all.precision(17);
    friction > 1e3 ? all << "sticks; overlap [10 um]" : all << "mu " << friction << "; overlap [10 um]";
    for (const auto& [line, slip] : moves) slip != 0.0 ? all << " slip " << slip << " um" : all << ' ' << line;
    return all.str();
  }
};

/// Of `count` random loops, the one that gains most, and its gain.
template <class Law>
std::pair<double, ClosedLoop> largest_gain(Random random, std::int64_t count, bool sticks) {
  double most = -1.0;
  ClosedLoop best(random, sticks);
  for (std::int64_t i = 0; i < count; ++i) {
    const ClosedLoop loop(random, sticks);
    const double gain = loop.gain<Law>();
    if (gain <= most) continue;
    most = gain;
    best = loop;
  }
  return {most, best};
}

/// The gain, in k S^2/2, of a rough contact that slips at its largest overlap, opens by 1e-10 of it, slips back and closes
/// again; or the reverse. A shear stiffness in proportion to a tangent that jumps there creates energy.
template <class Law>
double gain_at_largest_overlap(const Law& law) {
  const double deep = 1e-5, below = deep * (1 - 1e-10), slip = 1e-8;
  double most = 0.0;
  for (const auto& [first, second] : {std::pair(deep, below), std::pair(below, deep)}) {
    MovedContact<Law> contact(1e6, law);
    contact.move(deep, 0.0);
    contact.move(first, 0.0);
    const double before = contact.ledger.dissipated();
    contact.move(first, slip);
    contact.move(second, 0.0);
    contact.move(second, -slip);
    contact.move(first, 0.0);
    most = std::max(most, (before - contact.ledger.dissipated()) / contact.largest);
  }
  return most;
}

}  // namespace contactlaws::test
