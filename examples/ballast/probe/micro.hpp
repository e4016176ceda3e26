// SPDX-License-Identifier: MIT
// What the contacts of a specimen tell at one moment: stress from branch vectors, coordination, fabric, and for a law with
// loading history how many contacts are on which branch, and how they are directed (Tolomeo & McDowell 2022, section 4).
#pragma once

#include <array>
#include <cmath>
#include <set>

#include <Eigen/Eigenvalues>

#include "dem/clump_measures.hpp"
#include "sample.hpp"

namespace probe {

/// Contacts on one branch.
struct Branch {
  std::size_t count = 0;
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();  ///< sum of n n^T

  void add(const Vec3& normal) {
    ++count;
    normals += normal * normal.transpose();
  }
  /// Angle of the principal direction to the horizontal [degrees].
  double direction() const {
    if (count == 0) return 0.0;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(normals);
    return std::asin(std::min(1.0, std::abs(principal.eigenvectors()(2, 2)))) * 180.0 / contactlaws::pi<double>();
  }
};

struct Micro {
  Eigen::Matrix3d stress = Eigen::Matrix3d::Zero();      ///< from contacts between grains [Pa], compression > 0
  Eigen::Matrix3d outer_part = Eigen::Matrix3d::Zero();  ///< what contacts with walls and membrane add to it [Pa]
  Eigen::Matrix3d outside =
      Eigen::Matrix3d::Zero();               ///< from the forces of walls, membrane and weight, times their places [Pa]
  Branch all, virgin, unloading, reloading;  ///< contacts between grains that carry a force
  double coordination = 0.0;                 ///< such contacts per grain, each counted for both grains [1]
  double touching_grains = 0.0;              ///< pairs of grains that touch, likewise [1]
  double fabric = 0.0;                       ///< norm of the fabric tensor (Eq. 8) [1]
  double force_over_largest = 0.0;           ///< mean F/F_max of reloading contacts [1]
  double mean_force = 0.0;                   ///< mean normal force [N]
  double largest_force = 0.0;                ///< [N]

  /// At rest the stress of all contacts is that from outside: what is missing, over it [1].
  double missing() const { return std::abs((stress + outer_part - outside)(2, 2) / outside(2, 2)); }
  double share(const Branch& branch) const {
    return all.count > 0 ? static_cast<double>(branch.count) / static_cast<double>(all.count) : 0.0;
  }
};

namespace detail {

/// The branch of a contact and its F/F_max, for laws that have branches.
template <class Law, class Contact>
void add_history(Micro& micro, double& ratios, const Law& law, const contactlaws::PairProperties<double>& pair,
                 const Contact& contact) {
  if constexpr (std::is_same_v<Law, ElastoPlastic>) {
    const auto& state = contact.response.state;
    const double overlap = contact.geometry.overlap, separating = contact.motion.velocity.dot(contact.geometry.normal);
    switch (law.normal.loading(state, overlap, separating)) {
      case contactlaws::Loading::virgin:
        micro.virgin.add(contact.geometry.normal);
        break;
      case contactlaws::Loading::unloading:
        micro.unloading.add(contact.geometry.normal);
        break;
      case contactlaws::Loading::reloading: {
        micro.reloading.add(contact.geometry.normal);
        const double depth = law.normal.indentation(state.largest_overlap).depth;
        ratios += contact.response.normal_force / contactlaws::hertz_response(pair, depth).force;
        break;
      }
      case contactlaws::Loading::open:
        break;
    }
  }
}

}  // namespace detail

/// `solid_volume`: of all grains [m^3].
template <class Law>
Micro observe(const Specimen<Law>& specimen, double solid_volume) {
  const auto& scene = specimen.scene;
  const dem::Clumps& clumps = specimen.clumps;
  const double volume = specimen.vessel.volume(scene);
  Micro micro;
  double ratios = 0.0;
  std::set<std::pair<int, int>> touching;
  for (std::size_t c = 0; c < scene.ball_contacts.size(); ++c) {
    const auto contact = scene.ball_contact(c);
    const double force = contact.response.normal_force;
    if (!(force > 0.0)) continue;
    const int one = scene.balls.group[scene.ball_contacts.first(c)],
              two = scene.balls.group[scene.ball_contacts.second(c)];
    const Vec3 branch =
        clumps.all[static_cast<std::size_t>(two)].position - clumps.all[static_cast<std::size_t>(one)].position;
    micro.stress += contact.response.force * branch.transpose() / volume;
    micro.all.add(contact.geometry.normal);
    micro.mean_force += force;
    micro.largest_force = std::max(micro.largest_force, force);
    touching.insert({std::min(one, two), std::max(one, two)});
    detail::add_history(micro, ratios, scene.ball_law, scene.ball_contacts.pair(c), contact);
  }
  const auto add_outside = [&](std::size_t ball, const Vec3& place, const Vec3& force) {
    const Vec3 branch = clumps.all[static_cast<std::size_t>(scene.balls.group[ball])].position - place;
    micro.outer_part += force * branch.transpose() / volume;
    micro.outside -= force * place.transpose() / volume;
  };
  for (std::size_t c = 0; c < scene.wall_contacts.size(); ++c) {
    const std::size_t ball = scene.wall_contacts.second(c);
    const auto contact = scene.wall_contact(c);
    add_outside(ball, scene.balls.position[ball] + contact.geometry.arm2, contact.response.force);
  }
  if (specimen.membrane)
    specimen.membrane->for_each_push(
        [&](std::size_t ball, const Vec3& force) { add_outside(ball, scene.balls.position[ball], force); });
  for (const dem::Clump& clump : clumps.all)
    micro.outside -= clump.mass * scene.gravity * clump.position.transpose() / volume;
  const double contacts = static_cast<double>(std::max<std::size_t>(1, micro.all.count)),
               grains = static_cast<double>(clumps.size());
  micro.coordination = 2.0 * static_cast<double>(micro.all.count) / grains;
  micro.touching_grains = 2.0 * static_cast<double>(touching.size()) / grains;
  micro.mean_force /= contacts;
  const Eigen::Matrix3d fabric =
      5.0 / (2.0 * volume / solid_volume) * (3.0 * micro.all.normals / contacts - Eigen::Matrix3d::Identity());
  micro.fabric = fabric.norm();  // 1 + e = volume / solid volume
  if (micro.reloading.count > 0) micro.force_over_largest = ratios / static_cast<double>(micro.reloading.count);
  return micro;
}

}  // namespace probe
