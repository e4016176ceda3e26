// SPDX-License-Identifier: MIT
// The shape of a clump: overlapping spheres (pebbles), and volume, centre and moments of inertia of their union.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>

#include "balls.hpp"

namespace dem {

/// A sphere of a clump, in the frame of the clump.
struct Pebble {
  Vec3 centre;    ///< [m]
  double radius;  ///< [m]
};

/// Centres are about the centre of mass of the union, along its principal axes.
struct ClumpShape {
  std::vector<Pebble> pebbles;
  double volume;  ///< of the union [m^3]
  Vec3 inertia;   ///< principal moments of inertia at a density of 1, ascending [m^5]
  double reach;   ///< largest distance of the surface from the centre of mass [m]

  /// The same shape, `factor` times as large.
  ClumpShape scaled(double factor) const {
    ClumpShape shape = *this;
    for (Pebble& pebble : shape.pebbles) pebble = {pebble.centre * factor, pebble.radius * factor};
    shape.volume *= factor * factor * factor;
    shape.inertia *= std::pow(factor, 5);
    shape.reach *= factor;
    return shape;
  }
};

namespace detail {

/// Volume, first and second moments of the union, from cubes of edge `cell` [m] whose centre it covers.
struct Moments {
  double volume = 0.0;
  Vec3 first = Vec3::Zero();                         ///< [m^4]
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  ///< [m^5]
};
inline Moments moments_of_union(const std::vector<Pebble>& pebbles, int cells) {
  Vec3 low = pebbles[0].centre, high = low;
  for (const Pebble& p : pebbles) {
    low = low.cwiseMin(p.centre - Vec3::Constant(p.radius));
    high = high.cwiseMax(p.centre + Vec3::Constant(p.radius));
  }
  const double cell = (high - low).maxCoeff() / cells;
  const auto covered = [&pebbles](const Vec3& x) {
    return std::any_of(pebbles.begin(), pebbles.end(),
                       [&x](const Pebble& p) { return (x - p.centre).squaredNorm() < p.radius * p.radius; });
  };
  const double cube = cell * cell * cell;
  Moments moments;
  for (double z = low.z() + cell / 2.0; z < high.z(); z += cell)
    for (double y = low.y() + cell / 2.0; y < high.y(); y += cell)
      for (double x = low.x() + cell / 2.0; x < high.x(); x += cell) {
        const Vec3 place(x, y, z);
        if (!covered(place)) continue;
        moments.volume += cube;
        moments.first += place * cube;
        moments.second += place * place.transpose() * cube;
      }
  moments.second +=
      Eigen::Matrix3d::Identity() * (moments.volume * cell * cell / 12.0);  // of each cube about its centre
  return moments;
}

}  // namespace detail

/// The clump of these pebbles, given in any frame. The union is counted in cubes, `cells` along its longest side: 100 give
/// volume and inertia within 0.2 % (tests/dem/test_clumps.cpp). One pebble gives a sphere, exactly.
/// @throws std::invalid_argument if there is no pebble, or a radius is not positive
inline ClumpShape clump_shape(std::vector<Pebble> pebbles, int cells = 100) {
  using contactlaws::Range;
  contactlaws::require_in({1.0, 1e6, true, true}, static_cast<double>(pebbles.size()), "clump_shape", "pebbles", "1");
  for (const Pebble& p : pebbles) contactlaws::require_in(Range::positive(), p.radius, "clump_shape", "radius", "m");
  if (pebbles.size() == 1) {
    const double radius = pebbles[0].radius, volume = contactlaws::sphere_mass(radius, 1.0);
    return {{{Vec3::Zero(), radius}}, volume, Vec3::Constant(0.4 * volume * radius * radius), radius};
  }
  const detail::Moments moments = detail::moments_of_union(pebbles, cells);
  const Vec3 centre = moments.first / moments.volume;
  const Eigen::Matrix3d central = moments.second - moments.volume * centre * centre.transpose();
  const Eigen::Matrix3d inertia = central.trace() * Eigen::Matrix3d::Identity() - central;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(inertia);
  Eigen::Matrix3d axes = principal.eigenvectors();
  if (axes.determinant() < 0.0) axes.col(2) = -axes.col(2);  // a rotation, not a reflection
  double reach = 0.0;
  for (Pebble& p : pebbles) {
    p.centre = axes.transpose() * (p.centre - centre);
    reach = std::max(reach, p.centre.norm() + p.radius);
  }
  return {std::move(pebbles), moments.volume, principal.eigenvalues(), reach};
}

}  // namespace dem
