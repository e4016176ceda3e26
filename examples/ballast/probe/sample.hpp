// SPDX-License-Identifier: MIT
// The sample that all laws share: clumps of ballast sizes in a cylinder. Here are its grains, and a scene of them in their vessel;
// packing.hpp packs them.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>

#include "common/random.hpp"
#include "dem/clump_checkpoint.hpp"
#include "dem/clump_measures.hpp"
#include "laws.hpp"
#include "membrane.hpp"
#include "shapes.hpp"
#include "vessel.hpp"

namespace probe {

using common::Random;

struct Grain {
  std::size_t shape;  ///< index in unit_clumps()
  double size;        ///< sieve size [m]
  Vec3 position = Vec3::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
};

struct Sample {
  double radius, height;  ///< of the vessel [m]
  std::vector<Grain> grains;
};

struct SampleSize {
  double diameter = 0.16, height = 0.24;  ///< of the vessel [m]
  double voids_ratio = 0.700;             ///< volume of voids over volume of grains [1]
  std::uint64_t seed = 1;
};

inline void to_json(nlohmann::json& json, const Grain& grain) {
  const Eigen::Quaterniond& q = grain.orientation;
  json = {grain.shape, grain.size, grain.position, nlohmann::json{q.w(), q.x(), q.y(), q.z()}};
}
inline void from_json(const nlohmann::json& json, Grain& grain) {
  json.at(0).get_to(grain.shape);
  json.at(1).get_to(grain.size);
  json.at(2).get_to(grain.position);
  const nlohmann::json& q = json.at(3);
  grain.orientation = Eigen::Quaterniond(q.at(0), q.at(1), q.at(2), q.at(3));
}
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Sample, radius, height, grains)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SampleSize, diameter, height, voids_ratio, seed)

/// Uniform over all orientations (Shoemake 1992).
inline Eigen::Quaterniond random_orientation(Random& random) {
  const double pi = contactlaws::pi<double>();
  const double u = random.uniform(0.0, 1.0), v = random.uniform(0.0, 2.0 * pi), w = random.uniform(0.0, 2.0 * pi);
  const double a = std::sqrt(1.0 - u), b = std::sqrt(u);
  return {b * std::cos(w), a * std::sin(v), a * std::cos(v), b * std::sin(w)};
}

/// Grains whose volume fills the vessel at the voids ratio. Each new one is of the sieve class that lacks most; the shapes take
/// turns. At the end all sizes are scaled by a little, so that the volume is exact.
inline std::vector<Grain> draw_grains(const SampleSize& size, const std::vector<dem::ClumpShape>& shapes,
                                      Random& draw) {
  const double wanted =
      contactlaws::pi<double>() / 4.0 * size.diameter * size.diameter * size.height / (1.0 + size.voids_ratio);
  std::array<double, ballast_sizes.size()> lacking{};
  for (std::size_t k = 0; k < lacking.size(); ++k) lacking[k] = ballast_sizes[k].share * wanted;
  std::vector<Grain> grains;
  double placed = 0.0;
  while (placed < wanted) {
    const auto most = static_cast<std::size_t>(std::max_element(lacking.begin(), lacking.end()) - lacking.begin());
    const double sieve = draw.uniform(ballast_sizes[most].low, ballast_sizes[most].high);
    const std::size_t shape = grains.size() % shapes.size();
    const double volume = shapes[shape].volume * sieve * sieve * sieve;
    lacking[most] -= volume;
    placed += volume;
    grains.push_back({shape, sieve});
  }
  for (Grain& grain : grains) grain.size *= std::cbrt(wanted / placed);
  return grains;
}

