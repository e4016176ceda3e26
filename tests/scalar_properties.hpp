// The properties of every law, as tests over the tuple `Scalars` of the file that includes this one.
#pragma once

#include <string>
#include <type_traits>

#include "law_properties.hpp"

namespace contactlaws::test {

/// A contact in the midst of a random path: what the last step is asked, and the largest force on the way there [N],
/// which is what rounding errors of the history are in proportion to.
template <class Law>
struct Moment {
  using T = typename Law::Scalar;
  PairProperties<T> pair;
  ContactKinematics<T> kinematics;
  typename Law::State state;
  T force;
};

template <class Law>
Moment<Law> random_moment(const Law& law, Random& random) {
  using T = typename Law::Scalar;
  const Path path = random_path(random, 6);
  Moment<Law> now{path.pair.cast<T>(), {}, start<Law>(path), T(0)};
  for (const auto& kinematics : path.steps) {
    now.kinematics = kinematics.template cast<T>();
    now.kinematics.normal = now.kinematics.normal / norm<T>(now.kinematics.normal);
    const auto step = law.step(now.pair, now.kinematics, now.state);
    now.force = maximum<T>(now.force, force_scale(step));
    if (&kinematics != &path.steps.back()) now.state = step.state;
  }
  return now;
}

template <class T>
T epsilon() {
  return std::numeric_limits<T>::epsilon();
}

template <class T>
bool same(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x() == b.x() && a.y() == b.y() && a.z() == b.z();
}

/// Whether two states agree in every bit (but the sign of a zero), the second read in the frame of swapped bodies or not.
template <class Law>
bool same_state(typename Law::State a, typename Law::State b, bool swapped = false) {
  using T = typename Law::Scalar;
  for (std::size_t i = 0; i < Law::state_size; ++i) {
    const T sign = swapped ? T(Law::exchange_sign(i)) : T(1);
    if (values_of<Law>(a)[i] != sign * values_of<Law>(b)[i]) return false;
  }
  return true;
}

template <class T, class State>
Vec3<T> shear_part(const Step<T, State>& step, const Vec3<T>& normal) {
  return step.force - normal * T(step.normal_force - step.bridge_force);
}

/// A rotation drawn at random, orthogonal to the precision of T.
template <class T>
Eigen::Matrix<T, 3, 3> random_rotation(Random& random) {
  const Vec3<double> axis = random.direction();
  const Vec3<double> other = random.direction_across(axis);
  Vec3<T> a(T(axis.x()), T(axis.y()), T(axis.z()));
  a = a / norm<T>(a);
  Vec3<T> b(T(other.x()), T(other.y()), T(other.z()));
  b = b - a * a.dot(b);
  b = b / norm<T>(b);
  Eigen::Matrix<T, 3, 3> rotation;
  rotation.col(0) = a;
  rotation.col(1) = b;
  rotation.col(2) = a.cross(b);
  return rotation;
}

/// Other units: every quantity is multiplied by powers of these, by its SI unit.
template <class T>
struct Units {
  T length, mass, time;

