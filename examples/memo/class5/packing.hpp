// SPDX-License-Identifier: MIT
// Packing by boundary contraction (Potyondy 2019, Table 7): grains at random places in the vessel push each other apart, without
// friction; then the walls move in until each of them carries the material pressure.
#pragma once

#include "dem/cases.hpp"
#include "vessel.hpp"

namespace class5 {

struct PackingSettings {
  std::string grading;               ///< "narrow" or "broad"
  int seed = 10000;                  ///< Table 7
  Size vessel{240e-3, 85e-3};        ///< before the walls move [m]
  double cloud_porosity = 0.58;      ///< of that vessel [1]
  double pressure_tolerance = 1e-2;  ///< [1]
  double unbalanced = 8e-3;          ///< equilibrium-ratio limit [1]
  std::int64_t most_steps = 2000000;

  nlohmann::json to_json() const {
    return {{"grading", grading},
            {"seed", seed},
            {"height", vessel.height},
            {"radius", vessel.radius},
            {"porosity", cloud_porosity},
            {"unbalanced", unbalanced},
            {"pressure_tolerance", pressure_tolerance}};
  }
};

/// Grains at random places inside the vessel. They overlap.
inline std::vector<Grain> cloud(const PackingSettings& settings) {
  Random random(static_cast<std::uint64_t>(settings.seed));
  const Size& size = settings.vessel;
  const Grading& grading = settings.grading == "narrow" ? narrow : broad;
  std::vector<Grain> grains;
  for (const double radius : draw_radii(grading, (1.0 - settings.cloud_porosity) * size.volume(), random)) {
    const double distance = (size.radius - radius) * std::sqrt(random.uniform(0.0, 1.0)),
                 angle = random.uniform(0.0, 2.0 * pi);
    const double half = size.height / 2.0 - radius;
    grains.push_back(
        {radius, Vec3(distance * std::cos(angle), distance * std::sin(angle), random.uniform(-half, half))});
  }
  dem::sort_in_space(grains);
  return grains;
}

/// @throws std::runtime_error if the pressure is not reached in the steps allowed; common::Stopped
inline Packing pack(const PackingSettings& settings, dem::CaseControl& control) {
  constexpr std::int64_t spread_steps = 2000;  // apart, and at rest
  constexpr std::int64_t calm_every = 10;
  Vessel<LinearLaw> vessel(linear_law(0.0), settings.vessel, cloud(settings));
  auto& scene = vessel.scene;
  nlohmann::json no_state;
  control.resume(scene, no_state);

  const auto packed = [&] {
    for (const std::size_t wall : {vessel.bottom, vessel.top, vessel.side})
      if (std::abs(vessel.pressure(wall) / confinement - 1.0) > settings.pressure_tolerance) return false;
    return dem::unbalanced_ratio(scene) < settings.unbalanced;
  };
  while (true) {
    if (vessel.looks()) {
      // How far it is: the vessel shrinks by a tenth, most of it soon, and comes to rest slowly.
      const double moved = (settings.vessel.radius - vessel.size().radius) / settings.vessel.radius;
      control.between_steps(scene, no_state, std::min(0.95, 8.0 * moved));
      vessel.look();
      if (scene.steps > spread_steps && packed()) break;
      if (scene.steps >= settings.most_steps)
        throw std::runtime_error("the packing does not reach " + std::to_string(confinement) + " Pa in " +
                                 std::to_string(settings.most_steps) + " steps. Try another seed.");
    }
    if (scene.steps < spread_steps) {
      if (scene.steps % calm_every == 0) vessel.calm();
    } else {
      for (const std::size_t wall : {vessel.bottom, vessel.top, vessel.side}) vessel.hold_pressure(wall);
    }
    vessel.step();
  }
  return vessel.packing();
}

}  // namespace class5
