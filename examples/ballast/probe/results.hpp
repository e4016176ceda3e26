// SPDX-License-Identifier: MIT
// What the tests tell: moduli, ratios between laws on one sample, and the bands in which they must lie.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "common/report.hpp"
#include "common/table.hpp"
#include "test_state.hpp"

namespace probe {

/// Young's modulus [Pa]: slope of the axial stress over the strain, fitted to the points between two strains of the phase.
/// NaN where there are fewer than two.
inline double modulus(const Curve& curve, double low, double high) {
  double count = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  const double x0 = curve.empty() ? 0.0 : curve.front().strain, y0 = curve.empty() ? 0.0 : curve.front().axial;
  for (const Point& p : curve) {
    if (p.phase_strain < low || p.phase_strain > high) continue;
    const double dx = p.strain - x0, dy = p.axial - y0;
    count += 1.0;
    x += dx;
    y += dy;
    xx += dx * dx;
    xy += dx * dy;
  }
  return (xy - x * y / count) / (xx - x * x / count);
}
/// E_0, at a strain of 1e-7 (the paper's 1e-5 %); the modulus at 1e-4 (1e-2 %); that of the first part of unloading.
inline double initial_modulus(const Curve& load) { return modulus(load, 5e-8, 2e-7); }
inline double degraded_modulus(const Curve& load) { return modulus(load, 7e-5, 1.42e-4); }
inline double unloading_modulus(const Curve& unload) { return modulus(unload, 1e-7, 1e-5); }

/// The point of a curve nearest to a strain of its phase, on a logarithmic scale.
inline const Point& at_strain(const Curve& curve, double strain) {
  const auto distance = [strain](const Point& p) {
    return p.phase_strain > 0.0 ? std::abs(std::log(p.phase_strain / strain)) : 1e9;
  };
  return *std::min_element(curve.begin(), curve.end(),
                           [&](const Point& a, const Point& b) { return distance(a) < distance(b); });
}

/// Strain from which on the tangent modulus is below `share` of E_0 [1], for a quarter of a decade at least: a grain that slips or
/// lands moves the modulus for a few points only. NaN where there is none.
inline double onset(const Curve& load, double share = 0.95) {
  constexpr std::size_t points = 5;  // of 20 a decade
  const double limit = share * initial_modulus(load);
  std::size_t below = 0;
  for (std::size_t i = 3; i < load.size(); ++i) {
    if (load[i].phase_strain < 1e-7) continue;  // before it, noise
    const double tangent = (load[i].axial - load[i - 3].axial) / (load[i].strain - load[i - 3].strain);
    below = tangent < limit ? below + 1 : 0;
    if (below == points) return load[i + 1 - points].phase_strain;
  }
  return std::nan("");
}

/// Noise of the tangent modulus: rms deviation from E_0 of the slopes between successive points of the first half decade of
/// strain, over E_0 [1]. Later the sample has come to rest.
inline double noise(const Curve& load) {
  const double mean = initial_modulus(load);
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 1; i < load.size(); ++i) {
    if (load[i].phase_strain < 1e-9 || load[i].phase_strain > 3.2e-9) continue;
    const double slope = (load[i].axial - load[i - 1].axial) / (load[i].strain - load[i - 1].strain);
    sum += (slope / mean - 1.0) * (slope / mean - 1.0);
    count += 1.0;
  }
  return std::sqrt(sum / count);
}

/// Contacts on one branch, over all, as a mean over strains low .. high.
template <class Value>
double mean_over(const Curve& curve, double low, double high, const Value& value) {
  double sum = 0.0, count = 0.0;
  for (const Point& p : curve)
    if (p.phase_strain >= low && p.phase_strain <= high) sum += value(p), count += 1.0;
  return sum / count;
}
inline double virgin_share(const Point& p) { return p.virgin / p.contacts; }

using Tests = std::map<std::string, TestState>;  ///< by the name of the case

/// The least and the largest value that pass.
struct Band {
  double low, high;
};

