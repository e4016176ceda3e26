// A law from a file, behind virtual calls (examples/contact_path/any_law.hpp), against the same law composed with the library:
// the same bits on random paths. Built with -ffp-contract=off: see CMakeLists.txt.
#include <cstring>
#include <string>

#include "catch.hpp"
#include "contact_path/any_law.hpp"
#include "contact_path/law_file.hpp"
#include "random.hpp"

namespace {

using namespace contactlaws;

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
bool same_bits(const Vec3<double>& a, const Vec3<double>& b) {
  return same_bits(a.x(), b.x()) && same_bits(a.y(), b.y()) && same_bits(a.z(), b.z());
}

/// The effective properties that the laws' defaults would take from [pair] are replaced by random pairs.
const std::string pair_table =
    "[pair]\neffective_radius = 1\neffective_young = 1\neffective_shear = 1\neffective_mass = 1\nmin_radius = "
    "1\nlength = 1\n";

template <class Law>
void same_bits_as(const Law& law, const std::string& text) {
  INFO(text);
  const contact_path::LawSpec spec = contact_path::parse_law(text + pair_table, "law.toml");
  const auto any = contact_path::build_law<double>(spec, contact_path::build_pair<double>(spec));
  constexpr auto names = Law::state_values();
  REQUIRE(any->state_values().size() == names.size());
  for (std::size_t i = 0; i < names.size(); ++i) CHECK(std::string(any->state_values()[i].name) == names[i].name);

  test::Random random;
  for (int path = 0; path < test::cases(1000); ++path) {
    const auto pair = test::random_pair(random);
    typename Law::State state{};
    if constexpr (decltype(Law::bridge)::acts) Law::make_wet(state, 0.0, 0.0);
    std::vector<double> any_state = any->first_state();
    for (int i = 0; i < 10; ++i) {
      const double deepest = pair.effective_radius * 1e-3;
      ContactKinematics<double> motion;
      motion.normal = random.direction();
      motion.overlap = random.uniform(-0.5 * deepest, deepest);
      const Vec3<double> direction = random.direction();
      motion.velocity = direction * random.log_uniform(1e-3, 1e3);
      motion.dt = random.log_uniform(1e-9, 1e-3);
      motion.normal_spin = random.uniform(-1.0, 1.0);
      const Vec3<double> axis = random.direction();
      motion.relative_spin = axis * random.log_uniform(1e-3, 1e3);
      const auto step = law.step(pair, motion, state);
      const auto any_step = any->step(pair, motion, any_state);
      state = step.state;
      any_state = any_step.state;
      REQUIRE(same_bits(step.force, any_step.force));
      REQUIRE(same_bits(step.couple, any_step.couple));
      REQUIRE(step.sliding == any_step.sliding);
      REQUIRE(step.active == any_step.active);
      REQUIRE(same_bits(law.stored_energy(pair, motion.overlap, state),
                        any->stored_energy(pair, motion.overlap, any_state)));
      REQUIRE(same_bits(law.interaction_range(pair), any->interaction_range(pair)));
    }
  }
}

const std::string rough = "fractal_dimension = 2.13\nroughness = 26.1e-6\n";

TEST_CASE("a law from a file has the bits of the law that the library composes") {
  Hill<double> wet;
  wet.damping.damping_constant = 0.07;
  wet.shear.friction = 0.4;
  wet.bridge.suction = 200e3;
  same_bits_as(wet, R"(
    normal = "hertz"
    damping = { law = "dashpots", damping_constant = 0.07 }
    shear = { law = "force", friction = 0.4 }
    bridge = { law = "suction", suction = 200e3, wet = true }
  )");

  DryHill<double, Tension::clipped> dry;
  dry.damping.damping_constant = 0.07;
  dry.shear.friction = 0.4;
  same_bits_as(dry, R"(
    normal = "hertz"
    damping = { law = "dashpots", damping_constant = 0.07, tension = "clipped" }
    shear = { law = "force", friction = 0.4 }
  )");

  using Plastic = PohrtPopovElastoPlastic<double, Recontact::same_spot>;
  ContactLaw<Plastic, NoDashpots<double>, ShearForce<double, ConstantRatio<double>>> ballast;
  ballast.normal = Plastic::of({2.13, 26.1e-6});
  ballast.shear.ratio = 0.86;
  ballast.shear.friction = 0.7;
  same_bits_as(ballast, "[normal]\nlaw = \"pohrt_popov_elasto_plastic\"\nrecontact = \"same_spot\"\n" + rough +
                            "[shear]\nlaw = \"force\"\nratio = 0.86\nfriction = 0.7\n");
}

TEST_CASE("the options of a law file choose the types of the library") {
  using Friction = StaticKinetic<double>;
  using Shear = IncrementalShear<double, Stored::displacement, Unloading::rescales, ElasticRatio<double>,
                                 rotation::Rotate<double>, Friction>;
  using Plastic = PohrtPopovElastoPlastic<double, Recontact::fresh_surface>;
  using Damping = Dashpots<double, Tension::allowed, ShearDashpot::given>;
  ContactLaw<Plastic, Damping, Shear, Dry<double>, RollingSpring<double>> law;
  law.normal = Plastic::of({2.13, 26.1e-6});
  law.damping.damping_constant = 0.3;
  law.damping.shear_damping_constant = 0.1;
  law.shear.ratio = 0.6;
  law.shear.friction = 0.4;
  law.shear.static_friction = 0.5;
  law.rolling.rolling_friction = 0.2;
  same_bits_as(law, "[normal]\nlaw = \"pohrt_popov_elasto_plastic\"\n" + rough + R"(
    [damping]
    law = "dashpots"
    damping_constant = 0.3
    shear_damping_constant = 0.1
    [shear]
    law = "displacement_rescaled"
    stiffness = "elastic_ratio"
    ratio = 0.6
    friction = 0.4
    static_friction = 0.5
    rotation = "rotate"
    [rolling]
    law = "spring"
    rolling_friction = 0.2
  )");

  ContactLaw<Dmt<double>, Dashpots<double>, ShearDisplacement<double, Mindlin<double>, rotation::Project<double>>> dmt;
  dmt.normal.work_of_adhesion = 0.05;
  dmt.damping.damping_constant = 0.3;
  dmt.shear.friction = 0.5;
  same_bits_as(dmt, R"(
    normal = { law = "dmt", work_of_adhesion = 0.05 }
    damping = { law = "dashpots", damping_constant = 0.3 }
    shear = { law = "displacement", friction = 0.5, rotation = "project" }
  )");

  CohesivePowderProperties<double> powder;
  powder.work_of_adhesion = 50.0;
  powder.friction = 0.4;
  powder.rolling_friction = 0.2;
  powder.damping_constant = 0.3;
  same_bits_as(cohesive_powder(powder), R"(
    normal = { law = "jkr", work_of_adhesion = 50 }
    damping = { law = "dashpots", damping_constant = 0.3 }
    shear = { law = "force", friction = 0.4 }
    rolling = { law = "spring", rolling_friction = 0.2 }
  )");
}

TEST_CASE("each rolling law of a file is that of the library") {
  const auto rolls = [](const auto& rolling, const std::string& text) {
    using Rolling = std::decay_t<decltype(rolling)>;
    ContactLaw<Hertz<double>, NoDashpots<double>, ShearForce<double>, Dry<double>, Rolling> law;
    law.shear.friction = 0.4;
    law.rolling = rolling;
    same_bits_as(law,
                 "normal = \"hertz\"\nshear = { law = \"force\", friction = 0.4 }\nrolling = { law = " + text + " }\n");
  };
  using Of = ShearRolling<double>;
  using Given = GivenRolling<double>;
  rolls(RollingSpring<double>{0.2}, R"("spring", rolling_friction = 0.2)");
  rolls(RollingTorque<double>{0.2}, R"("torque", rolling_friction = 0.2)");
  rolls(RollingSpringDashpot<double>{{}, 0.2, 0.3},
        R"("spring_dashpot", rolling_friction = 0.2, rolling_damping = 0.3)");
  rolls(RollingSpringDashpot<double, Of>{{0.6}, 0.2, 0.3},
        R"("spring_dashpot_of_shear", stiffness_ratio = 0.6, rolling_friction = 0.2, rolling_damping = 0.3)");
  rolls(RollingSpringDashpot<double, Given>{{7.0}, 0.2, 0.3},
        R"("spring_dashpot_given", rolling_stiffness = 7, rolling_friction = 0.2, rolling_damping = 0.3)");
  rolls(TwistingSpringDashpot<double>{{0.4, 0.3}}, R"("twisting", twisting_friction = 0.4, twisting_damping = 0.3)");
  rolls(TwistingSpringDashpot<double, GivenTwisting<double>>{{5.0, 1e-3, 2.0}},
        R"("twisting_given", twisting_stiffness = 5, twisting_reach = 1e-3, twisting_viscosity = 2)");
  rolls(RollAndTwist<double, RollingSpringDashpot<double>>{{{}, 0.2, 0.3}, {0.4}},
        R"("spring_dashpot_twisting", rolling_friction = 0.2, rolling_damping = 0.3, twisting_friction = 0.4)");
  rolls(RollAndTwist<double, RollingSpringDashpot<double, Given>, TwistingSpringDashpot<double>>{{{7.0}, 0.2, 0.3},
                                                                                                 {{0.4, 0.3}}},
        R"("spring_dashpot_given_twisting", rolling_stiffness = 7, rolling_friction = 0.2, rolling_damping = 0.3, )"
        R"(twisting_friction = 0.4, twisting_damping = 0.3)");
}

}  // namespace
