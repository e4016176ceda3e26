// The ballast probe of examples/ballast/probe in a small size: its parts, its verdicts, its restart.
#include <filesystem>

#include "ballast/probe/results.hpp"
#include "ballast/probe/test.hpp"
#include "catch.hpp"

using namespace probe;

namespace {

const std::vector<dem::ClumpShape>& shapes() {
  static const std::vector<dem::ClumpShape> three = unit_clumps();
  return three;
}
/// Some 50 grains.
const Sample& small_sample() {
  static const Sample sample = [] {
    SampleSize size;
    size.diameter = 0.12;
    size.height = 0.18;
    return make_sample(size, shapes());
  }();
  return sample;
}
/// Ten times as fast as the paper's.
TestPlan hasty() {
  TestPlan plan;
  plan.settle_time = 0.03;
  plan.confine_time = 0.05;
  plan.slowest = 1e-7;
  plan.fastest = 1e-2;
  plan.unbalanced = 1e-6;
  plan.hold_time = 0.01;
  plan.points_per_decade = 10;
  return plan;
}

struct TemporaryFolder {
  std::filesystem::path path = std::filesystem::temp_directory_path() / "contactlaws_test_probe";
  TemporaryFolder() {
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path); }
};

}  // namespace

TEST_CASE("the shapes are ballast-like: flatness, elongation, corners") {
  REQUIRE(shapes().size() == 3);
  for (const dem::ClumpShape& shape : shapes()) {
    const Vec3 extent = extents(shape);
    CHECK(extent.y() == Approx(1.0));
    CHECK(extent.y() / extent.x() > 0.6);
    CHECK(extent.y() / extent.x() < 0.9);
    CHECK(extent.z() / extent.y() > 0.5);
    CHECK(extent.z() / extent.y() < 0.9);
    for (const dem::Pebble& pebble : shape.pebbles) CHECK(pebble.radius > 0.1);
  }
}

TEST_CASE("grains have the sieve curve and the volume that were asked for") {
  SampleSize size;
  size.diameter = 0.3;
  size.height = 0.45;
  Random draw(3);
  const std::vector<Grain> grains = draw_grains(size, shapes(), draw);
  CHECK(grains.size() > 650);  // the paper has 747
  CHECK(grains.size() < 850);
  double volume = 0.0, below_40 = 0.0;
  for (const Grain& grain : grains) {
    const double own = shapes()[grain.shape].volume * std::pow(grain.size, 3);
    volume += own;
    if (grain.size < 40e-3) below_40 += own;
  }
  const double vessel = contactlaws::pi<double>() * 0.15 * 0.15 * 0.45;
  CHECK(vessel / volume - 1.0 == Approx(0.700).epsilon(1e-12));
  CHECK(below_40 / volume == Approx(0.475).margin(0.01));
}

TEST_CASE("the sample is packed without stress at the voids ratio asked for") {
  // Looser than ballast: grains half as wide as this small vessel jam at 0.7.
  SampleSize size;
  size.diameter = 0.12;
  size.height = 0.18;
  size.voids_ratio = 0.9;
  const Sample sample = make_sample(size, shapes());
  Specimen<Hertz> specimen(make_law<Hertz>(0.0), boundary_law(), shapes(), sample);
  specimen.clumps.start(specimen.scene);
  double solid = 0.0;
  for (const dem::Clump& clump : specimen.clumps.all) {
    solid += clump.mass / granite.density;
    CHECK(std::hypot(clump.position.x(), clump.position.y()) < sample.radius);
  }
  CHECK(specimen.vessel.area(specimen.scene) * Vessel::height(specimen.scene) / solid - 1.0 ==
        Approx(0.900).epsilon(1e-9));
  CHECK(specimen.vessel.axial_stress(specimen.scene) < 1.5e3);  // 1 % of the pressure to come
  CHECK(specimen.vessel.radial_stress(specimen.scene) < 1.5e3);
}

