// SPDX-License-Identifier: MIT
// The contacts of one kind (ball with ball, or wall with ball) under one law. The law is evaluated here:
//
//   gather   geometry and motion of each contact from its two bodies      (contact_motion.hpp)
//   law      contactlaws::evaluate, from histories to new histories        (contactlaws/batch.hpp)
//   scatter  force and moment of each contact; each body sums its own     add_first(), add_second()
//
// One column per quantity, so that a pack of contacts is evaluated at once. Contacts are sorted by the ids of their bodies and
// each body sums in that order, so no result depends on when neighbours were listed or on the number of threads.
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "contact_motion.hpp"
#include "contactlaws/batch.hpp"
#include "contactlaws/contact_law.hpp"
#include "neighbours.hpp"
#if __has_include(<xsimd/xsimd.hpp>)
#include "contactlaws/scalars/xsimd.hpp"
#endif

namespace dem {

/// As many numbers as the machine computes with at once; one number without xsimd.
using Pack = contactlaws::PackOf<double>::type;

/// What the law needs of a contact (or a pack of contacts), and its geometry.
template <class T>
struct Input : ContactMotion<T> {
  contactlaws::PairProperties<T> pair;
};

/// A contact at one step.
template <class State>
struct Outcome {
  contactlaws::ContactGeometry<double> geometry;  ///< now
  contactlaws::ContactKinematics<double> motion;  ///< over the last step
  contactlaws::Step<double, State> response;      ///< of the law to that motion
};

/// Sum over the contacts of a body.
struct Load {
  Eigen::Vector4d force = Eigen::Vector4d::Zero();   ///< [N]
  Eigen::Vector4d torque = Eigen::Vector4d::Zero();  ///< about its centre [N m]
};

/// Histories of a pair: before and after the last step.
template <class State>
struct PairHistory {
  Pair bodies;
  State before, now;
};

/// The contacts of each body: those at `contacts[start[body]]` to before `contacts[start[body + 1]]`, ascending.
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
  using History = PairHistory<State>;
  static constexpr std::size_t lanes = contactlaws::ScalarTraits<PackT>::lanes;
  static constexpr bool rolls = decltype(Law::rolling)::acts;

  std::vector<Pair> bodies;  ///< of each contact
  // As long as whole packs: rows beyond size() are not read.
  std::vector<Row> force;    ///< on body 2 [N]; w is the arm of body 1, along the normal [m]
  std::vector<Row> turning;  ///< normal x force [N]; w is the arm of body 2, against the normal [m]
  std::vector<Row> couple;   ///< on body 2 [N m], of a law with a rolling slot

  std::size_t size() const { return size_; }
  /// Memory of the list [bytes].
  std::size_t bytes() const {
    const auto of = [](const auto& vector) { return vector.capacity() * sizeof(vector[0]); };
    std::size_t sum = of(bodies) + of(force) + of(turning) + of(couple) + of(unlisted_);
    for (const Columns* history : {&before_, &now_})
      for (const std::vector<double>& column : *history) sum += of(column);
    pair_.map<double>([&](const std::vector<double>& column) { return sum += of(column), 0.0; });
    for (const ContactsOfBody* list : {&of_first_, &of_second_}) sum += of(list->start) + of(list->contacts);
    return sum;
  }
  std::size_t first(std::size_t contact) const { return static_cast<std::size_t>(bodies[contact].first); }
  std::size_t second(std::size_t contact) const { return static_cast<std::size_t>(bodies[contact].second); }

  State state(std::size_t contact) const { return state_at(now_, contact); }
  /// Whether `body` is the first, or the second, of a listed contact.
  bool has_first(std::size_t body) const { return of_first_.start[body] < of_first_.start[body + 1]; }
  bool has_second(std::size_t body) const { return of_second_.start[body] < of_second_.start[body + 1]; }

  contactlaws::PairProperties<double> pair(std::size_t contact) const {
    return pair_.map<double>([contact](const std::vector<double>& c) { return c.size() == 1 ? c[0] : c[contact]; });
  }

  /// Largest gap across which a pair acts [m]: none without a history, since contact begins at touch.
  static double reach(const Law& law, const contactlaws::PairProperties<double>& pair, const State& state) {
    return is_virgin(state) ? 0.0 : law.interaction_range(pair);
  }

