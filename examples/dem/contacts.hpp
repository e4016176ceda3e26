// SPDX-License-Identifier: MIT
// The contacts of one kind (ball with ball, or wall with ball) under one law: here the law is called.
//
//   gather   where do the two bodies of each contact meet, and how did they move     (meetings.hpp)
//   ask      step = law.step(pair, motion, history)                                  look()
//   scatter  forces and moments, to the bodies                                       add_first(), add_second()
//
// One column per quantity, so that as many contacts as a pack has lanes are asked at once. Contacts are sorted by the ids of
// their bodies, and each body adds up its own in that order: no result depends on what the list was built from, nor on how
// many threads share the work.
#pragma once

#include <algorithm>
#include <array>
#include <ostream>
#include <utility>
#include <vector>

#include "contactlaws/contact_law.hpp"
#include "meetings.hpp"
#include "neighbours.hpp"

namespace dem {

/// All there is to know of a contact (or a pack of contacts) at one step.
template <class T, class State>
struct Look {
  contactlaws::ContactGeometry<T> geometry;  ///< now
  contactlaws::ContactKinematics<T> motion;  ///< over the last step
  contactlaws::Step<T, State> response;      ///< to that motion
};

/// For each body, which contacts it has: those at `contacts[start[body]]` to before `contacts[start[body + 1]]`, ascending.
struct ContactsOfBody {
  std::vector<std::size_t> start;
  std::vector<std::size_t> contacts;

  template <class BodyOf>
  void list(std::size_t bodies, std::size_t count, const BodyOf& body_of) {
    start.assign(bodies + 1, 0);
    contacts.resize(count);
    for (std::size_t c = 0; c < count; ++c) ++start[body_of(c) + 1];
    for (std::size_t b = 0; b < bodies; ++b) start[b + 1] += start[b];
    std::vector<std::size_t> next = start;
    for (std::size_t c = 0; c < count; ++c) contacts[next[body_of(c)]++] = c;
  }
};

template <class Law, class PackT>
class Contacts {
 public:
  using State = typename Law::State;

  std::vector<Pair> bodies;                  ///< of each contact
  contactlaws::PairProperties<Column> pair;  ///< computed once, when the contact is listed
  std::array<Column, 3> force;               ///< on body 2 [N]
  std::array<Column, 3> moment1;             ///< about the centre of body 1 [N m]
  std::array<Column, 3> moment2;             ///< about the centre of body 2 [N m]

  std::size_t size() const { return bodies.size(); }
  std::size_t first(std::size_t contact) const { return static_cast<std::size_t>(bodies[contact].first); }
  std::size_t second(std::size_t contact) const { return static_cast<std::size_t>(bodies[contact].second); }

  /// The contact's history, and another in its place.
  State state(std::size_t contact) const { return state_at<double>(now_, contact); }
  void set_state(std::size_t contact, const State& state) {
    std::array<double, Law::state_size> values{};
    Law::store(state, values.data());
    for (std::size_t i = 0; i < values.size(); ++i) now_[i][contact] = values[i];
  }

  template <class T>
  CONTACTLAWS_HD contactlaws::PairProperties<T> pair_at(std::size_t contact) const {
    return {load<T>(pair.radius, contact), load<T>(pair.young, contact),          load<T>(pair.shear, contact),
            load<T>(pair.mass, contact),   load<T>(pair.smaller_radius, contact), load<T>(pair.length, contact)};
  }

  /// Lists those of `candidates` that are near enough, with histories carried over and new contacts virgin.
  /// `properties(first, second)` yields PairProperties, `overlap(first, second)` [m]; `margin` [m] is what a gap may
  /// close before the next listing; `firsts` and `seconds` are the numbers of bodies.
  template <class Properties, class Overlap>
  void list(const Law& law, std::vector<Pair> candidates, double margin, std::size_t firsts, std::size_t seconds,
            const Properties& properties, const Overlap& overlap) {
    std::sort(candidates.begin(), candidates.end());
    Contacts next;
    std::vector<State> states;
    std::size_t old = 0;
    for (const Pair& candidate : candidates) {
      const auto one = static_cast<std::size_t>(candidate.first), two = static_cast<std::size_t>(candidate.second);
      while (old < size() && bodies[old] < candidate) ++old;
      const bool known = old < size() && bodies[old] == candidate;
      const contactlaws::PairProperties<double> p = known ? pair_at<double>(old) : properties(one, two);
      if (-overlap(one, two) > law.interaction_range(p) + margin) continue;
      next.add(candidate, p);
      states.push_back(known ? state(old) : State{});
    }
    next.fill_up();
    for (std::size_t c = 0; c < next.size(); ++c) next.set_state(c, states[c]);
    next.of_first_.list(firsts, next.size(), [&next](std::size_t c) { return next.first(c); });
    next.of_second_.list(seconds, next.size(), [&next](std::size_t c) { return next.second(c); });
    *this = std::move(next);
  }

  /// Before all contacts are asked once: what came out of the last step goes into this one.
  void begin_step() { std::swap(before_, now_); }

