// SPDX-License-Identifier: MIT
// Checks of any force update. In three steps:
//
//   1. Adapt it: a struct with its history and a call.            (force_update.hpp lists what more it may offer)
//
//        struct MyLaw {
//          struct State { double shear[3] = {0, 0, 0}; };
//          verify::Interaction operator()(const verify::Bodies& pair, double dt, State& state) const {
//            ...                                                    // pair.one.position, .velocity, .spin, .radius, .mass
//            return {force_on_2, force_on_1, torque_on_1, torque_on_2};  // only the first is required
//          }
//        };
//
//   2. State the usual sizes, and what the law claims.            (options.hpp)
//
//        verify::Options options;
//        options.radius1 = options.radius2 = 5e-3;  options.mass1 = options.mass2 = 1.4e-3;  options.overlap = 5e-6;
//        options.claims.friction = 0.4;  options.claims.no_tension = true;
//        options.folder = "faults";                                 // where the paths of failures go, if anywhere
//
//   3. Read the report.                                           (report.hpp)
//
//        const verify::Report report = verify::check_all(MyLaw{}, options);
//        std::cout << report;                                       // a line per property
//        return report.passed() ? 0 : 1;
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
  Report report{options.seed, {}};
  for (Result (*check)(const Setup&) : {finite_force,
                                        third_law,
                                        torque_balance,
                                        frame_indifference,
                                        galilean_invariance,
                                        rigid_spin,
                                        rigid_twist,
                                        swap_of_bodies,
                                        change_of_owner,
                                        unit_scaling,
                                        purity,
                                        restart,
                                        zero_duration,
                                        coulomb_bound,
                                        friction_reached,
                                        static_friction_reached,
                                        slip_in_small_steps,
                                        no_tension,
                                        continuity_at_touch,
                                        continuity_in_motion,
                                        open_contact,
                                        stiffness_is_derivative,
                                        convergence,
                                        ratcheting,
                                        dashpots_dissipate,
                                        closed_loops,
                                        oblique_impacts,
                                        restitution_as_claimed})
    report.results.push_back(check(setup));
  if (options.folder.empty()) return report;
  for (Result& result : report.results)
    if (result.verdict == Verdict::fail) result.file = detail::write_path(options.folder, result);
  return report;
}

}  // namespace contactlaws::verify
