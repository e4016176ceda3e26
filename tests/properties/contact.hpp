// What holds of every step: an open contact pulls by its bridge alone, a closed one pushes and resists motion, friction
// bounds the shear force, a query changes nothing. Each property is a function that returns a figure, 0 where all is exact;
// the tests, the fuzzer and the scoreboard call it.
#pragma once

#include "paths.hpp"

namespace contactlaws::test {

template <class T>
bool same(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x() == b.x() && a.y() == b.y() && a.z() == b.z();
}

/// The shear force as what the whole force leaves, to check Step::shear_force by.
template <class T, class State>
Vec3<T> shear_part(const Step<T, State>& step, const Vec3<T>& normal) {
  return step.force - normal * T(step.normal_force - step.bridge_force);
}

/// How much of a step is wrong at an overlap that is not positive: forces beside the bridge's pull, a couple, a
/// shear or rolling history kept.
template <class T>
int wrong_when_open(const ErasedLaw<T>& law, const PairProperties<T>& pair, const ContactKinematics<T>& kinematics,
                    const Step<T, typename ErasedLaw<T>::State>& step) {
  const T gap = -kinematics.overlap;
  int wrong = step.normal_elastic != T(0);
  wrong += step.normal_force != T(0);
  wrong += step.sliding;
  wrong += !same<T>(step.shear_force, Vec3<T>(T(0), T(0), T(0)));
  wrong += step.friction_work != T(0) || step.dashpot_work != T(0);
  wrong += !same<T>(step.couple, Vec3<T>(T(0), T(0), T(0)));
  wrong += !same<T>(step.force, kinematics.normal * T(-step.bridge_force));
  wrong += gap >= law.interaction_range(pair) && gap > T(0) && step.bridge_force != T(0);
  wrong += !step.active && (gap <= T(0) || step.bridge_force > T(0));
  for (std::size_t i = 0; i < law.state_size(); ++i)
    wrong += law.state_values[i].kind == ValueKind::vector && step.state[i] != T(0);
  return wrong;
}
/// The same of an instant moved to four gaps.
template <class T>
int wrong_when_opened(const ErasedLaw<T>& law, const Instant<T>& now) {
  const T range = law.interaction_range(now.pair);
  int wrong = 0;
  ContactKinematics<T> open = now.kinematics;
  for (const T& gap : {T(0), T(range / T(2)), range, T(range * T(2) + now.pair.effective_radius)}) {
    open.overlap = -gap;
    if (gap < range && law.touches(now.pair, open.overlap, now.state)) continue;  // adhesion holds it
    const auto step = law.step(now.pair, open, now.state);
    wrong += wrong_when_open(law, now.pair, open, step);
    wrong += step.active && gap > T(0) && !(step.bridge_force > T(0));
  }
  return wrong;
}

/// How much of a step of a virgin contact is wrong where it is closed: springs that do not push, dashpots and shear that
/// drive the motion, an elastic force that does not grow with the overlap.
template <class T>
int wrong_when_closed(const ErasedLaw<T>& law, const Instant<T>& now) {
  using std::abs;
  if (!(now.kinematics.overlap > T(0))) return 0;
  const Vec3<T>& n = now.kinematics.normal;
  const auto step = law.step(now.pair, now.kinematics, law.virgin());
  const T separating = dot<T>(now.kinematics.velocity, n);
  int wrong = !step.active;
  wrong += !(step.normal_elastic + law.adhesion(now.pair, now.kinematics.overlap) > T(0));
  wrong += step.bridge_force != T(0);
  // Of a law that pulls its pull-off is added and taken away.
  const T slack = T(2) * epsilon<T>() * law.adhesion(now.pair, now.kinematics.overlap);
  wrong += !(separating > T(0) ? step.normal_force <= step.normal_elastic + slack
                               : step.normal_force >= step.normal_elastic - slack);

  // Shear is what is left when the normal part is taken away: 8 roundings of forces of this size.
  const Vec3<T> shear = shear_part(step, n);
  const T rounding = T(8) * epsilon<T>() * force_scale(step);
  const T power = dot<T>(shear, Vec3<T>(now.kinematics.velocity - n * separating));
  wrong += !(power <= rounding * norm<T>(now.kinematics.velocity));
  wrong += !(abs(dot<T>(shear, n)) <= rounding);
  wrong += !(norm<T>(Vec3<T>(shear - step.shear_force)) <= rounding);
  wrong += !(step.friction_work >= T(0) && step.dashpot_work >= T(0));

  ContactKinematics<T> deeper = now.kinematics;
  deeper.overlap = deeper.overlap * T(2);
  wrong += !(law.step(now.pair, deeper, law.virgin()).normal_elastic > step.normal_elastic);
  const ContactStiffness<T> stiffness = law.stiffness(now.pair, now.kinematics.overlap, law.virgin());
  wrong += !(stiffness.normal > T(0));
  wrong += (stiffness.shear > T(0)) != law.shears;
  return wrong;
}

/// By how much the shear force exceeds mu times the normal force, or falls short of it where the contact slides without
/// dashpots, in roundings of the forces of the step and of the adhesion, which cancels in the load: 8 are the subtraction's
/// own. A law with two coefficients of friction slides at the lower one.
template <class T>
double friction_error(const ErasedLaw<T>& law, const PairProperties<T>& pair, const ContactKinematics<T>& kinematics,
                      const Step<T, typename ErasedLaw<T>::State>& step) {
  T load = T(0), adhesion = T(0);
  if (step.normal_elastic != T(0) || kinematics.overlap > T(0)) {
    adhesion = law.adhesion(pair, kinematics.overlap > T(0) ? kinematics.overlap : T(pair.effective_radius / T(1000)));
    load = positive_part<T>(step.normal_force + adhesion);
  }
  const bool at_limit = step.sliding && !law.damps;
  const Friction<T> friction = law.friction();
  const T shear = norm<T>(shear_part(step, kinematics.normal));
  if (step.sliding && !law.shears) return std::numeric_limits<double>::infinity();
  const T off = at_limit ? maximum<T>(T(shear - load * friction.sliding), T(load * friction.least - shear))
                         : T(shear - load * friction.largest);
  if (off <= T(0)) return 0.0;
  return static_cast<double>(T(off / (epsilon<T>() * (force_scale(step) + adhesion * (T(1) + friction.largest)) +
                                      std::numeric_limits<T>::denorm_min())));
}

/// How many values differ when a step is asked for twice, with other queries in between.
template <class T>
int changed_by_queries(const ErasedLaw<T>& law, const Instant<T>& now) {
  const auto state = now.state;
  law.stiffness(now.pair, now.kinematics.overlap, state);
  law.stored_energy(now.pair, now.kinematics.overlap, state);
  const auto again = law.step(now.pair, now.kinematics, state);
  int changed = !same<T>(again.force, now.step.force) + !same<T>(again.couple, now.step.couple);
  for (std::size_t i = 0; i < law.state_size(); ++i)
    changed += (state[i] != now.state[i]) + (again.state[i] != now.step.state[i]);
  return changed;
}

/// By how much a step of dt = 0 after a step differs from it: force, couple and history, each in its own roundings; infinite
/// where a discrete value changes. The slip velocity carries the roundings of the whole velocity, and so does the history.
template <class T>
double changed_by_set_up(const ErasedLaw<T>& law, const Instant<T>& now) {
  using std::abs;
  ContactKinematics<T> set_up = now.kinematics;
  set_up.dt = T(0);
  const auto again = law.step(now.pair, set_up, now.step.state);
  const T tiny = std::numeric_limits<T>::min();
  const T force = norm<T>(Vec3<T>(again.force - now.step.force)) / (force_scale(now.step) + tiny);
  // A history that a step takes back almost all of keeps the roundings of what it was.
  const auto size = [&now](std::size_t i) { return maximum<T>(T(abs(now.state[i])), T(abs(now.step.state[i]))); };
  T largest_couple = norm<T>(now.step.couple);  // or the spring's, where a dashpot acts against it
  for (std::size_t i = 0; i < law.state_size(); ++i)
    if (law.state_values[i].unit == std::string_view("N m")) largest_couple = maximum<T>(largest_couple, size(i));
  // Rolling carries the roundings of the whole spin, as slip does those of the velocity.
  const Vec3<T>& w = now.kinematics.relative_spin;
  const T spin = norm<T>(w), rolling = norm<T>(Vec3<T>(w - now.kinematics.normal * dot<T>(w, now.kinematics.normal)));
  const T share = spin > T(0) ? T(rolling / spin) : T(1);
  const T couple = share * norm<T>(Vec3<T>(again.couple - now.step.couple)) / (largest_couple + tiny);
  T worst = maximum<T>(force, couple);
  for (std::size_t i = 0; i < law.state_size(); ++i) {
    const std::string_view unit = law.state_values[i].unit;
    const bool component = law.state_values[i].kind == ValueKind::vector;
    if (!component && unit == "1" && again.state[i] != now.step.state[i])
      return std::numeric_limits<double>::infinity();
    T scale = size(i);
    for (std::size_t j = 0; component && j < law.state_size(); ++j)
      if (law.state_values[j].kind == ValueKind::vector && law.state_values[j].unit == unit)
        scale = maximum<T>(scale, size(j));
    const T part = unit == "N m" && component ? share : T(1);
    worst = maximum<T>(worst, T(part * abs(again.state[i] - now.step.state[i]) / (scale + tiny)));
  }
  const Vec3<T>& v = now.kinematics.velocity;
  const Vec3<T> slip = v - now.kinematics.normal * dot<T>(v, now.kinematics.normal);
  return static_cast<double>(T(worst / epsilon<T>() * norm<T>(slip) / norm<T>(v)));
}

}  // namespace contactlaws::test
