// The Class 5 specimens of examples/memo/class5, in a small vessel.
#include <csignal>
#include <filesystem>

#include "catch.hpp"
#include "examples/memo/class5/results.hpp"

using namespace class5;

namespace {

PackingSettings small_packing() {
  PackingSettings settings;
  settings.grading = "narrow";
  settings.vessel = {100e-3, 35e-3};
  return settings;
}
TriaxialSettings fast_test() {
  TriaxialSettings settings;
  settings.end = 0.08e-2;
  settings.cycle_rate = 0.05;
  return settings;
}

/// A new folder for the files of cases.
std::string case_folder(const std::string& name) {
  const auto folder = std::filesystem::temp_directory_path() / ("contactlaws_" + name);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder.string();
}

const Packing& packed() {
  static const Packing packing = [] {
    const std::string folder = case_folder("test_class5_packing");
    dem::CaseControl control(folder + "/packing.json", {});
    Packing result = pack(small_packing(), control);
    std::filesystem::remove_all(folder);
    return result;
  }();
  return packing;
}

}  // namespace

TEST_CASE("grains are drawn within their class, and each class has its share of the volume") {
  Random random(3);
  const double volume = 100.0 * 4.0 / 3.0 * pi * 11.5e-3 * 11.5e-3 * 11.5e-3;
  const std::vector<double> radii = draw_radii(broad, volume, random);
  double all = 0.0;
  for (const double r : radii) all += 4.0 / 3.0 * pi * r * r * r;
  for (const SizeClass& size : broad) {
    double filled = 0.0;
    for (const double r : radii)
      if (2.0 * r >= size.low && 2.0 * r < size.high) filled += 4.0 / 3.0 * pi * r * r * r;
    // Half a grain of the class and half of the one before.
    const double half_grain = 4.0 / 3.0 * pi * std::pow(size.high / 2.0, 3);
    CHECK(filled == Approx(size.share * volume).margin(half_grain));
  }
  CHECK(all == Approx(volume).margin(4.0 / 3.0 * pi * std::pow(3e-3, 3)));
}

TEST_CASE("walls pack grains to the material pressure; all are inside and the porosity is that of a random packing") {
  const Packing& packing = packed();
  CHECK(packing.grains.size() ==
        Approx(61).margin(1));  // 0.42 of the vessel, 2653 mm^3 a grain; the last one may be left out
  CHECK(packing.size.height < 100e-3);
  CHECK(packing.size.radius < 35e-3);
  CHECK(packing.porosity() > 0.40);  // 0.42 in the large vessel; this one is four grains wide
  CHECK(packing.porosity() < 0.50);
  Vessel<LinearLaw> vessel(linear_law(0.0), packing.size, packing.grains);
  vessel.look();
  for (const std::size_t wall : {vessel.bottom, vessel.top, vessel.side})
    CHECK(vessel.pressure(wall) == Approx(confinement).epsilon(1e-2));
  CHECK(dem::unbalanced_ratio(vessel.scene) < 8e-3);
}

TEST_CASE("a triaxial test holds the confinement, unloads to zero, and goes on after a stop with the same bits") {
  const std::string folder = case_folder("test_class5_stop");
  const TriaxialSettings settings = fast_test();
  dem::CaseControl whole(folder + "/whole.json", settings.to_json());
  const TriaxialState test = Triaxial<DryLaw>(hill_law(), packed(), settings).run(whole);

  CHECK(test.stress_mismatch < 1e-12);  // rounding of sums of some hundred terms
  CHECK(confinement_error(test) < 0.05);
  const Cycle cycle = cycle_of(test, 2);
  CHECK(cycle.resilient_modulus > 50e6);  // some 200 MPa
  CHECK(cycle.resilient_modulus < 1e9);
  CHECK(cycle.residual_strain > 0.0);
  CHECK(cycle.residual_strain < 1.0);
  CHECK(cycle.loop_energy > 0.0);

  const common::InterruptGuard guard;
  int stops = 0;
  TriaxialState resumed;
  while (true) {
    dem::CaseControl control(folder + "/stopped.json", settings.to_json());
    Triaxial<DryLaw> part(hill_law(), packed(), settings);
    try {
      control.stop_when([&part, stops] { return part.scene().steps > 2000 * (stops + 1); });
      resumed = part.run(control);
      break;
    } catch (const common::Stopped&) {
      ++stops;
    }
  }
  CHECK(stops > 2);
  CHECK(nlohmann::json(resumed) == nlohmann::json(test));
  std::filesystem::remove_all(folder);
}

