#include "contactlaws/normal/linear.hpp"

#include "catch.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {

TEST_CASE("Linear: the granite grains of the hill memo, from an effective modulus") {
  const LinearModulus<double> law{29e9};
  const PairProperties<double> pair = granite_pair<double>();
  LinearModulus<double>::State state;
  CHECK(law.normal_stiffness(pair) == Approx(1.82212373908208e8).epsilon(1e-14));  // 15 printed digits
  CHECK(law.respond(state, pair, 1e-4).force == Approx(18221.2373908).epsilon(1e-11));
  CHECK(law.energy(state, pair, 1e-4) == Approx(0.91106186954104).epsilon(1e-14));  // k o^2/2
}

TEST_CASE("Linear: a ball on a wall has r = L = R, so k = E pi R") {
  const ElasticMaterial<double> granite{29e9, 0.15, 2650};
  const PairProperties<double> pair = pair_properties(plane(granite), sphere(granite, 5e-3));
  CHECK(LinearModulus<double>{29e9}.normal_stiffness(pair) == Approx(29e9 * 3.14159265358979324 * 5e-3).epsilon(1e-15));
}

TEST_CASE("Linear: force, tangent and secant of one spring; nothing when open") {
  const LinearSpring<double> law{3e6};
  const PairProperties<double> pair = granite_pair<double>();
  LinearSpring<double>::State state;
  const NormalResponse<double> closed = law.respond(state, pair, 2e-5);
  CHECK(closed.force == 3e6 * 2e-5);
  CHECK(closed.stiffness == 3e6);
  CHECK(closed.secant == 3e6);
  CHECK(closed.max_tangent == 3e6);
  CHECK(law.energy(state, pair, 2e-5) == Approx(0.5 * 3e6 * 2e-5 * 2e-5).epsilon(1e-15));
  const NormalResponse<double> open = law.respond(state, pair, 0.0);
  CHECK(open.force == 0.0);
  CHECK(open.stiffness == 0.0);
  CHECK(open.secant == 0.0);
}

TEMPLATE_TEST_CASE("Linear: accuracy", "", double, float) {
  using T = TestType;
  Random random;
  Worst given("linear force of a given stiffness" + precision_name<T>()),
      modulus("linear force from a modulus" + precision_name<T>());
  for (int i = 0; i < cases(100000); ++i) {
    const PairProperties<T> pair = wide_pair<T>(random);
    const T overlap = random.binary<T>(smallest_exponent<T>, 4);
    const LinearSpring<T> spring{random.binary<T>(-10, 40)};
    const LinearModulus<T> law{pair.effective_young};
    const auto exactly = [&](auto exact_law) {
      typename decltype(exact_law)::State state;
      return exact_law.respond(state, pair.template cast<Binary200>(), Binary200(overlap)).force;
    };
    typename LinearSpring<T>::State none;
    typename LinearModulus<T>::State nothing;
    given.see(ulps(spring.respond(none, pair, overlap).force, exactly(slot_cast<Binary200>(spring))),
              spring.normal_stiffness, overlap);
    modulus.see(ulps(law.respond(nothing, pair, overlap).force, exactly(slot_cast<Binary200>(law))), law.modulus,
                pair.min_radius, pair.length, overlap);
  }
  CHECK(given.error() <= 1.0);  // what the header promises
  CHECK(modulus.error() <= 5.0);
}

}  // namespace contactlaws::test
