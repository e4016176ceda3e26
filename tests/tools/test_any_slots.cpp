// The path driver hides two slots behind a virtual call (examples/contact_path/any_slots.hpp): the same bits come out, on
// random paths, as from the law that the library composes. Built with -ffp-contract=off: see CMakeLists.txt.
#include <cstring>

#include "catch.hpp"
#include "contactlaws/laws.hpp"
#include "examples/contact_path/any_slots.hpp"
#include "random.hpp"

namespace {

using namespace contactlaws;
using contact_path::AnyNormal;
using contact_path::AnyShear;

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

template <class Normal, class Damping, class Shear, class Bridge>
void same_bits_as(const ContactLaw<Normal, Damping, Shear, Bridge>& law) {
  using Law = ContactLaw<Normal, Damping, Shear, Bridge>;
  using Any = ContactLaw<AnyNormal<double>, Damping, AnyShear<double>, Bridge>;
  const Any any{AnyNormal<double>(law.normal), law.damping, AnyShear<double>(law.shear), law.bridge};
  test::Random random;
  for (int path = 0; path < test::cases(1000); ++path) {
    const auto pair = test::random_pair(random);
    typename Law::State state{};
    typename Any::State any_state{};
    if constexpr (Bridge::acts) {
      Law::make_wet(state, 0.0, 0.0);
      Any::make_wet(any_state, 0.0, 0.0);
    }
    for (int i = 0; i < 10; ++i) {
      const double deepest = pair.effective_radius * 1e-3;
      const ContactKinematics<double> motion{random.direction(), random.uniform(-0.5 * deepest, deepest),
                                             random.direction() * random.log_uniform(1e-3, 1e3),
                                             random.log_uniform(1e-9, 1e-3), random.uniform(-1.0, 1.0)};
      const auto step = law.step(pair, motion, state);
      const auto any_step = any.step(pair, motion, any_state);
      state = step.state;
      any_state = any_step.state;
      for (int axis = 0; axis < 3; ++axis) REQUIRE(same_bits(step.force[axis], any_step.force[axis]));
      REQUIRE(step.sliding == any_step.sliding);
      REQUIRE(step.active == any_step.active);
      REQUIRE(same_bits(law.stored_energy(pair, motion.overlap, state),
                        any.stored_energy(pair, motion.overlap, any_state)));
    }
  }
}

TEST_CASE("slots behind a virtual call yield the bits of the law itself") {
  HillProperties<double> properties;
  properties.friction = 0.4;
  properties.suction = 200e3;
  properties.damping_constant = 0.07;
  same_bits_as(hill(properties));
  same_bits_as(dry_hill(properties));

  const RoughSurface<double> ballast{2.13, 26.1e-6};
  same_bits_as(RoughBallast<double>{PohrtPopovElastoPlastic<double>::of(ballast), {}, {{0.86}, 0.7}, {}});
  same_bits_as(LinearSpringDashpot<double, Tension::clipped>{{1e6}, {0.3}, {{1.0}, 0.5}, {}});
  using Turning = ShearDisplacementRescaled<double, Mindlin<double>, rotation::Rotate<double>>;
  same_bits_as(ContactLaw<Hertz<double>, NoDashpots<double>, Turning>{{}, {}, {{}, 0.5}, {}});
}

}  // namespace