/// Random places, apart from each other, in a vessel of this radius and height [m]; the largest first.
inline void scatter(std::vector<Grain>& grains, const std::vector<dem::ClumpShape>& shapes, double radius,
                    double height, Random& draw) {
  std::sort(grains.begin(), grains.end(), [](const Grain& a, const Grain& b) { return a.size > b.size; });
  const auto reach = [&shapes](const Grain& grain) { return shapes[grain.shape].reach * grain.size; };
  for (std::size_t i = 0; i < grains.size(); ++i) {
    Grain& grain = grains[i];
    const double own = reach(grain);
    for (int attempt = 0;; ++attempt) {
      if (attempt == 100000) throw std::runtime_error("grains do not fit apart into the vessel before it shrinks");
      const double x = draw.uniform(own - radius, radius - own);
      const double y = draw.uniform(own - radius, radius - own);
      const double z = draw.uniform(own, height - own);
      if (std::hypot(x, y) > radius - own) continue;
      grain.position = {x, y, z};
      if (std::all_of(grains.begin(), grains.begin() + static_cast<std::ptrdiff_t>(i), [&](const Grain& other) {
            return (other.position - grain.position).norm() > own + reach(other);
          }))
        break;
    }
    grain.orientation = random_orientation(draw);
  }
}

constexpr double resting_skin = 0.3e-3;  ///< gaps up to which neighbours are listed, where grains come to rest [m]

/// A scene of the sample's grains in their vessel.
template <class Law>
struct Specimen {
  dem::Simulation<Law, Boundary> scene;
  dem::Clumps clumps;
  Vessel vessel;
  std::optional<Membrane> membrane;

  Specimen(const Law& law, const Boundary& boundary, const std::vector<dem::ClumpShape>& shapes, const Sample& sample)
      : scene(law, boundary) {
    scene.local_damping = 0.7;
    scene.log = nullptr;
    vessel.add_to(scene, sample.radius, sample.height);
    for (const Grain& grain : sample.grains)
      clumps.add(scene, shapes[grain.shape].scaled(grain.size), granite, grain.position, grain.orientation);
    set_skin(resting_skin);
  }

  /// Neighbours are listed up to gaps of `gap` [m]: few where grains hardly move.
  void set_skin(double gap) {
    scene.skin = gap / *std::min_element(scene.balls.radius.begin(), scene.balls.radius.end());
  }
  /// Puts a membrane in the place of the cylinder.
  void add_membrane(const MembraneSettings& settings) {
    dem::Wall& cylinder = scene.walls[Vessel::side];
    membrane.emplace(settings, cylinder.radius, Vessel::height(scene));
    membrane->surround(scene);
    vessel.membrane_radius = cylinder.radius;
    cylinder.radius += 1.0;  // out of reach
  }
  void step() {
    vessel.push(scene);
    clumps.step(scene);
    if (!membrane) return;
    membrane->step(scene, clumps, vessel.pressure, scene.walls[Vessel::bottom], scene.walls[Vessel::top]);
    if (scene.steps % 100 == 0) vessel.membrane_radius = membrane->mean_radius();
  }

  /// What changes of it, apart from the scene.
  friend void to_json(nlohmann::json& json, const Specimen& specimen) {
    const Vessel& v = specimen.vessel;
    json = {{"pressure", v.pressure},
            {"moves", {v.top_moves, v.top_tilts, v.side_moves}},
            {"membrane_radius", v.membrane_radius},
            {"clumps", dem::clumps_to_json(specimen.clumps)}};
    if (specimen.membrane) json["membrane"] = dem::scene_to_json(specimen.membrane->scene);
  }
  /// After the scene was restored.
  friend void from_json(const nlohmann::json& json, Specimen& specimen) {
    Vessel& v = specimen.vessel;
    json.at("pressure").get_to(v.pressure);
    json.at("moves").at(0).get_to(v.top_moves);
    json.at("moves").at(1).get_to(v.top_tilts);
    json.at("moves").at(2).get_to(v.side_moves);
    json.at("membrane_radius").get_to(v.membrane_radius);
    dem::clumps_from_json(json.at("clumps"), specimen.clumps, specimen.scene);
    if (!specimen.membrane) return;
    dem::scene_from_json(json.at("membrane"), specimen.membrane->scene);
    specimen.membrane->resume();
  }

  void take_places(Sample& sample) const {
    sample.radius = vessel.radius(scene);
    sample.height = Vessel::height(scene);
    for (std::size_t i = 0; i < sample.grains.size(); ++i) {
      sample.grains[i].position = clumps.all[i].position;
      sample.grains[i].orientation = clumps.all[i].orientation;
    }
  }
};

}  // namespace probe