  /// Lists the pairs that act or may do so before the next listing, in which a gap closes by at most `margin` [m]: of
  /// `found`, of those listed so far and of those with a history. `firsts` and `seconds` are the numbers of bodies;
  /// `properties(first, second)` yields PairProperties, `overlap(first, second)` [m].
  template <class Properties, class Overlap>
  void list(const Law& law, const std::vector<Pair>& found, double margin, std::size_t firsts, std::size_t seconds,
            const Properties& properties, const Overlap& overlap) {
    std::vector<History> pairs_known = histories();
    for (const Pair& pair : found) pairs_known.push_back({pair, {}, {}});
    const auto by_bodies = [](const History& a, const History& b) { return a.bodies < b.bodies; };
    const auto same_bodies = [](const History& a, const History& b) { return a.bodies == b.bodies; };
    std::stable_sort(pairs_known.begin(), pairs_known.end(), by_bodies);  // keeps a known history before a new one
    pairs_known.erase(std::unique(pairs_known.begin(), pairs_known.end(), same_bodies), pairs_known.end());

    *this = Contacts();
    std::vector<History> listed;
    for (const History& known : pairs_known) {
      const auto one = static_cast<std::size_t>(known.bodies.first),
                 two = static_cast<std::size_t>(known.bodies.second);
      const contactlaws::PairProperties<double> p = properties(one, two);
      if (-overlap(one, two) <= reach(law, p, known.now) + margin) {
        add(known.bodies, p);
        listed.push_back(known);
      } else if (Law::outlives_separation && !is_virgin(known.now)) {
        const contactlaws::ContactKinematics<double> open{Vec3::UnitX(), overlap(one, two), Vec3::Zero(), 0.0};
        const State state = law.step(p, open, known.now).state;
        unlisted_.push_back({known.bodies, state, state});
      }
    }
    complete_columns();
    for (std::size_t c = 0; c < size(); ++c) {
      set_state(before_, c, listed[c].before);
      set_state(now_, c, listed[c].now);
    }
    of_first_.list(firsts, size(), [this](std::size_t c) { return first(c); });
    of_second_.list(seconds, size(), [this](std::size_t c) { return second(c); });
  }

  /// All pairs that are listed or have a history.
  std::vector<History> histories() const {
    std::vector<History> all = unlisted_;
    for (std::size_t c = 0; c < size(); ++c) all.push_back({bodies[c], state_at(before_, c), state(c)});
    return all;
  }
  /// Histories that the next list() takes up.
  void set_histories(const std::vector<History>& histories) {
    *this = Contacts();
    unlisted_ = histories;
  }

  /// Wets a contact of this overlap [m] if its gap is at most `moisture_gap` [m].
  void make_wet(std::size_t contact, double overlap, double moisture_gap) {
    for (Columns* history : {&before_, &now_}) {
      State state = state_at(*history, contact);
      Law::make_wet(state, overlap, moisture_gap);
      set_state(*history, contact, state);
    }
  }

  /// Before all contacts are evaluated once: the histories after the last step are those before this one.
  void begin_step() { std::swap(before_, now_); }

  /// Evaluates contacts `first` (a multiple of the lanes) to before `last`: forces, torques and new histories.
  template <class Motion>
  void evaluate(const Law& law, const Motion& motion, std::size_t first, std::size_t last) {
    const Pairs all_pairs = pairs();
    const auto gather = [&](const auto& range)
                            CONTACTLAWS_INLINE_LAMBDA { return input<PackT>(motion, all_pairs, range); };
    const auto scatter = [this](const auto& range, const Input<PackT>& in, const auto& step) CONTACTLAWS_INLINE_LAMBDA {
      const contactlaws::Vec3<PackT>& normal = in.geometry.normal;
      const PackT arm1 = contactlaws::dot<PackT>(in.geometry.arm1, normal),
                  arm2 = contactlaws::dot<PackT>(in.geometry.arm2, normal);
      store(force, range.first(), step.force, arm1);
      store(turning, range.first(), normal.cross(step.force), PackT(-arm2));
      if constexpr (rolls) store(couple, range.first(), step.couple, PackT(0.0));
    };
    std::array<const double*, Law::state_size> before;
    std::array<double*, Law::state_size> after;
    for (std::size_t i = 0; i < Law::state_size; ++i) {
      before[i] = before_[i].data();
      after[i] = now_[i].data();
    }
    contactlaws::evaluate<Law, PackT>(law, first, last, before, after, gather, scatter);
  }

  /// A contact at the last step: a step is pure, so it may be evaluated again for more than its force.
  template <class Motion>
  Outcome<State> outcome(const Law& law, const Motion& motion, std::size_t contact) const {
    const Input<double> in = input<double>(motion, pairs(), contactlaws::PackRange<double, true>(contact, 1));
    return {in.geometry, in.kinematics, law.step(in.pair, in.kinematics, state_at(before_, contact))};
  }

