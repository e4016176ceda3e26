// SPDX-License-Identifier: MIT
// The contacts of one kind (ball with ball, or wall with ball) under one law: here the law is called.
//
//   gather   geometry and motion, from the bodies                 (simulation.hpp)
//   ask      response = law.step(pair, motion, state)             ask()
//   scatter  the force, to the bodies                             (simulation.hpp)
//
// Plain arrays with one entry per contact, sorted by the ids of its bodies: whatever the list was built from, forces are
// added up in the same order, and the normal never flips.
#pragma once

#include <algorithm>
#include <ostream>
#include <utility>
#include <vector>

#include "contactlaws/contact_law.hpp"
#include "neighbours.hpp"

namespace dem {

template <class Law>
struct Contacts {
  using State = typename Law::State;
  using Response = contactlaws::Step<double, State>;

  std::vector<Pair> bodies;
  std::vector<contactlaws::PairProperties<double>> pair;       ///< computed once, when the contact is listed
  std::vector<State> state;                                    ///< the contact's history
  std::vector<contactlaws::ContactGeometry<double>> geometry;  ///< now
  std::vector<contactlaws::ContactKinematics<double>> motion;  ///< over the last step
  std::vector<Response> response;                              ///< to that motion

  std::size_t size() const { return bodies.size(); }
  std::size_t first(std::size_t contact) const { return static_cast<std::size_t>(bodies[contact].first); }
  std::size_t second(std::size_t contact) const { return static_cast<std::size_t>(bodies[contact].second); }

  /// Lists those of `candidates` that are near enough, with histories carried over and new contacts virgin.
  /// `properties(first, second)` yields PairProperties, `meet(first, second)` ContactGeometry; `margin` [m] is what a gap may
  /// close before the next listing.
  template <class Properties, class Meet>
  void list(const Law& law, std::vector<Pair> candidates, double margin, const Properties& properties,
            const Meet& meet) {
    std::sort(candidates.begin(), candidates.end());
    Contacts next;
    std::size_t old = 0;
    for (const Pair& candidate : candidates) {
      const auto one = static_cast<std::size_t>(candidate.first), two = static_cast<std::size_t>(candidate.second);
      while (old < size() && bodies[old] < candidate) ++old;
      const bool known = old < size() && bodies[old] == candidate;
      const contactlaws::PairProperties<double> p = known ? pair[old] : properties(one, two);
      if (-meet(one, two).overlap > law.interaction_range(p) + margin) continue;
      next.bodies.push_back(candidate);
      next.pair.push_back(p);
      next.state.push_back(known ? state[old] : State{});
    }
    next.geometry.resize(next.size());
    next.motion.resize(next.size());
    next.response.resize(next.size());
    *this = std::move(next);
  }

  /// Asks the law for every contact's response, and moves the histories on. A contact beyond the law's range is forgotten,
  /// so that no result depends on how long the list still holds it.
  void ask(const Law& law) {
    for (std::size_t c = 0; c < size(); ++c) {
      if (-motion[c].overlap <= law.interaction_range(pair[c])) {
        response[c] = law.step(pair[c], motion[c], state[c]);
      } else {
        response[c] = {Vec3::Zero(), State{}, 0.0, 0.0, 0.0, false, false};
      }
      state[c] = response[c].state;
    }
  }
};

/// Writes a line for each two bodies that overlap by more than a tenth of the smaller radius.
template <class Law>
void warn_of_overlaps(const Contacts<Law>& contacts, const char* first_kind, std::ostream& log) {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const double overlap = contacts.geometry[c].overlap;
    const double allowed = contacts.pair[c].smaller_radius / 10.0;
    if (overlap > allowed)
      log << "warning: " << first_kind << ' ' << contacts.first(c) << " and ball " << contacts.second(c)
          << " start with an overlap of " << overlap << " m, more than a tenth of the smaller radius (" << allowed
          << " m)\n";
  }
}

/// A motion measured half a step ago, between positions, brought to the contact plane of now: turned as the normal turned
/// since. `centres` is the velocity of centre 2 relative to centre 1 [m/s], `distance` theirs [m]. Unturned, a part of the
/// normal velocity would pass for sliding, and in a grain that vibrates at a slant it adds up. (Vyas et al. 2025, doi
/// 10.1016/j.cpc.2025.109524, trace small grains that stick to large ones to that.)
inline contactlaws::ContactKinematics<double> at_full_step(contactlaws::ContactKinematics<double> motion,
                                                           const Vec3& centres, double distance) {
  const Vec3& n = motion.normal;
  const Vec3 turn = (centres - n * n.dot(centres)) * (motion.dt / (2.0 * distance));  // of the normal, in half a step
  const Vec3 v = motion.velocity;
  motion.velocity = v + turn * n.dot(v) - n * turn.dot(v);
  return motion;
}

}  // namespace dem