TEST_CASE("distances shrink with the vessel, so that no grain is swept ahead of a wall") {
  SampleSize size;
  size.diameter = 0.2;
  size.height = 0.3;
  size.voids_ratio = 30.0;  // so few grains that some never touch
  constexpr double start = 2.0;
  dem::CaseControl no_file;
  const Sample before = scattered(size, shapes(), start), after = shrink(size, shapes(), no_file);
  const auto reach = [](const Grain& grain) { return shapes()[grain.shape].reach * grain.size; };
  std::size_t free = 0;
  for (std::size_t i = 0; i < before.grains.size(); ++i) {
    const Vec3 expected = before.grains[i].position / start;
    const double own = reach(before.grains[i]);
    bool touches = std::hypot(expected.x(), expected.y()) + own > after.radius || expected.z() < own ||
                   expected.z() + own > after.height;
    for (std::size_t j = 0; j < before.grains.size(); ++j)
      touches |= j != i && (after.grains[j].position - expected).norm() < own + reach(before.grains[j]);
    if (touches) continue;
    ++free;
    CHECK((after.grains[i].position - expected).norm() < 1e-9);  // rounding of 10 000 steps
  }
  CHECK(free > 0);
}

TEST_CASE("the pressure of the cylinder comes to rest at the pressure outside, without noise") {
  TestPlan plan = hasty();
  Test<Hertz> test(plan, shapes(), small_sample());
  while (test.state.phase != Phase::load) test.step();
  CHECK(test.specimen.vessel.radial_stress(test.specimen.scene) == Approx(plan.pressure).epsilon(1e-4));
  // The top platen carries the pressure and its weight; the bottom one the grains' weight too.
  const auto& walls = test.specimen.scene.walls;
  const double area = test.specimen.vessel.area(test.specimen.scene), lid = test.specimen.vessel.platen_mass * 9.81;
  double grains = 0.0;
  for (const dem::Clump& clump : test.specimen.clumps.all) grains += clump.mass * 9.81;
  CHECK(walls[Vessel::top].normal_force == Approx(plan.pressure * area + lid).epsilon(1e-5));
  CHECK(walls[Vessel::bottom].normal_force == Approx(plan.pressure * area + lid + grains).epsilon(1e-5));
  CHECK(test.state.rest_unbalanced <= plan.unbalanced);
  CHECK(test.state.identity < 1e-5);
}

TEST_CASE("a platen that tilts: inclination at rest and period on three springs, as of a disc in closed form") {
  // Three fixed balls on a circle carry the top platen from below, in this case a disc facing down; one stands `higher` than the
  // others. Moments vanish only where all three forces are equal, so the platen takes the slope of the three tops.
  constexpr double around = 0.1, higher = 1e-5, ball_radius = 0.01;  // [m]
  dem::Simulation<Boundary> scene(boundary_law());
  scene.log = nullptr;
  Vessel vessel;
  vessel.add_to(scene, 0.15, 0.4);
  for (int i = 0; i < 3; ++i) {
    const double turn = 2.0 * contactlaws::pi<double>() * i / 3.0;
    const double top = 0.4 + (i == 0 ? higher : 0.0);
    scene.add(dem::Ball{contactlaws::sphere(granite, ball_radius),
                        {around * std::cos(turn), around * std::sin(turn), top - ball_radius},
                        Vec3::Zero(),
                        Vec3::Zero(),
                        false});
  }
  vessel.top_moves = vessel.top_tilts = true;
  vessel.pressure = 1.5e3;
  scene.time_step = 1e-5;
  const auto slope = [&scene] {
    const Vec3& facing = scene.walls[Vessel::top].facing;
    return facing.x() / facing.z();  // rises with x
  };
  const auto step = [&] {
    vessel.push(scene);
    scene.step();
  };
  scene.local_damping = 0.7;
  for (int i = 0; i < 20000; ++i) step();
  const double rest = -higher / (1.5 * around);
  // The contact on a ball moves by the slope times its radius: the load times the radius is 2e-5 of the springs' 3/2 k a^2.
  CHECK(slope() == Approx(rest).epsilon(1e-4));
  CHECK(scene.walls[Vessel::top].facing.norm() == Approx(1.0).epsilon(1e-12));
  CHECK(scene.walls[Vessel::top].facing.y() == Approx(0.0).margin(1e-9));

  // Swings about the rest: three springs k at the distance a resist a tilt with 3/2 k a^2.
  scene.local_damping = 0.0;
  scene.walls[Vessel::top].spin = {0.0, 1e-4, 0.0};
  const double mass = Vessel::platen_mass_per_area * contactlaws::pi<double>() * 0.15 * 0.15;
  const double inertia = mass * (0.15 * 0.15 / 4.0 + 0.04 * 0.04 / 12.0);
  const double period =
      2.0 * contactlaws::pi<double>() * std::sqrt(inertia / (1.5 * boundary_stiffness * around * around));
  double first = 0.0, last = 0.0;  // times at which it comes through the rest upward
  int swings = -1;
  for (double before = slope(); swings < 10;) {
    step();
    const double now = slope();
    if (before < rest && now >= rest) {
      last = scene.time;
      if (++swings == 0) first = last;
    }
    before = now;
  }
  CHECK((last - first) / 10.0 == Approx(period).epsilon(1e-3));  // a step in ten periods is 1e-4 of them
}