TEST_CASE("wet grains are stronger") {
  const std::string folder = case_folder("test_class5_wet");
  TriaxialSettings settings = fast_test();
  settings.cycles = {0.05e-2};
  dem::CaseControl dry_control(folder + "/dry.json", {}), wet_control(folder + "/wet.json", {});
  const TriaxialState dry = Triaxial<DryLaw>(hill_law(), packed(), settings).run(dry_control);
  const TriaxialState wet = Triaxial<WetLaw>(wet_law(), packed(), settings).run(wet_control);
  CHECK(wet.samples.back().deviator > dry.samples.back().deviator);
  std::filesystem::remove_all(folder);
}

TEST_CASE("a file of other settings is refused by name") {
  const std::string folder = case_folder("test_class5_settings");
  dem::CaseControl(folder + "/case.json", {{"rate", 1.0}}).finish(1);
  CHECK(dem::CaseControl(folder + "/case.json", {{"rate", 1.0}}).has_result());
  CHECK_THROWS_WITH(dem::CaseControl(folder + "/case.json", {{"rate", 2.0}}),
                    ContainsSubstring("case.json") && ContainsSubstring("other settings"));
  std::filesystem::remove_all(folder);
}

TEST_CASE("a fault in one case stops the others and is reported; results so far are kept") {
  const std::string folder = case_folder("test_class5_fault");
  const std::vector<dem::Case> cases{
      {"good", 1.0, {}, [](dem::CaseControl&) { return nlohmann::json(1); }},
      {"bad", 1.0, {}, [](dem::CaseControl&) -> nlohmann::json { throw std::runtime_error("lost"); }}};
  CHECK_THROWS_WITH(dem::run_cases("test", folder, cases, 1), "lost");
  CHECK(dem::CaseControl(folder + "/good.json", {}).has_result());
  CHECK_FALSE(dem::CaseControl(folder + "/bad.json", {}).has_result());
  std::filesystem::remove_all(folder);
}

TEST_CASE("an unstable step and a lost grain stop the run with a message") {
  Vessel<DryLaw> vessel(hill_law(), packed().size, packed().grains);
  vessel.look();
  vessel.scene.time_step *= 6.0;  // 2 / 0.8 is the limit of one spring
  CHECK_THROWS_WITH(
      [&] {
        for (int step = 0; step < 5000; ++step) {
          vessel.step();
          if (vessel.looks()) {
            const double kept = vessel.scene.time_step;
            vessel.look();
            vessel.scene.time_step = kept;
          }
        }
      }(),
      ContainsSubstring("unstable") || ContainsSubstring("left the vessel") || ContainsSubstring("is lost"));

  std::vector<Grain> grains = packed().grains;
  grains[7].position.x() = 0.2;
  Vessel<DryLaw> leaking(hill_law(), packed().size, grains);
  CHECK_THROWS_WITH(leaking.look(), ContainsSubstring("grain 7 left the vessel"));
}

TEST_CASE("modulus, residual strain and loop of a cycle on a path of straight lines") {
  TriaxialState test;
  const auto line = [&test](int leg, double from, double to, double low, double high) {
    for (int i = leg == 2 ? 0 : 1; i <= 1000; ++i) {
      const double share = i / 1000.0;
      test.samples.push_back({leg, from + share * (to - from), low + share * (high - low), confinement, 0.0});
    }
  };
  // The turning point belongs to the second leg. Up to 100 kPa at 5e-4; down to zero at 1e-4; back up through 40 kPa at 3e-4 (20 kPa below the line down), and on.
  line(1, 0.0, 5e-4, 0.0, 100e3);
  line(2, 5e-4, 1e-4, 100e3, 0.0);
  line(3, 1e-4, 3e-4, 0.0, 40e3);
  line(3, 3e-4, 6e-4, 40e3, 130e3);
  const Cycle cycle = cycle_of(test, 1);
  CHECK(cycle.resilient_modulus == Approx(100e3 / 4e-4).epsilon(1e-9));
  CHECK(cycle.residual_strain == Approx(0.2).epsilon(1e-9));
  // Trapezoids: unloading 20 J/m^3; back 4 + (40 + 100) kPa / 2 x 2e-4 = 18 J/m^3. Such a loop creates energy: -2.
  CHECK(cycle.loop_energy == Approx(-2.0).epsilon(1e-6));
}