  T factor(const std::string& unit) const {
    const T force = mass * length / (time * time);
    if (unit == "1") return T(1);
    if (unit == "m") return length;
    if (unit == "N") return force;
    if (unit == "N/m") return force / length;
    if (unit == "Pa") return force / (length * length);
    FAIL("no factor for unit " << unit);
    return T(0);
  }
  template <class Slot>
  Slot operator()(Slot slot) const {
    for (const auto& p : Slot::parameters()) slot.*p.member = slot.*p.member * factor(p.unit);
    return slot;
  }
  template <class Law>
  Moment<Law> operator()(Moment<Law> m) const {
    const T pascal = factor("Pa");
    m.pair = {m.pair.effective_radius * length, m.pair.effective_young * pascal, m.pair.effective_shear * pascal,
              m.pair.effective_mass * mass,     m.pair.min_radius * length,      m.pair.length * length};
    m.kinematics.overlap = m.kinematics.overlap * length;
    m.kinematics.velocity = m.kinematics.velocity * T(length / time);
    m.kinematics.dt = m.kinematics.dt * time;
    m.kinematics.normal_spin = m.kinematics.normal_spin / time;
    m.state = (*this)(m.state, Law{});
    m.force = m.force * factor("N");
    return m;
  }
  template <class State, class Law>
  State operator()(State state, const Law&) const {
    for (std::size_t i = 0; i < Law::state_size; ++i) {
      T& value = values_of<Law>(state)[i];
      value = value * factor(Law::state_values()[i].unit);
    }
    return state;
  }
};

template <class T>
T power(const T& base, int exponent) {
  T result = T(1);
  for (int i = 0; i < (exponent < 0 ? -exponent : exponent); ++i) result = result * base;
  return exponent < 0 ? T(T(1) / result) : result;
}

TEMPLATE_LIST_TEST_CASE("an open contact exerts nothing but its bridge's pull, and forgets its shear", "", Scalars) {
  using T = TestType;
  for_each_law<T>([](const auto& law, Random& random) {
    using Law = std::decay_t<decltype(law)>;
    for (int i = 0; i < cases(20); ++i) {
      Moment<Law> m = random_moment(law, random);
      const T range = law.interaction_range(m.pair);
      for (const T& gap : {T(0), T(range / 2), range, T(range * 2 + m.pair.effective_radius)}) {
        m.kinematics.overlap = -gap;
        auto step = law.step(m.pair, m.kinematics, m.state);
        CHECK(step.normal_elastic == 0);
        CHECK(step.normal_force == 0);
        CHECK_FALSE(step.sliding);
        CHECK(same<T>(step.force, m.kinematics.normal * T(-step.bridge_force)));
        if (gap >= range && gap > 0) CHECK(step.bridge_force == 0);
        CHECK(step.active == (gap <= 0 || step.bridge_force > 0));
        typename Law::State forgotten = step.state;
        static_cast<typename decltype(law.shear)::State&>(forgotten) = {};
        CHECK(same_state<Law>(step.state, forgotten));
      }
    }
  });
}

TEMPLATE_LIST_TEST_CASE("a closed contact pushes, and resists motion", "", Scalars) {
  using T = TestType;
  for_each_law<T>([](const auto& law, Random& random) {
    using Law = std::decay_t<decltype(law)>;
    for (int i = 0; i < cases(20); ++i) {
      const Moment<Law> m = random_moment(law, random);
      if (!(m.kinematics.overlap > 0)) continue;
      const auto step = law.step(m.pair, m.kinematics, typename Law::State{});
      CHECK(step.active);
      CHECK(step.normal_elastic > 0);
      CHECK(step.bridge_force == 0);
      const T separating = m.kinematics.velocity.dot(m.kinematics.normal);
      CHECK((separating > 0 ? step.normal_force <= step.normal_elastic : step.normal_force >= step.normal_elastic));

      const Vec3<T> shear = shear_part(step, m.kinematics.normal);
      // Shear is what is left when the normal part is taken away: 8 roundings of forces of this size.
      const T rounding = 8 * epsilon<T>() * force_scale(step);
      CHECK(shear.dot(m.kinematics.velocity - m.kinematics.normal * separating) <=
            rounding * norm<T>(m.kinematics.velocity));
      CHECK(abs(shear.dot(m.kinematics.normal)) <= rounding);

      ContactKinematics<T> deeper = m.kinematics;
      deeper.overlap = deeper.overlap * 2;
      CHECK(law.step(m.pair, deeper, typename Law::State{}).normal_elastic > step.normal_elastic);
      const ContactStiffness<T> stiffness = law.stiffness(m.pair, m.kinematics.overlap, {});
      CHECK(stiffness.normal > 0);
      CHECK((stiffness.shear > 0) == has_shear<Law>);
    }
  });
}

TEMPLATE_LIST_TEST_CASE("friction bounds the shear force", "", Scalars) {
  using T = TestType;
  for_each_law<T>([](const auto& law, Random& random) {
    using Law = std::decay_t<decltype(law)>;
    for (int i = 0; i < cases(40); ++i) {
      const Moment<Law> m = random_moment(law, random);
      const auto step = law.step(m.pair, m.kinematics, m.state);
      const T shear = norm<T>(shear_part(step, m.kinematics.normal));
      const T rounding = 8 * epsilon<T>() * force_scale(step);
      if constexpr (has_shear<Law>) {
        const T strength = law.shear.friction * positive_part<T>(step.normal_force);
        CHECK(shear <= strength + rounding);
        if (step.sliding && !decltype(law.damping)::acts) CHECK(shear >= strength - rounding);
      } else {
        CHECK(shear <= rounding);
        CHECK_FALSE(step.sliding);
      }
    }
  });
}

TEMPLATE_LIST_TEST_CASE("the frame of the observer does not matter", "", Scalars) {
  using T = TestType;
  for_each_law<T>([](const auto& law, Random& random) {
    using Law = std::decay_t<decltype(law)>;
    for (int i = 0; i < cases(20); ++i) {
      const Moment<Law> m = random_moment(law, random);
      const auto step = law.step(m.pair, m.kinematics, m.state);
      const Eigen::Matrix<T, 3, 3> rotation = random_rotation<T>(random);
      const auto turn_vectors = [&](typename Law::State state) {
        if constexpr (Law::state_size >= 3) {
          T* const values = values_of<Law>(state);
          for (std::size_t j = 0; j + 2 < Law::state_size; ++j) {
            if (Law::exchange_sign(j) > 0) continue;  // else the first of a vector's three
            const Vec3<T> turned = rotation * Vec3<T>(values[j], values[j + 1], values[j + 2]);
            for (int k = 0; k < 3; ++k) values[j++] = turned[k];
            --j;
          }
        }
        return state;
      };
      Moment<Law> turned = m;
      turned.kinematics.normal = rotation * m.kinematics.normal;
      turned.kinematics.velocity = rotation * m.kinematics.velocity;
      turned.state = turn_vectors(m.state);
      auto seen = law.step(turned.pair, turned.kinematics, turned.state);

      // Each turned vector is 3 eps off; a step multiplies and adds some 20 of them.
      const T tolerance = 64 * epsilon<T>();
      CHECK(norm<T>(seen.force - rotation * step.force) <= tolerance * m.force);
      auto expected = turn_vectors(step.state);
      for (std::size_t j = 0; j < Law::state_size; ++j) {
        const std::string unit = Law::state_values()[j].unit;
        const T size = unit == "1"   ? T(1)
                       : unit == "N" ? m.force
                       : unit == "m" ? T(m.force / law.stiffness(m.pair, m.kinematics.overlap, m.state).shear)
                                     : values_of<Law>(expected)[j];
        CHECK(abs(values_of<Law>(seen.state)[j] - values_of<Law>(expected)[j]) <= tolerance * size);
      }
    }
  });
}

TEMPLATE_LIST_TEST_CASE("bodies that swap places feel exactly opposite forces", "", Scalars) {
  using T = TestType;
  for_each_law<T>([](const auto& law, Random& random) {
    using Law = std::decay_t<decltype(law)>;
    for (int i = 0; i < cases(100); ++i) {
      const Moment<Law> m = random_moment(law, random);
      Moment<Law> other = m;
      other.kinematics.normal = -m.kinematics.normal;
      other.kinematics.velocity = -m.kinematics.velocity;
      other.kinematics.normal_spin = -m.kinematics.normal_spin;
      for (std::size_t j = 0; j < Law::state_size; ++j) {
        T& value = values_of<Law>(other.state)[j];
        value = value * T(Law::exchange_sign(j));
      }
      const auto step = law.step(m.pair, m.kinematics, m.state);
      const auto seen = law.step(other.pair, other.kinematics, other.state);
      CHECK(same<T>(seen.force, -step.force));
      CHECK(same_state<Law>(seen.state, step.state, true));
      CHECK(seen.normal_elastic == step.normal_elastic);
      CHECK(seen.normal_force == step.normal_force);
      CHECK(seen.sliding == step.sliding);
    }
  });
}

TEMPLATE_LIST_TEST_CASE("units do not matter", "", Scalars) {
  using T = TestType;
  const auto expect = [](const auto& law, const auto& m, const Units<T>& units, const T& tolerance) {
    using Law = std::decay_t<decltype(law)>;
    const Law rescaled{units(law.normal), units(law.damping), units(law.shear), units(law.bridge)};
    const Moment<Law> other = units(m);
    const auto step = law.step(m.pair, m.kinematics, m.state);
    const auto seen = rescaled.step(other.pair, other.kinematics, other.state);
    const Vec3<T> expected = step.force * units.factor("N");
    CHECK(norm<T>(seen.force - expected) <= tolerance * other.force);
    if (tolerance > 0) return;
    CHECK(same_state<Law>(seen.state, units(step.state, law)));
    CHECK(seen.sliding == step.sliding);
    CHECK(rescaled.stored_energy(other.pair, other.kinematics.overlap, seen.state) ==
          law.stored_energy(m.pair, m.kinematics.overlap, step.state) * units.factor("N") * units.length);
  };
  const auto exponent = [](Random& random, int most) {
    return static_cast<int>(random.engine() % static_cast<unsigned>(2 * most + 1)) - most;
  };
  for_each_law<T>([&](const auto& law, Random& random) {
    for (int i = 0; i < cases(20); ++i) {
      const auto m = random_moment(law, random);
      // Squares of forces keep their digits in all units tried, so that all take the same branches.
      if (!square_is_exact<T>(m.force * m.force * power(T(2), -40))) continue;
      // A power of 2 changes no digit. The law takes square roots of single lengths, so of those a power of 4.
      const T two = T(2);
      expect(
          law, m,
          Units<T>{power<T>(4, exponent(random, 2)), power(two, exponent(random, 4)), power(two, exponent(random, 4))},
          T(0));
      if (std::numeric_limits<T>::digits == 24) continue;  // ten powers of ten leave the range of a float
      // Each of some 10 inputs is rounded anew, with up to 9 roundings in its factor, and enters once or twice.
      const T ten = T(10);
      expect(
          law, m,
          Units<T>{power(ten, exponent(random, 9)), power(ten, exponent(random, 9)), power(ten, exponent(random, 9))},
          200 * epsilon<T>());
    }
  });
}

TEMPLATE_LIST_TEST_CASE("asking twice gives the same answer twice", "", Scalars) {
  using T = TestType;
  for_each_law<T>([](const auto& law, Random& random) {
    using Law = std::decay_t<decltype(law)>;
    const Moment<Law> m = random_moment(law, random);
    const Moment<Law> untouched = m;
    const auto first = law.step(m.pair, m.kinematics, m.state);
    law.stiffness(m.pair, m.kinematics.overlap, m.state);
    law.stored_energy(m.pair, m.kinematics.overlap, m.state);
    const auto second = law.step(m.pair, m.kinematics, m.state);
    CHECK(same_state<Law>(m.state, untouched.state));
    CHECK(same<T>(second.force, first.force));
    CHECK(same_state<Law>(second.state, first.state));
  });
}

TEMPLATE_LIST_TEST_CASE("kernels promise not to throw", "", Scalars) {
  for_each_law<TestType>([](const auto& law, Random&) {
    using Law = std::decay_t<decltype(law)>;
    using T = TestType;
    constexpr PairProperties<T>* pair = nullptr;
    constexpr ContactKinematics<T>* kinematics = nullptr;
    constexpr typename Law::State* state = nullptr;
    static_assert(noexcept(law.step(*pair, *kinematics, *state)));
    static_assert(noexcept(law.stiffness(*pair, kinematics->overlap, *state)));
    static_assert(noexcept(law.stored_energy(*pair, kinematics->overlap, *state)));
    static_assert(noexcept(law.interaction_range(*pair)));
  });
}

}  // namespace contactlaws::test
