// SPDX-License-Identifier: MIT
// Three shapes of grains of our own making, and the sizes of railway ballast.
//
// A shape is a polyhedron, filled with spheres. Its faces are tangent planes of an ellipsoid of semi-axes L : I : S, along
// directions of a spiral; some are moved inward, so that no two faces or corners are alike. Spheres that lie inside are chosen
// one after the other, each the one that fills most of the volume that is still empty; the smallest radius bounds how sharp
// corners become. The three, once filled:
//
//              intermediate/longest   shortest/intermediate
//   blocky     .88                    .80
//   elongated  .68                    .80
//   flat       .78                    .69
//
// Sizes: the middle of the limits of EN 13450 for 31.5 to 50 mm (Tolomeo & McDowell 2022, Fig. 3), by volume.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "contactlaws/core/scalar.hpp"
#include "dem/clump_shape.hpp"

namespace probe {

using dem::Vec3;

struct GrainShape {
  const char* name;
  Vec3 axes;     ///< L : I : S
  double phase;  ///< turns the spiral of faces [rad]
};
inline const std::array<GrainShape, 3> grain_shapes{
    {{"blocky", {1.0, 0.80, 0.58}, 0.3}, {"elongated", {1.0, 0.55, 0.42}, 1.1}, {"flat", {1.0, 0.80, 0.32}, 2.3}}};

/// A face of the polyhedron: points x with normal.x <= distance are inside.
struct Face {
  Vec3 normal;
  double distance;
};

inline std::vector<Face> faces_of(const GrainShape& shape) {
  constexpr int count = 15;
  const double golden_angle = contactlaws::pi<double>() * (3.0 - std::sqrt(5.0));
  std::vector<Face> faces;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, across = std::sqrt(1.0 - z * z),
                 turn = golden_angle * i + shape.phase;
    const Vec3 normal(across * std::cos(turn), across * std::sin(turn), z);
    const double cut = 0.86 + 0.14 * std::abs(std::sin(2.7 * i + shape.phase));
    faces.push_back({normal, cut * normal.cwiseProduct(shape.axes).norm()});
  }
  return faces;
}

/// Fills the polyhedron with `count` spheres of at least `smallest` (L/2 = 1).
inline std::vector<dem::Pebble> filled(const std::vector<Face>& faces, std::size_t count, double smallest) {
  const auto depth = [&faces](const Vec3& x) {  // radius of the largest sphere about x that lies inside
    double least = 2.0;
    for (const Face& face : faces) least = std::min(least, face.distance - face.normal.dot(x));
    return least;
  };
  constexpr int across = 26;
  std::vector<Vec3> empty;
  std::vector<dem::Pebble> candidates;
  for (int i = 0; i < across * across * across; ++i) {
    const Vec3 cell(i % across, i / across % across, i / across / across);
    const Vec3 place = (cell + Vec3::Constant(0.5)) * (2.6 / across) - Vec3::Constant(1.3);
    const double radius = depth(place);
    if (radius > 0.0) empty.push_back(place);
    if (radius >= smallest) candidates.push_back({place, radius});
  }
  const auto fills = [](const dem::Pebble& p, const Vec3& x) {
    return (x - p.centre).squaredNorm() < p.radius * p.radius;
  };
  std::vector<dem::Pebble> pebbles;
  while (pebbles.size() < count) {
    std::size_t best = 0;
    std::ptrdiff_t most = -1;
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      const auto filling =
          std::count_if(empty.begin(), empty.end(), [&](const Vec3& x) { return fills(candidates[c], x); });
      if (filling > most) best = c, most = filling;
    }
    const dem::Pebble chosen = candidates[best];
    pebbles.push_back(chosen);
    empty.erase(std::remove_if(empty.begin(), empty.end(), [&](const Vec3& x) { return fills(chosen, x); }),
                empty.end());
  }
  return pebbles;
}

/// Extent of a clump along its principal axes, longest first [m].
inline Vec3 extents(const dem::ClumpShape& shape) {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  for (const dem::Pebble& p : shape.pebbles) {
    low = low.cwiseMin(p.centre - Vec3::Constant(p.radius));
    high = high.cwiseMax(p.centre + Vec3::Constant(p.radius));
  }
  return high - low;
}

/// The three clumps, of a sieve size of 1 m: the sieve size is taken as the intermediate extent.
inline std::vector<dem::ClumpShape> unit_clumps() {
  constexpr std::size_t pebbles = 22;
  constexpr double smallest = 0.20;  // of L/2: corners of a grain of 50 mm have radii of 6 mm
  std::vector<dem::ClumpShape> clumps;
  for (const GrainShape& shape : grain_shapes) {
    const dem::ClumpShape clump = dem::clump_shape(filled(faces_of(shape), pebbles, smallest));
    clumps.push_back(clump.scaled(1.0 / extents(clump).y()));
  }
  return clumps;
}

/// A sieve class: sizes [m] and share of the volume.
struct SieveClass {
  double low, high, share;
};
inline const std::array<SieveClass, 4> ballast_sizes{
    {{22.4e-3, 31.5e-3, 0.13}, {31.5e-3, 40e-3, 0.345}, {40e-3, 50e-3, 0.37}, {50e-3, 63e-3, 0.155}}};

}  // namespace probe