TEST_CASE("the three laws differ on one small sample as on the large one") {
  TemporaryFolder folder;
  Tests tests;
  const auto run = [&](auto law, const char* name) {
    dem::CaseControl control((folder.path / name).string(), {});
    tests[name] = Test<decltype(law)>(hasty(), shapes(), small_sample()).run(control);
  };
  run(Hertz(), "hertz");
  run(Elastic(), "elastic");
  run(ElastoPlastic(), "elasto_plastic");
  const TestState &hertz = tests.at("hertz"), &elastic = tests.at("elastic"), &plastic = tests.at("elasto_plastic");
  CHECK(initial_modulus(plastic.load) > 1.1 * initial_modulus(elastic.load));
  CHECK(initial_modulus(hertz.load) > 1.1 * initial_modulus(elastic.load));
  CHECK(degraded_modulus(plastic.load) < 0.9 * initial_modulus(plastic.load));
  CHECK(degraded_modulus(elastic.load) > 0.8 * initial_modulus(elastic.load));
  CHECK(elastic.load.front().coordination > hertz.load.front().coordination);
  CHECK(plastic.unload.back().strain > elastic.unload.back().strain);
  CHECK(mean_over(plastic.load, 1e-9, 1e-8, virgin_share) < 0.05);
  CHECK(mean_over(plastic.load, 7e-5, 1.42e-4, virgin_share) > 0.4);
  CHECK(at_strain(plastic.load, 1e-4).unloading_direction < 20.0);
  CHECK(plastic.largest_force < 1776.0);
}

TEST_CASE("the onset of degradation is where the modulus falls for good, not where a grain lands") {
  constexpr double modulus_before = 200e6, modulus_after = 150e6, onset_strain = 1e-5;  // moduli in Pa
  Curve load;
  double axial = 0.0, last = 0.0;
  for (int k = 0; k <= 120; ++k) {  // 20 points a decade, as TestPlan has them
    const double strain = 1e-9 * std::pow(10.0, k / 20.0);
    axial += (strain <= onset_strain ? modulus_before : modulus_after) * (strain - last);
    last = strain;
    Point point{};
    point.phase_strain = point.strain = strain;
    point.axial = k == 55 ? 0.0 : axial;  // one stress is far off, as where a grain lands
    load.push_back(point);
  }
  // A tangent spans three increments. The first that counts the softer one is .91 of E_0, less than the limit of .95.
  CHECK(onset(load) == load[81].strain);                        // that of point 80 is 1e-5
  CHECK(std::isnan(onset({load.begin(), load.begin() + 80})));  // it ends before the onset
}

TEST_CASE("a test that was stopped goes on with the same bits") {
  TemporaryFolder folder;
  const std::string file = (folder.path / "stopped").string();
  TestPlan plan = hasty();
  const auto [stop_in, membrane] =
      GENERATE(table<Phase, bool>({{Phase::confine, false}, {Phase::load, false}, {Phase::confine, true}}));
  plan.membrane = membrane;
  plan.tilts = true;
  if (membrane) plan.settle_time = 0.005;
  Test<ElastoPlastic> whole(plan, shapes(), small_sample());
  while (whole.state.phase != stop_in || whole.specimen.scene.steps % 100 != 37) whole.step();
  for (int i = 0; i < 500; ++i) whole.step();
  {
    dem::CaseControl control(file, {});
    control.save(whole.specimen.scene, whole);
  }
  Test<ElastoPlastic> resumed(plan, shapes(), small_sample());
  dem::CaseControl control(file, {});
  REQUIRE(control.resume(resumed.specimen.scene, resumed));
  CHECK(resumed.unbalanced() == whole.unbalanced());
  for (auto* test : {&whole, &resumed})
    for (int i = 0; i < (membrane ? 800 : 3000); ++i) test->step();
  CHECK(resumed.specimen.scene.time == whole.specimen.scene.time);
  CHECK(resumed.state.load.size() == whole.state.load.size());
  if (!whole.state.load.empty()) CHECK(resumed.state.load.back().axial == whole.state.load.back().axial);
  if (membrane)
    for (std::size_t b = 0; b < whole.specimen.membrane->spheres(); ++b)
      CHECK(resumed.specimen.membrane->scene.balls.position[b] == whole.specimen.membrane->scene.balls.position[b]);
  for (std::size_t i = 0; i < whole.specimen.clumps.size(); ++i) {
    const dem::Clump &one = whole.specimen.clumps.all[i], &other = resumed.specimen.clumps.all[i];
    CHECK(one.position == other.position);
    CHECK(one.orientation.coeffs() == other.orientation.coeffs());
    CHECK(one.angular_momentum == other.angular_momentum);
  }
}

