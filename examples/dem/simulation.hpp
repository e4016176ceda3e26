// SPDX-License-Identifier: MIT
// A minimal discrete element method: balls and walls, one contact law between balls and one at walls. One step:
//
//   kick      v += F/m dt      velocities live half a step before the positions (leapfrog; PFC's scheme)
//   drift     x += v dt
//   search    list the neighbours anew, if something moved half a skin since
//   gather    where do the two bodies of each contact meet, and how did they move
//   ask       the contact law for the force
//   scatter   forces and moments to the bodies
//
// Contacts between balls are asked a pack at a time. Each thread asks a share of the contacts, then each adds up the forces on
// a share of the balls: the same bits on any number of threads.
// Nothing here knows a formula of contact: copy this to see how a law is called.
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

/// `BallPack`: how many contacts between balls are asked at once; double for one.
template <class BallLaw, class WallLaw = BallLaw, class BallPack = Pack>
class Simulation {
 public:
  BallLaw ball_law;  ///< between two balls
  WallLaw wall_law;  ///< between a wall (body 1) and a ball (body 2)

  Vec3 gravity = Vec3::Zero();     ///< [m/s^2]
  double local_damping = 0.0;      ///< share of an unbalanced force that opposes motion, in [0, 1); PFC's is 0.7 [1]
  double time_step = 0.0;          ///< [s]; may change from step to step
  double skin = 0.3;               ///< how far neighbours are listed beyond the laws' reach, in smallest radii [1]
  int threads = 1;                 ///< that share the work of a step
  std::ostream* log = &std::clog;  ///< where warnings go

  Balls balls;
  std::vector<Wall> walls;
  Contacts<BallLaw, BallPack> ball_contacts;
  Contacts<WallLaw, double> wall_contacts;  ///< few: asked one at a time
  double time = 0.0;                        ///< [s]
  std::int64_t steps = 0;                   ///< taken so far
  double last_step = 0.0;  ///< [s]; 0 before the first: velocities are then those of the start, not half a step older

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

  /// Advances by time_step. @throws std::invalid_argument if time_step, local_damping or threads is out of range
  void step() {
    contactlaws::require_in(contactlaws::Range::positive(), time_step, "Simulation", "time_step", "s");
    contactlaws::require_in({0.0, 1.0, true, false}, local_damping, "Simulation", "local_damping", "1");
    contactlaws::require_in({1.0, std::numeric_limits<double>::infinity(), true, false}, threads, "Simulation",
                            "threads", "1");
    start();
    // The kick goes from the middle of the last step to the middle of this one.
    const bool far = move((last_step + time_step) / 2.0, time_step);
    last_step = time_step;
    time += time_step;
    ++steps;
    if (far) list_neighbours();
    find_forces(time_step);
  }

  /// Lists neighbours and finds the forces of a scene as it stands; no time passes, so no history moves. A step begins
  /// with this where bodies were added.
  void start() {
    if (started_) return;
    started_ = true;
    list_neighbours();
    find_forces(0.0);
    if (log == nullptr) return;
    for (std::size_t c = 0; c < ball_contacts.size(); ++c)
      warn_of_overlap(ball_contacts, "ball", c, ball_contact(c).geometry.overlap);
    for (std::size_t c = 0; c < wall_contacts.size(); ++c)
      warn_of_overlap(wall_contacts, "wall", c, wall_contact(c).geometry.overlap);
  }

  /// A contact at the last step: where, how it moved, and all that the law said. Bodies must be as that step left them.
  Look<double, typename BallLaw::State> ball_contact(std::size_t contact) const {
    return ball_contacts.look(ball_law, balls_meet(), contact);
  }
  Look<double, typename WallLaw::State> wall_contact(std::size_t contact) const {
    return wall_contacts.look(wall_law, wall_meets_ball(), contact);
  }

 private:
  using Vec4 = Eigen::Vector4d;

  bool started_ = false;
  double last_dt_ = 0.0;        ///< over which contacts were last asked to move [s]
  double margin_ = 0.0;         ///< how far neighbours were listed beyond the laws' reach [m]
  std::vector<Row> listed_at_;  ///< where balls, then walls, were when neighbours were listed [m]

  static std::size_t checked_id(int id, std::size_t count, const char* kind) {
    contactlaws::require_in({0.0, static_cast<double>(count), true, false}, id, "Simulation", kind, "1");
    return static_cast<std::size_t>(id);
  }

  /// A line for two bodies that overlap by more than a tenth of the smaller radius.
  template <class Contacts>
  void warn_of_overlap(const Contacts& contacts, const char* first_kind, std::size_t c, double overlap) const {
    const double allowed = contacts.template pair_at<double>(c).min_radius / 10.0;
    if (overlap > allowed)
      *log << "warning: " << first_kind << ' ' << contacts.first(c) << " and ball " << contacts.second(c)
           << " start with an overlap of " << overlap << " m, more than a tenth of the smaller radius (" << allowed
           << " m)\n";
  }

