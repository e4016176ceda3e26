// SPDX-License-Identifier: MIT
// A minimal discrete element method: balls and walls, one contact law between balls and one at walls. One step:
//
//   kick      v += F/m dt      velocities are half a step behind the positions (leapfrog; PFC's scheme)
//   drift     x += v dt
//   search    list the neighbours anew if a body has moved half the margin of the list
//   forces    evaluate the law for all contacts, sum forces and torques on each body     (contacts.hpp)
//
// Contacts between balls are evaluated in packs. Threads share the contacts, then the balls: the bits of a result are the same
// for any number of threads. There is no formula of contact here: copy this to see how a law is called.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <vector>

#include "contacts.hpp"
#include "parallel.hpp"

namespace dem {

/// `BallPack`: the contacts between balls that are evaluated at once; double for one.
template <class BallLaw, class WallLaw = BallLaw, class BallPack = Pack>
class Simulation {
 public:
  BallLaw ball_law;  ///< between two balls
  WallLaw wall_law;  ///< between a wall (body 1) and a ball (body 2)

  Vec3 gravity = Vec3::Zero();     ///< [m/s^2]
  double local_damping = 0.0;      ///< share of an unbalanced force that opposes motion, in [0, 1); PFC's is 0.7 [1]
  double time_step = 0.0;          ///< [s]; may change from step to step
  double skin = 0.3;               ///< neighbours are listed up to gaps of this many smallest radii [1]
  int threads = 1;                 ///< that share the work of a step
  std::ostream* log = &std::clog;  ///< receives warnings; null for none

  Balls balls;
  std::vector<Wall> walls;
  Contacts<BallLaw, BallPack> ball_contacts;
  Contacts<WallLaw, double> wall_contacts;  ///< few: evaluated one at a time
  double time = 0.0;                        ///< [s]
  std::int64_t steps = 0;                   ///< taken so far
  std::int64_t listings = 0;                ///< of neighbours, so far
  double last_step = 0.0;   ///< [s]; 0 before the first: velocities then belong to the start, not to half a step before
  double contact_dt = 0.0;  ///< step over which the contacts were last evaluated [s]

  Simulation(const BallLaw& between_balls, const WallLaw& at_walls)
      : ball_law(contactlaws::checked(between_balls)), wall_law(contactlaws::checked(at_walls)) {}
  /// One law for both.
  explicit Simulation(const BallLaw& law) : Simulation(law, law) {}

  /// The new body's id. @throws std::invalid_argument as Balls::add and check(Wall) say
  int add(const Ball& ball) {
    started_ = false;
    return balls.add(ball);
  }
  int add(const Wall& wall) {
    check(wall);
    started_ = false;
    walls.push_back(wall);
    return static_cast<int>(walls.size()) - 1;
  }

  /// Gives a ball (or a wall) the properties of another body: radius, mass, elasticity. Its contacts follow at the next step.
  /// @throws std::invalid_argument if there is no such ball, or as Balls::add says
  void change(int ball, const contactlaws::ContactBody<double>& body) {
    balls.change(checked_id(ball, balls.size(), "ball"), body);
    started_ = false;
  }
  void change_wall(int wall, const contactlaws::ContactBody<double>& body) {
    walls[checked_id(wall, walls.size(), "wall")].side = body;
    started_ = false;
  }

  /// From now on the ball moves at this velocity [m/s] and spin [rad/s], whatever the forces.
  /// @throws std::invalid_argument if there is no such ball
  void drive(int ball, const Vec3& velocity, const Vec3& spin = Vec3::Zero()) {
    const std::size_t b = checked_id(ball, balls.size(), "ball");
    balls.free[b] = false;
    balls.velocity[b] = velocity;
    balls.spin[b] = spin;
  }
  /// From now on forces move the ball, from rest. @throws std::invalid_argument if there is no such ball
  void release(int ball) {
    drive(ball, Vec3::Zero());
    balls.free[static_cast<std::size_t>(ball)] = true;
  }
  /// From now on the wall moves at this velocity [m/s]. @throws std::invalid_argument if there is no such wall
  void drive_wall(int wall, const Vec3& velocity) { walls[checked_id(wall, walls.size(), "wall")].velocity = velocity; }

  /// Wets the contacts between balls with gaps of at most `moisture_gap` [m], for laws with a bridge. Forces follow with the
  /// next step.
  void make_wet(double moisture_gap) {
    start();
    list_neighbours(moisture_gap);
    for (std::size_t c = 0; c < ball_contacts.size(); ++c)
      ball_contacts.make_wet(c, ball_contact(c).geometry.overlap, moisture_gap);
  }