TEST_CASE("packing that was stopped in either phase goes on with the same bits") {
  TemporaryFolder folder;
  SampleSize size;
  size.diameter = 0.12;
  size.height = 0.18;
  size.voids_ratio = 1.5;  // few grains
  // Stops at the n-th look, as Ctrl-C does.
  const auto stopped_twice = [&](const char* name, const auto& phase) {
    for (const int looks : {7, 11, 0}) {
      dem::CaseControl control((folder.path / name).string(), {});
      int seen = 0;
      if (looks > 0) control.stop_when([&seen, looks] { return ++seen == looks; });
      try {
        const Sample sample = phase(control);
        CHECK(looks == 0);
        return sample;
      } catch (const common::Stopped&) {
        CHECK(looks > 0);
      }
    }
    return Sample{};
  };
  dem::CaseControl no_file;
  const Sample shrunk = shrink(size, shapes(), no_file);
  const Sample shrunk_in_parts =
      stopped_twice("shrink", [&](dem::CaseControl& control) { return shrink(size, shapes(), control); });
  CHECK(nlohmann::json(shrunk_in_parts) == nlohmann::json(shrunk));
  const Sample relaxed = relax(shrunk, shapes(), no_file);
  const Sample relaxed_in_parts =
      stopped_twice("relax", [&](dem::CaseControl& control) { return relax(shrunk, shapes(), control); });
  CHECK(nlohmann::json(relaxed_in_parts) == nlohmann::json(relaxed));
}

TEST_CASE("a test goes back to the same bits after a probe of noise, also where it was stopped in one") {
  TemporaryFolder folder;
  TestPlan plan = hasty();
  plan.tilts = true;
  Test<Elastic> plain(plan, shapes(), small_sample());
  plan.noise_levels = {1e-4};
  plan.noise_strain = 1e-8;
  Test<Elastic> noisy(plan, shapes(), small_sample());
  while (noisy.state.phase != Phase::load) noisy.step();
  for (int i = 0; i < 150; ++i) noisy.step();
  dem::CaseControl control((folder.path / "noisy").string(), {});
  control.save(noisy.specimen.scene, noisy);
  Test<Elastic> resumed(plan, shapes(), small_sample());
  dem::CaseControl again((folder.path / "noisy").string(), {});
  REQUIRE(again.resume(resumed.specimen.scene, resumed));
  const auto to_load = [](Test<Elastic>& test, std::size_t probes) {
    while (test.state.phase != Phase::load || test.state.noise.size() < probes) test.step();
  };
  to_load(plain, 0);
  to_load(resumed, 1);
  CHECK(resumed.state.noise[0].load.size() > 5);
  CHECK(resumed.state.noise[0].unbalanced <= 1e-4);
  CHECK(resumed.state.noise[0].unbalanced > 1e-6);
  CHECK(resumed.state.rest_unbalanced == plain.state.rest_unbalanced);
  CHECK(resumed.specimen.scene.steps == plain.specimen.scene.steps);
  for (std::size_t i = 0; i < plain.specimen.clumps.size(); ++i)
    CHECK(resumed.specimen.clumps.all[i].position == plain.specimen.clumps.all[i].position);
}

TEST_CASE("an unstable step and a grain that leaves the vessel: the message says what, when, and what to try") {
  TemporaryFolder folder;
  TestPlan plan = hasty();
  const auto message = [&](Test<Hertz>& test) -> std::string {
    dem::CaseControl control((folder.path / "lost").string(), {});
    try {
      test.run(control);
    } catch (const std::exception& fault) {
      return fault.what();
    }
    return "";
  };
  SECTION("unstable") {
    plan.safety = 8.0;
    Test<Hertz> test(plan, shapes(), small_sample());
    CHECK_THAT(message(test), ContainsSubstring("Try a s"));
  }
  SECTION("a grain leaves") {
    Test<Hertz> test(plan, shapes(), small_sample());
    test.specimen.clumps.all[3].position.x() = 0.2;
    CHECK_THAT(message(test), ContainsSubstring("has left the vessel at 0."));
  }
}