  /// Asks the law for the responses of contacts `first` (a multiple of the lanes) to `last`, and moves their histories on.
  template <class Meet>
  CONTACTLAWS_FLATTEN void ask(const Law& law, const Meet& meet, std::size_t first, std::size_t last) {
    const auto law_of_packs = law.template cast<PackT>();
    using PackLaw = typename Law::template Rebind<PackT>;
    for (std::size_t c = first; c < last; c += lanes<PackT>) {
      const Look<PackT, typename PackLaw::State> look = look_at<PackT>(law_of_packs, meet, c);
      const contactlaws::Vec3<PackT>& push = look.response.force;
      store(force, c, push);
      store(moment1, c, contactlaws::Vec3<PackT>(push.cross(look.geometry.arm1)));
      store(moment2, c, contactlaws::Vec3<PackT>(look.geometry.arm2.cross(push)));
      std::array<PackT, Law::state_size> values{};
      PackLaw::store(look.response.state, values.data());
      for (std::size_t i = 0; i < values.size(); ++i) dem::store(now_[i], c, values[i]);
    }
  }

  /// What contact number `contact` answered at the last step. A step is pure: whoever wants more than the force asks again.
  template <class Meet>
  Look<double, State> look(const Law& law, const Meet& meet, std::size_t contact) const {
    return look_at<double>(law, meet, contact);
  }

  /// Adds up what the contacts do to a body that comes first in them, or second.
  void add_first(std::size_t body, Vec3& sum_of_forces, Vec3& sum_of_moments) const {
    for (std::size_t k = of_first_.start[body]; k < of_first_.start[body + 1]; ++k) {
      const std::size_t c = of_first_.contacts[k];
      sum_of_forces -= Vec3(force[0][c], force[1][c], force[2][c]);
      sum_of_moments += Vec3(moment1[0][c], moment1[1][c], moment1[2][c]);
    }
  }
  void add_second(std::size_t body, Vec3& sum_of_forces, Vec3& sum_of_moments) const {
    for (std::size_t k = of_second_.start[body]; k < of_second_.start[body + 1]; ++k) {
      const std::size_t c = of_second_.contacts[k];
      sum_of_forces += Vec3(force[0][c], force[1][c], force[2][c]);
      sum_of_moments += Vec3(moment2[0][c], moment2[1][c], moment2[2][c]);
    }
  }

 private:
  using History = std::array<Column, Law::state_size>;

  History before_;  ///< what the last step started from
  History now_;
  ContactsOfBody of_first_, of_second_;

  void add(const Pair& ids, const contactlaws::PairProperties<double>& p) {
    bodies.push_back(ids);
    pair.radius.push_back(p.radius);
    pair.young.push_back(p.young);
    pair.shear.push_back(p.shear);
    pair.mass.push_back(p.mass);
    pair.smaller_radius.push_back(p.smaller_radius);
    pair.length.push_back(p.length);
  }

  /// Makes columns as long as whole packs: the last is filled up with copies of the last contact, which nobody looks at.
  void fill_up() {
    const std::size_t length = (size() + lanes<PackT> - 1) / lanes<PackT> * lanes<PackT>;
    for (Column* column : {&pair.radius, &pair.young, &pair.shear, &pair.mass, &pair.smaller_radius, &pair.length})
      if (length > 0) column->resize(length, column->back());
    for (std::array<Column, 3>* vector : {&force, &moment1, &moment2})
      for (Column& column : *vector) column.resize(length);
    for (History* history : {&before_, &now_})
      for (Column& column : *history) column.resize(length);
  }

  template <class T>
  CONTACTLAWS_HD static void store(std::array<Column, 3>& columns, std::size_t first, const contactlaws::Vec3<T>& v) {
    for (int i = 0; i < 3; ++i) dem::store<T>(columns[static_cast<std::size_t>(i)], first, v[i]);
  }

  template <class T>
  CONTACTLAWS_HD static typename Law::template Rebind<T>::State state_at(const History& history, std::size_t contact) {
    std::array<T, Law::state_size> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = load<T>(history[i], contact);
    return Law::template Rebind<T>::load(values.data());
  }

  /// One contact (T = double), or the pack that starts with it. A contact beyond the law's range is forgotten, so that no
  /// result depends on how long the list still holds it.
  template <class T, class LawT, class Meet>
  CONTACTLAWS_HD Look<T, typename LawT::State> look_at(const LawT& law, const Meet& meet, std::size_t contact) const {
    std::array<std::size_t, lanes<T>> one, two;
    for (std::size_t l = 0; l < lanes<T>; ++l) {
      const std::size_t c = std::min(contact + l, size() - 1);
      one[l] = first(c);
      two[l] = second(c);
    }
    const contactlaws::PairProperties<T> p = pair_at<T>(contact);
    const Meeting<T> meeting = meet.template at<T>(one, two);
    auto response = law.step(p, meeting.motion, state_at<T>(before_, contact));
    const contactlaws::Mask<T> beyond = -meeting.geometry.overlap > law.interaction_range(p);
    if (contactlaws::any<T>(beyond)) {
      std::array<T, Law::state_size> values{};
      LawT::store(response.state, values.data());
      for (T& value : values) value = contactlaws::select<T>(beyond, T(0), value);
      response.state = LawT::load(values.data());
    }
    return {meeting.geometry, meeting.motion, response};
  }
};

}  // namespace dem