  /// Advances by time_step. @throws std::invalid_argument if time_step, local_damping or threads is out of range
  void step() { finish_step(begin_step()); }

  /// The two halves of a step, for a program that moves rigid bodies in between (clumps.hpp). The first moves free balls and
  /// walls and returns whether one has moved far enough for neighbours to be listed anew; the second lists them if so, and
  /// computes forces.
  bool begin_step() {
    contactlaws::require_in(contactlaws::Range::positive(), time_step, "Simulation", "time_step", "s");
    contactlaws::require_in({0.0, 1.0, true, false}, local_damping, "Simulation", "local_damping", "1");
    contactlaws::require_in({1.0, std::numeric_limits<double>::infinity(), true, false}, threads, "Simulation",
                            "threads", "1");
    start();
    const bool moved_far = move(kick(), time_step);
    last_step = time_step;
    time += time_step;
    ++steps;
    return moved_far;
  }
  void finish_step(bool moved_far) {
    if (moved_far) list_neighbours();
    compute_forces(last_step);
  }
  /// An unbalanced force or torque F less local damping: F - alpha |F| sign(v), per component (Itasca).
  template <class Vector>
  Vector damped(const Vector& load, const Vector& velocity) const {
    if (!(local_damping > 0.0)) return load;
    const auto sign = (velocity.array() * 1e308).max(-1.0).min(1.0);  // no branches: signs cannot be predicted
    return load.array() - local_damping * load.array().abs() * sign;
  }

  /// How far a body may move before neighbours are listed anew [m].
  double allowed_motion() const { return margin_ / 2.0; }
  /// From the middle of the last step to the middle of the next one [s].
  double kick() const { return (last_step + time_step) / 2.0; }

  /// Lists neighbours and computes forces where bodies were added or changed; no time passes, so no history moves. Each step
  /// begins with it.
  void start() {
    if (started_) return;
    resume();
    compute_forces(0.0);
    if (log == nullptr) return;
    for (std::size_t c = 0; c < ball_contacts.size(); ++c)
      warn_of_overlap(ball_contacts, "ball", c, ball_contact(c).geometry.overlap);
    for (std::size_t c = 0; c < wall_contacts.size(); ++c)
      warn_of_overlap(wall_contacts, "wall", c, wall_contact(c).geometry.overlap);
  }
  /// Lists the neighbours of a scene whose forces and histories were restored.
  void resume() {
    started_ = true;
    list_neighbours();
  }

  /// A contact at the last step: geometry, motion, response of the law. Bodies must be as that step left them.
  Outcome<typename BallLaw::State> ball_contact(std::size_t contact) const {
    return ball_contacts.outcome(ball_law, ball_motion(), contact);
  }
  Outcome<typename WallLaw::State> wall_contact(std::size_t contact) const {
    return wall_contacts.outcome(wall_law, wall_motion(), contact);
  }

 private:
  using Vec4 = Eigen::Vector4d;

  bool started_ = false;
  double margin_ = 0.0;  ///< largest gap of two listed bodies that do not act on each other [m]
  // When neighbours were listed:
  std::vector<Row> listed_at_;  ///< positions of balls [m]
  std::vector<Wall> listed_walls_;
  std::vector<std::size_t> active_;  ///< balls with listed contacts, and those that no clump moves

  static std::size_t checked_id(int id, std::size_t count, const char* kind) {
    contactlaws::require_in({0.0, static_cast<double>(count), true, false}, id, "Simulation", kind, "1");
    return static_cast<std::size_t>(id);
  }

  /// Warns of an overlap of more than a tenth of the smaller radius.
  template <class Contacts>
  void warn_of_overlap(const Contacts& contacts, const char* first_kind, std::size_t c, double overlap) const {
    const double allowed = contacts.pair(c).min_radius / 10.0;
    if (overlap > allowed)
      *log << "warning: " << first_kind << ' ' << contacts.first(c) << " and ball " << contacts.second(c)
           << " start with an overlap of " << overlap << " m, more than a tenth of the smaller radius (" << allowed
           << " m)\n";
  }

  // Motion ------------------------------------------------------------------------------------------------------------