/// All numbers of a run. `full`: of the paper's size. A sample of 120 grains scatters: where its bands are its own, they are the
/// mean of twelve samples, give or take four standard deviations (README.md beside this file has them).
inline common::BandedNumbers banded_numbers(const Tests& tests, const std::vector<std::string>& by_confinement,
                                            bool full) {
  const TestState &hertz = tests.at("hertz"), &elastic = tests.at("elastic"), &plastic = tests.at("elasto_plastic");
  common::BandedNumbers numbers;
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr Band not_judged{-inf, inf};
  const auto add = [&](const char* id, const char* unit, std::optional<double> published, Band in_full, Band in_small,
                       double computed) {
    const Band& band = full ? in_full : in_small;
    numbers.push_back({std::string("probe.") + id, unit, published, band.low, band.high, computed});
  };
  const auto add_everywhere = [&add](const char* id, const char* unit, std::optional<double> published, Band band,
                                     double computed) { add(id, unit, published, band, band, computed); };
  const double e0_hertz = initial_modulus(hertz.load), e0_elastic = initial_modulus(elastic.load),
               e0_plastic = initial_modulus(plastic.load);
  const double e4_elastic = degraded_modulus(elastic.load), e4_plastic = degraded_modulus(plastic.load);
  add("E0_elasto_plastic_over_elastic", "1", 1.42, {1.25, 1.41}, {1.27, 1.44}, e0_plastic / e0_elastic);
  add("E0_hertz_over_elastic", "1", {}, {1.17, 1.33}, {1.17, 1.43}, e0_hertz / e0_elastic);
  add_everywhere("E_at_0.01_percent_elasto_plastic_over_elastic", "1", {}, {0.98, 1.08}, e4_plastic / e4_elastic);
  add("elastic_drop_to_0.01_percent", "1", {}, {-inf, 0.03}, {-inf, 0.065}, 1.0 - e4_elastic / e0_elastic);
  add("elasto_plastic_E_at_0.01_percent_over_E0", "1", {}, {0.71, 0.83}, {0.69, 0.82}, e4_plastic / e0_plastic);
  add_everywhere("virgin_share_at_start", "1", {}, {-inf, 0.02}, mean_over(plastic.load, 1e-9, 1e-8, virgin_share));
  add("virgin_share_at_0.01_percent", "1", {}, {0.5, 0.7}, {0.58, 0.84},
      mean_over(plastic.load, 7e-5, 1.42e-4, virgin_share));
  add("residual_strain_elasto_plastic_over_elastic", "1", {}, {1.5, inf}, {1.0, inf},
      plastic.unload.back().strain / elastic.unload.back().strain);
  add("unloading_modulus_elasto_plastic_over_elastic", "1", {}, {1.22, 1.38}, {1.19, 1.34},
      unloading_modulus(plastic.unload) / unloading_modulus(elastic.unload));
  add_everywhere("coordination_rough_minus_hertz", "1", 0.3, {0.3, inf},
                 elastic.load.front().coordination - hertz.load.front().coordination);
  add("force_over_largest_of_reloading_contacts", "1", 0.89, {0.90, 0.98}, {0.94, 1.0},
      mean_over(plastic.load, 1e-9, 1e-8, [](const Point& p) { return p.force_over_largest; }));
  add("direction_of_virgin_contacts", "degrees", {}, {75.0, 90.0}, {71.0, 90.0},
      mean_over(plastic.load, 1e-6, 1e-4, [](const Point& p) { return p.virgin_direction; }));
  add_everywhere("direction_of_unloading_contacts", "degrees", {}, {0.0, 10.0},
                 mean_over(plastic.load, 1e-8, 1e-4, [](const Point& p) { return p.unloading_direction; }));
  double least_ratio = inf;  // of one onset to that of the next slower confinement
  for (std::size_t i = 1; i < by_confinement.size(); ++i) {
    const double ratio = onset(tests.at(by_confinement[i - 1]).load) / onset(tests.at(by_confinement[i]).load);
    if (std::isnan(ratio) || ratio < least_ratio) least_ratio = ratio;  // an onset that is missing fails
  }
  add_everywhere("onset_of_fastest_over_slowest_confinement", "1", {}, {1.0, inf},
                 onset(tests.at(by_confinement.front()).load) / onset(tests.at(by_confinement.back()).load));
  add("onset_faster_over_slower_confinement", "1", {}, {1.0, inf}, not_judged, least_ratio);
  double unbalanced = 0.0, identity = 0.0;
  for (const auto& [name, test] : tests) {
    unbalanced = std::max(unbalanced, test.rest_unbalanced);
    identity = std::max(identity, test.identity);
  }
  add_everywhere("unbalanced_force_before_probe", "1", {}, {-inf, 1e-7}, unbalanced);
  add_everywhere("stress_identity", "1", {}, {-inf, 1e-6}, identity);
  // Absolute moduli follow the packing of a small sample, and are judged in the paper's size alone.
  add("E0_elasto_plastic", "Pa", 128e6, {0.8 * 128e6, 1.2 * 128e6}, not_judged, e0_plastic);
  add("E0_elastic", "Pa", 90e6, {0.8 * 90e6, 1.2 * 90e6}, not_judged, e0_elastic);
  add_everywhere("E0_hertz", "Pa", {}, not_judged, e0_hertz);
  add_everywhere("coordination_elastic", "1", 5.6, not_judged, elastic.load.front().coordination);
  add_everywhere("coordination_hertz", "1", 5.3, not_judged, hertz.load.front().coordination);
  add_everywhere("fabric_elastic", "1", 0.228, not_judged, elastic.load.front().fabric);
  add_everywhere("fabric_hertz", "1", 0.226, not_judged, hertz.load.front().fabric);
  add_everywhere("voids_ratio_confined", "1", {}, not_judged, elastic.voids_ratio);
  // The transition force is not reached.
  add_everywhere("largest_contact_force", "N", {}, {-inf, 1776.244}, plastic.largest_force);
  return numbers;
}

inline common::Table table_of(const Curve& curve) {
  common::Table table{"phase_strain",
                      "strain",
                      "axial_Pa",
                      "radial_Pa",
                      "branch_axial_Pa",
                      "branch_radial_Pa",
                      "modulus_Pa",
                      "branch_modulus_Pa",
                      "coordination",
                      "touching_grains",
                      "fabric",
                      "contacts",
                      "virgin",
                      "unloading",
                      "reloading",
                      "virgin_direction",
                      "unloading_direction",
                      "reloading_direction",
                      "force_over_largest",
                      "unbalanced"};
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const Point &p = curve[i], &before = curve[i - 1];
    const double moved = p.strain - before.strain;
    if (std::abs(moved) < 0.02 * p.phase_strain) continue;  // the end of a phase, close to its last point: noise
    table.add({p.phase_strain,
               p.strain,
               p.axial,
               p.radial,
               p.branch_axial,
               p.branch_radial,
               (p.axial - before.axial) / moved,
               (p.branch_axial - before.branch_axial) / moved,
               p.coordination,
               p.touching_grains,
               p.fabric,
               p.contacts,
               p.virgin,
               p.unloading,
               p.reloading,
               p.virgin_direction,
               p.unloading_direction,
               p.reloading_direction,
               p.force_over_largest,
               p.unbalanced});
  }
  return table;
}

}  // namespace probe
