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

/// What contacts do to a body, added up.
struct Load {
  Eigen::Vector4d force = Eigen::Vector4d::Zero();    ///< [N]
  Eigen::Vector4d twist = Eigen::Vector4d::Zero();    ///< see Contacts::twist [N]
  Eigen::Vector4d shorter = Eigen::Vector4d::Zero();  ///< half the overlap of each, times its twist [N m]

  /// About the centre of a ball [N m]: its arms are shorter than its radius by half an overlap.
  Eigen::Vector4d moment(double radius) const {
    return (radius * twist - shorter).cwiseProduct(Eigen::Vector4d(1.0, 1.0, 1.0, 0.0));
  }
};

/// For each body, which contacts it has: those at `contacts[start[body]]` to before `contacts[start[body + 1]]`, ascending.
struct ContactsOfBody {
  std::vector<int> start;
  std::vector<int> contacts;

  template <class BodyOf>
  void list(std::size_t bodies, std::size_t count, const BodyOf& body_of) {
    start.assign(bodies + 1, 0);
    contacts.resize(count);
    for (std::size_t c = 0; c < count; ++c) ++start[body_of(c) + 1];
    for (std::size_t b = 0; b < bodies; ++b) start[b + 1] += start[b];
    std::vector<int> next = start;
    for (std::size_t c = 0; c < count; ++c)
      contacts[static_cast<std::size_t>(next[body_of(c)]++)] = static_cast<int>(c);
  }
};

template <class Law, class PackT>
class Contacts {
 public:
  using State = typename Law::State;

  /// One quantity of every contact: a column, or a number that serves all.
  using Pairs = contactlaws::PairProperties<contactlaws::Column<double>>;

  // Columns are as long as whole packs: the last is filled up with copies of the last contact, which nobody looks at.
  std::vector<Pair> bodies;  ///< of each contact
  std::vector<Row> force;    ///< on body 2 [N]
  std::vector<Row> twist;    ///< force x normal [N], either body's moment by its arm; and half the overlap [m]

  std::size_t size() const { return size_; }
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
    return pair_at<T>(pairs(), contact);
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
    const Pairs all_pairs = pairs();
    for (std::size_t c = first; c < last; c += lanes<PackT>) {
      const Look<PackT, typename PackLaw::State> look = look_at<PackT>(law_of_packs, meet, all_pairs, c);
      const contactlaws::Vec3<PackT>& push = look.response.force;
      dem::store<PackT>(force, c, {push, PackT(0.0)});
      dem::store<PackT>(twist, c, {push.cross(look.geometry.normal), look.geometry.overlap / PackT(2.0)});
      std::array<PackT, Law::state_size> values{};
      PackLaw::store(look.response.state, values.data());
      for (std::size_t i = 0; i < values.size(); ++i) dem::store(now_[i], c, values[i]);
    }
  }

  /// What contact number `contact` answered at the last step. A step is pure: whoever wants more than the force asks again.
  template <class Meet>
  Look<double, State> look(const Law& law, const Meet& meet, std::size_t contact) const {
    return look_at<double>(law, meet, pairs(), contact);
  }

  /// Adds what the contacts do to a body that comes first in them, or second.
  void add_first(std::size_t body, Load& load) const {
    for (int k = of_first_.start[body]; k < of_first_.start[body + 1]; ++k) {
      const auto c = static_cast<std::size_t>(k);  // contacts are sorted by their first body
      load.force -= force[c].four();
      load.twist += twist[c].four();
      load.shorter += twist[c].more * twist[c].four();
    }
  }
  void add_second(std::size_t body, Load& load) const {
    for (int k = of_second_.start[body]; k < of_second_.start[body + 1]; ++k) {
      const auto c = static_cast<std::size_t>(of_second_.contacts[static_cast<std::size_t>(k)]);
      load.force += force[c].four();
      load.twist += twist[c].four();
      load.shorter += twist[c].more * twist[c].four();
    }
  }

 private:
  using History = std::array<Column, Law::state_size>;

  std::size_t size_ = 0;
  contactlaws::PairProperties<Column> pair_;  ///< computed when a contact is listed; one number where all are alike
  History before_;                            ///< what the last step started from
  History now_;
  ContactsOfBody of_first_, of_second_;

  void add(const Pair& ids, const contactlaws::PairProperties<double>& p) {
    ++size_;
    bodies.push_back(ids);
    pair_.effective_radius.push_back(p.effective_radius);
    pair_.effective_young.push_back(p.effective_young);
    pair_.effective_shear.push_back(p.effective_shear);
    pair_.effective_mass.push_back(p.effective_mass);
    pair_.min_radius.push_back(p.min_radius);
    pair_.length.push_back(p.length);
  }

  void fill_up() {
    if (size_ == 0) return;
    const std::size_t length = (size_ + lanes<PackT> - 1) / lanes<PackT> * lanes<PackT>;
    bodies.resize(length, bodies.back());
    for (Column* column : {&pair_.effective_radius, &pair_.effective_young, &pair_.effective_shear,
                           &pair_.effective_mass, &pair_.min_radius, &pair_.length}) {
      const bool alike = std::equal(column->begin() + 1, column->end(), column->begin());
      column->resize(alike ? 1 : length, column->back());
    }
    for (History* history : {&before_, &now_})
      for (Column& column : *history) column.resize(length);
    force.resize(length);
    twist.resize(length);
  }

  Pairs pairs() const {
    const auto column = [](const Column& c) {
      return c.size() == 1 ? contactlaws::Column<double>(c[0]) : contactlaws::Column<double>(c.data());
    };
    return {column(pair_.effective_radius), column(pair_.effective_young), column(pair_.effective_shear),
            column(pair_.effective_mass),   column(pair_.min_radius),      column(pair_.length)};
  }
  template <class T>
  CONTACTLAWS_HD static contactlaws::PairProperties<T> pair_at(const Pairs& pairs, std::size_t contact) {
    const auto at = [contact](const contactlaws::Column<double>& column) {
      return column.array() ? contactlaws::ScalarTraits<T>::load(column.array() + contact) : T(column.same());
    };
    return {at(pairs.effective_radius), at(pairs.effective_young), at(pairs.effective_shear),
            at(pairs.effective_mass),   at(pairs.min_radius),      at(pairs.length)};
  }

  template <class T>
  CONTACTLAWS_HD static typename Law::template Rebind<T>::State state_at(const History& history, std::size_t contact) {
    std::array<T, Law::state_size> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = load<T>(history[i], contact);
    return Law::template Rebind<T>::load(values.data());
  }

  /// One contact (T = double), or the pack that starts with it. A contact beyond the law's range is forgotten, so that no
  /// result depends on how long the list still holds it: a law that knows a spot again after a gap sees a new contact here.
  template <class T, class LawT, class Meet>
  CONTACTLAWS_HD Look<T, typename LawT::State> look_at(const LawT& law, const Meet& meet, const Pairs& all_pairs,
                                                       std::size_t contact) const {
    std::array<std::size_t, lanes<T>> one, two;
    for (std::size_t l = 0; l < lanes<T>; ++l) {
      one[l] = first(contact + l);
      two[l] = second(contact + l);
    }
    const contactlaws::PairProperties<T> p = pair_at<T>(all_pairs, contact);
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
