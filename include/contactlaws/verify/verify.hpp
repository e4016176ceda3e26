// SPDX-License-Identifier: MIT
// Checks of any force update. Adapt it (force_update.hpp lists what more it may offer), state its usual sizes and what it
// claims (options.hpp), and read the report (report.hpp):
//
//     struct MyLaw {
//       struct State { double shear[3] = {0, 0, 0}; };
//       verify::Interaction operator()(const verify::Bodies& pair, double dt, State& state) const {
//         ...                                                        // pair.one.position, .velocity, .spin, .radius, .mass
//         return {force_on_2, force_on_1, torque_on_1, torque_on_2}; // only the first is required
//       }
//     };
//     verify::Options options;
//     options.radius1 = options.radius2 = 5e-3;  options.mass1 = options.mass2 = 1.4e-3;  options.overlap = 5e-6;
//     options.claims.friction = 0.4;  options.claims.no_tension = true;
//     const verify::Report report = verify::check_all(MyLaw{}, options);
//     std::cout << report;                                           // a line per property; .passed() for the exit status
//
// A failure comes with the worst case found, reduced to a short path. Its PATH.csv drives any law of this library along the
// same motion: examples/contact_path. The seed gives the same paths again. examples/verify_your_law.cpp is a whole program.
#pragma once

#include <fstream>
#include <string>

#include "contactlaws/verify/adapt.hpp"
#include "contactlaws/verify/checks/friction.hpp"
#include "contactlaws/verify/checks/histories.hpp"
#include "contactlaws/verify/checks/impacts.hpp"
#include "contactlaws/verify/checks/limits.hpp"
#include "contactlaws/verify/checks/symmetries.hpp"

namespace contactlaws::verify {

namespace detail {

/// FOLDER/name_of_the_property.csv. @throws std::runtime_error if it cannot be written
inline std::string write_path(const std::string& folder, const Result& result) {
  std::string file = folder + '/' + result.property + ".csv";
  for (std::size_t i = folder.size() + 1; i < file.size(); ++i)
    if (file[i] == ' ' || file[i] == '=') file[i] = '_';
  std::ofstream out(file);
  verify::write_path(out, result.path);
  out.close();
  if (!out) throw std::runtime_error(file + ": cannot be written");
  return file;
}

}  // namespace detail

/// @throws std::invalid_argument on an option out of range, before any check; std::runtime_error on a path not written
inline Report check_all(const ForceUpdate& update, const Options& options) {
  const Setup setup(update, options);
  const Claims& claims = options.claims;
  struct Property {
    const char* name;
    Result (*check)(const Setup&, const char* name);
    bool claimed = true, offered = true;
  };
  const bool both_torques = setup.returns([](const Interaction& i) { return i.torque1 && i.torque2; });
  const Property properties[] = {
      {"finite force", finite_force},
      {"third law", third_law, true, setup.returns([](const Interaction& i) { return i.force1.has_value(); })},
      {"torque balance", torque_balance, true, both_torques},
      {"frame indifference", frame_indifference},
      {"Galilean invariance", galilean_invariance},
      {"rigid spin", rigid_spin},
      {"rigid twist", rigid_twist, claims.follows_twist},
      {"swap of the bodies", swap_of_bodies},
      {"change of owner", change_of_owner, true, bool(update.exchanged)},
      {"unit scaling", unit_scaling, true, bool(update.in_units)},
      {"purity", purity},
      {"restart", restart, true, bool(update.restarted)},
      {"step of zero duration", zero_duration},
      {"Coulomb bound", coulomb_bound, bool(claims.friction)},
      {"friction reached", friction_reached, bool(claims.friction)},
      {"static friction reached", static_friction_reached, bool(claims.static_friction)},
      {"slip in small steps", slip_in_small_steps},
      {"no tension", no_tension, claims.no_tension},
      {"continuity at touch", continuity_at_touch, claims.continuous_at_touch},
      {"continuity in motion", continuity_in_motion, claims.continuous_in_motion},
      {"open contact", open_contact, bool(claims.range)},
      {"derivative = stiffness", stiffness_is_derivative, true, bool(update.stiffness)},
      {"step-size convergence", convergence},
      {"ratcheting", ratcheting, claims.no_ratcheting},
      {"dashpots dissipate", dashpots_dissipate},
      {"energy on closed loops", closed_loops, claims.passive},
      {"energy of impacts", oblique_impacts, claims.passive_impacts},
      {"restitution", restitution_as_claimed, bool(claims.restitution)}};
  Report report{options.seed};
  for (const auto& [name, check, claimed, offered] : properties) {
    if (claimed && offered) {
      report.results.push_back(check(setup, name));
    } else {
      report.results.push_back({name, claimed ? Verdict::not_offered : Verdict::not_claimed});
    }
  }
  if (options.folder.empty()) return report;
  for (Result& result : report.results)
    if (result.verdict == Verdict::fail) result.file = detail::write_path(options.folder, result);
  return report;
}

}  // namespace contactlaws::verify