  // Motion ------------------------------------------------------------------------------------------------------------

  /// Kicks the velocities over `kick` and lets the positions drift over `drift` [s]. Whether a body is now half a margin away
  /// from where neighbours were listed.
  bool move(double kick, double drift) {
    const double allowed = margin_ * margin_ / 4.0;
    std::atomic<bool> far{false};
    const Vec4 acceleration(gravity.x(), gravity.y(), gravity.z(), 0.0);
    in_parallel(threads, balls.size(), 1, [&, this](std::size_t first, std::size_t last) {
      for (std::size_t b = first; b < last; ++b) {
        auto position = balls.position[b].four(), velocity = balls.velocity[b].four(), spin = balls.spin[b].four();
        if (balls.free[b]) {
          const Vec4 force = balls.force[b].four() + balls.mass[b] * acceleration;
          velocity += damped(force, velocity) * (kick / balls.mass[b]);
          spin += damped(balls.moment[b].four(), spin) * (kick / balls.inertia[b]);
        }
        position += velocity * drift;
        if ((position - listed_at_[b].four()).squaredNorm() > allowed) far = true;
      }
    });
    for (std::size_t w = 0; w < walls.size(); ++w) {
      walls[w].point += walls[w].velocity * drift;
      if ((walls[w].point - listed_at_[balls.size() + w]).squaredNorm() > allowed) far = true;
    }
    return far;
  }

  /// What local damping leaves of an unbalanced force or moment F: F - alpha |F| sign(v), per component (Itasca).
  Vec4 damped(const Vec4& load, const Vec4& velocity) const {
    if (!(local_damping > 0.0)) return load;
    Vec4 left = load;
    for (int i = 0; i < 3; ++i) {
      if (velocity[i] > 0.0) left[i] -= local_damping * std::abs(load[i]);
      if (velocity[i] < 0.0) left[i] += local_damping * std::abs(load[i]);
    }
    return left;
  }

  // Neighbours --------------------------------------------------------------------------------------------------------

  void list_neighbours() {
    margin_ = balls.size() > 0 ? skin * *std::min_element(balls.radius.begin(), balls.radius.end()) : 0.0;
    std::vector<double> reach(balls.size());  // a law's range is taken to grow with the smaller radius of the pair
    std::vector<Pair> at_walls;
    for (std::size_t b = 0; b < balls.size(); ++b) {
      reach[b] = ball_law.interaction_range(twins(balls.side[b])) + margin_;
      const double reach_of_wall = wall_law.interaction_range(twins(balls.side[b])) + margin_;
      for (std::size_t w = 0; w < walls.size(); ++w)
        if (-wall_meets_ball().overlap(w, b) <= reach_of_wall)
          at_walls.push_back({static_cast<int>(w), static_cast<int>(b)});
    }
    ball_contacts.list(
        ball_law, find_neighbours(balls.position, balls.radius, reach), margin_, balls.size(), balls.size(),
        [this](std::size_t i, std::size_t j) { return contactlaws::pair_properties(balls.side[i], balls.side[j]); },
        [this](std::size_t i, std::size_t j) { return balls_meet().overlap(i, j); });
    wall_contacts.list(
        wall_law, at_walls, margin_, walls.size(), balls.size(),
        [this](std::size_t w, std::size_t b) { return contactlaws::pair_properties(walls[w].side, balls.side[b]); },
        [this](std::size_t w, std::size_t b) { return wall_meets_ball().overlap(w, b); });
    listed_at_ = balls.position;
    for (const Wall& wall : walls) listed_at_.push_back(wall.point);
  }

  // Forces ------------------------------------------------------------------------------------------------------------

  BallsMeet balls_meet() const { return {balls, last_dt_}; }
  WallMeetsBall wall_meets_ball() const { return {walls, balls, last_dt_}; }

  void find_forces(double dt) {
    last_dt_ = dt;
    ball_contacts.begin_step();
    wall_contacts.begin_step();
    in_parallel(threads, ball_contacts.size(), lanes<BallPack>, [this](std::size_t first, std::size_t last) {
      ball_contacts.ask(ball_law, balls_meet(), first, last);
    });
    wall_contacts.ask(wall_law, wall_meets_ball(), 0, wall_contacts.size());
    in_parallel(threads, balls.size(), 1, [this](std::size_t first, std::size_t last) {
      for (std::size_t b = first; b < last; ++b) {
        Load load;
        ball_contacts.add_second(b, load);  // the other ball has the lower id: in the order of the list
        ball_contacts.add_first(b, load);
        wall_contacts.add_second(b, load);
        balls.force[b].four() = load.force;
        balls.moment[b].four() = load.moment(balls.radius[b]);
      }
    });
    for (std::size_t w = 0; w < walls.size(); ++w) {
      Load load;
      wall_contacts.add_first(w, load);
      walls[w].force = load.force.head<3>();
    }
  }
};

}  // namespace dem