  /// Adds the forces and torques of the contacts of which `body` is the first, or the second: a sphere, whose arm lies along the
  /// normal. The fourth numbers of the sums have no meaning.
  void add_first(std::size_t body, Load& load) const {
    for (int k = of_first_.start[body]; k < of_first_.start[body + 1]; ++k) {
      const auto c = static_cast<std::size_t>(k);  // contacts are sorted by their first body
      load.force -= force[c].all();
      load.torque -= turning[c].all() * force[c].w;
      if constexpr (rolls) load.torque -= couple[c].all();
    }
  }
  void add_second(std::size_t body, Load& load) const {
    for (int k = of_second_.start[body]; k < of_second_.start[body + 1]; ++k) {
      const auto c = static_cast<std::size_t>(of_second_.contacts[static_cast<std::size_t>(k)]);
      load.force += force[c].all();
      load.torque -= turning[c].all() * turning[c].w;
      if constexpr (rolls) load.torque += couple[c].all();
    }
  }

 private:
  using Pairs = contactlaws::PairProperties<contactlaws::Column<double>>;
  using Columns = std::array<std::vector<double>, Law::state_size>;

  std::size_t size_ = 0;
  contactlaws::PairProperties<std::vector<double>> pair_;  ///< a column of one number where all are equal
  Columns before_, now_;                                   ///< histories before and after the last step
  std::vector<History> unlisted_;                          ///< histories that outlive the listing of their pairs
  ContactsOfBody of_first_, of_second_;

  static bool is_virgin(const State& state) {
    std::array<double, Law::state_size> values{};
    Law::store(state, values.data());
    return std::all_of(values.begin(), values.end(), [](double x) { return x == 0.0; });
  }
  static void set_state(Columns& history, std::size_t contact, const State& state) {
    std::array<double, Law::state_size> values{};
    Law::store(state, values.data());
    for (std::size_t i = 0; i < values.size(); ++i) history[i][contact] = values[i];
  }

  std::array<std::vector<double>*, 6> pair_columns() {
    return {&pair_.effective_radius, &pair_.effective_young, &pair_.effective_shear,
            &pair_.effective_mass,   &pair_.min_radius,      &pair_.length};
  }
  void add(const Pair& ids, const contactlaws::PairProperties<double>& p) {
    ++size_;
    bodies.push_back(ids);
    const auto columns = pair_columns();
    auto column = columns.begin();
    p.template map<double>([&column](double x) { return (*column++)->push_back(x), x; });
  }

  void complete_columns() {
    if (size_ == 0) return;
    for (std::vector<double>* column : pair_columns()) {
      const bool all_equal = std::equal(column->begin() + 1, column->end(), column->begin());
      if (all_equal) column->resize(1);
    }
    for (Columns* history : {&before_, &now_})
      for (std::vector<double>& column : *history) column.resize(size_);
    const std::size_t whole_packs = (size_ + lanes - 1) / lanes * lanes;
    for (std::vector<Row>* rows : {&force, &turning}) rows->resize(whole_packs);
    if constexpr (rolls) couple.resize(whole_packs);
  }

  Pairs pairs() const {
    return pair_.map<contactlaws::Column<double>>([](const std::vector<double>& c) {
      return c.size() == 1 ? contactlaws::Column<double>(c[0]) : contactlaws::Column<double>(c.data());
    });
  }
  static State state_at(const Columns& history, std::size_t contact) {
    std::array<double, Law::state_size> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = history[i][contact];
    return Law::load(values.data());
  }

  CONTACTLAWS_HD static void store(std::vector<Row>& rows, std::size_t first, const contactlaws::Vec3<PackT>& v,
                                   const PackT& w) {
    contactlaws::store_rows<PackT>(rows[first].data(), {v.x(), v.y(), v.z(), w});
  }

  /// Input of the law for the contacts of a range.
  template <class T, class Motion, class Range>
  CONTACTLAWS_HD Input<T> input(const Motion& motion, const Pairs& all_pairs, const Range& range) const {
    Ids<T> one, two;
    for (std::size_t l = 0; l < one.size(); ++l) {
      one[l] = first(range[l]);
      two[l] = second(range[l]);
    }
    return {motion.template at<T>(one, two),
            all_pairs.template map<T>([&range](const auto& column)
                                          CONTACTLAWS_INLINE_LAMBDA { return range.load(column); })};
  }
};

}  // namespace dem