  /// Updates velocities over `kick` and positions over `drift` [s]. Whether a body has moved half a margin since neighbours
  /// were listed.
  bool move(double kick, double drift) {
    const double allowed = margin_ * margin_ / 4.0;
    std::atomic<bool> far{false};
    const Vec4 acceleration(gravity.x(), gravity.y(), gravity.z(), 0.0);
    in_parallel(threads, balls.size(), 1, [&, this](std::size_t first, std::size_t last) {
      for (std::size_t b = first; b < last; ++b) {
        if (balls.group[b] >= 0) continue;  // its body moves it
        auto position = balls.position[b].all(), velocity = balls.velocity[b].all(), spin = balls.spin[b].all();
        if (balls.free[b]) {
          const Vec4 force = balls.force[b].all() + balls.mass[b] * acceleration;
          velocity += damped<Vec4>(force, velocity) * (kick / balls.mass[b]);
          spin += damped<Vec4>(balls.torque[b].all(), spin) * (kick / balls.inertia[b]);
        }
        position += velocity * drift;
        if ((position - listed_at_[b].all()).squaredNorm() > allowed) far = true;
      }
    });
    for (std::size_t w = 0; w < walls.size(); ++w) {
      walls[w].move(drift);
      if (walls[w].distance_from(listed_walls_[w]) > allowed_motion()) far = true;
    }
    return far;
  }

  // Neighbours --------------------------------------------------------------------------------------------------------

  /// Lists pairs with gaps up to the margin, and `more` [m].
  void list_neighbours(double more = 0.0) {
    ++listings;
    margin_ = balls.size() > 0 ? skin * *std::min_element(balls.radius.begin(), balls.radius.end()) : 0.0;
    const double reach = margin_ + more;
    const auto index = [](std::size_t i) { return std::array<std::size_t, 1>{i}; };
    const auto ball_overlap = [&, this](std::size_t i, std::size_t j) {
      return ball_motion().template at<double>(index(i), index(j)).geometry.overlap;
    };
    const auto wall_overlap = [&, this](std::size_t w, std::size_t b) {
      return wall_motion().template at<double>(index(w), index(b)).geometry.overlap;
    };
    const auto meet = [](int group, int other) { return group == -1 || group != other; };
    const auto apart = [&, this](std::size_t i, std::size_t j) { return meet(balls.group[i], balls.group[j]); };
    const std::vector<Pair> near = find_neighbours(balls.position, balls.radius, reach, apart);
    std::vector<Pair> at_walls;
    for (std::size_t w = 0; w < walls.size(); ++w)
      for (std::size_t b = 0; b < balls.size(); ++b)
        if (meet(walls[w].group, balls.group[b]) && -wall_overlap(w, b) <= reach)
          at_walls.push_back({static_cast<int>(w), static_cast<int>(b)});
    ball_contacts.list(
        ball_law, near, reach, balls.size(), balls.size(),
        [this](std::size_t i, std::size_t j) { return contactlaws::pair_properties(balls.side[i], balls.side[j]); },
        ball_overlap);
    wall_contacts.list(
        wall_law, at_walls, reach, walls.size(), balls.size(),
        [this](std::size_t w, std::size_t b) { return contactlaws::pair_properties(walls[w].side, balls.side[b]); },
        wall_overlap);
    listed_at_ = balls.position;
    listed_walls_ = walls;
    active_.clear();
    for (std::size_t b = 0; b < balls.size(); ++b) {
      if (balls.group[b] < 0 || ball_contacts.has_first(b) || ball_contacts.has_second(b) ||
          wall_contacts.has_second(b))
        active_.push_back(b);
      else
        balls.force[b] = balls.torque[b] = Vec3::Zero();
    }
  }

  // Forces ------------------------------------------------------------------------------------------------------------

  BallMotion ball_motion() const { return {balls, contact_dt}; }
  WallMotion wall_motion() const { return {walls, balls, contact_dt}; }

  void compute_forces(double dt) {
    contact_dt = dt;
    ball_contacts.begin_step();
    wall_contacts.begin_step();
    in_parallel(threads, ball_contacts.size(), ball_contacts.lanes, [this](std::size_t first, std::size_t last) {
      ball_contacts.evaluate(ball_law, ball_motion(), first, last);
    });
    wall_contacts.evaluate(wall_law, wall_motion(), 0, wall_contacts.size());
    in_parallel(threads, active_.size(), 1, [this](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const std::size_t b = active_[i];
        Load load;
        ball_contacts.add_second(b, load);  // the other ball has the lower id: in the order of the list
        ball_contacts.add_first(b, load);
        wall_contacts.add_second(b, load);
        balls.force[b] = load.force.head<3>();
        balls.torque[b] = load.torque.head<3>();
      }
    });
    for (Wall& wall : walls) {
      wall.force = wall.torque = Vec3::Zero();
      wall.normal_force = 0.0;
    }
    for (std::size_t c = 0; c < wall_contacts.size(); ++c)
      walls[wall_contacts.first(c)].add_contact(balls.position[wall_contacts.second(c)], wall_contacts.turning[c].w,
                                                wall_contacts.force[c]);
  }
};

}  // namespace dem
