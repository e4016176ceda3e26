// SPDX-License-Identifier: MIT
// Checks for anybody's force update. In three steps:
//
//   1. Adapt it: a struct with its history and a call.            (adapter.hpp tells what more it may offer)
//
//        struct MyLaw {
//          struct State { double shear[3] = {0, 0, 0}; };
//          verify::Interaction operator()(const verify::Bodies& pair, double dt, State& state) const {
//            ...                                                    // pair.one.position, .velocity, .spin, .radius, .mass
//            return {force_on_2, force_on_1, torque_on_1, torque_on_2};  // only the first must be there
//          }
//        };
//
//   2. Say how large things are, and what the law promises.       (options.hpp)
//
//        verify::Options options;
//        options.radius1 = options.radius2 = 5e-3;  options.mass1 = options.mass2 = 1.4e-3;  options.overlap = 5e-6;
//        options.claims.friction = 0.4;  options.claims.no_tension = true;
//        options.folder = "faults";                                 // where the paths of failures go, if anywhere
//
//   3. Look at what comes out.                                    (report.hpp)
//
//        const verify::Report report = verify::check_all(MyLaw{}, options);
//        std::cout << report;                                       // a line per property
//        return report.passed() ? 0 : 1;
//
// A failure comes with the worst case found, reduced to a short path. Its PATH.csv drives any law of ours along the same
// motion: examples/contact_path. The seed gives the same paths again. examples/verify_your_law.cpp is a whole program.
#pragma once

#include <fstream>
#include <string>

#include "contactlaws/verify/adapt.hpp"
#include "contactlaws/verify/histories.hpp"
#include "contactlaws/verify/impacts.hpp"
#include "contactlaws/verify/limits.hpp"
#include "contactlaws/verify/symmetries.hpp"

namespace contactlaws::verify {

namespace detail {

/// FOLDER/name_of_the_property.csv. @throws std::runtime_error if it cannot be written
inline std::string write_path(const std::string& folder, const Result& result) {
  std::string file = folder + '/' + result.property + ".csv";
  for (std::size_t i = folder.size() + 1; i < file.size(); ++i)
    if (file[i] == ' ' || file[i] == '=') file[i] = '_';
  std::ofstream out(file);
  verify::write_path(out, result.path);
  if (!out.flush()) throw std::runtime_error(file + ": cannot be written");
  return file;
}

}  // namespace detail

/// @throws std::invalid_argument on an option out of range, std::runtime_error on a folder that cannot be written to
template <class Law>
Report check_all(const Law& law, const Options& options) {
  const Trial<Law> trial(law, options);
  Report report{options.seed,
                {finite_force(trial),
                 third_law(trial),
                 torque_balance(trial),
                 frame_indifference(trial),
                 galilean_invariance(trial),
                 rigid_spin(trial),
                 rigid_twist(trial),
                 swap_of_bodies(trial),
                 change_of_owner(trial),
                 unit_scaling(trial),
                 purity(trial),
                 restart(trial),
                 coulomb_bound(trial),
                 friction_reached(trial),
                 no_tension(trial),
                 continuity_at_touch(trial),
                 continuity_in_motion(trial),
                 open_contact(trial),
                 stiffness_is_derivative(trial),
                 convergence(trial),
                 ratcheting(trial),
                 closed_loops(trial),
                 oblique_impacts(trial),
                 restitution_as_asked(trial)}};
  if (options.folder.empty()) return report;
  for (Result& result : report.results)
    if (result.verdict == Verdict::fail) result.file = detail::write_path(options.folder, result);
  return report;
}

}  // namespace contactlaws::verify
