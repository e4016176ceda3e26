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
// Nothing here knows a formula of contact: copy this to see how a law is called.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <vector>

#include "contacts.hpp"
#include "walls.hpp"

namespace dem {

template <class BallLaw, class WallLaw = BallLaw>
class Simulation {
 public:
  BallLaw ball_law;  ///< between two balls
  WallLaw wall_law;  ///< between a wall (body 1) and a ball (body 2)

  Vec3 gravity = Vec3::Zero();     ///< [m/s^2]
  double local_damping = 0.0;      ///< share of an unbalanced force that opposes motion, in [0, 1); PFC's is 0.7 [1]
  double time_step = 0.0;          ///< [s]; may change from step to step
  double skin = 0.3;               ///< how far neighbours are listed beyond the laws' reach, in smallest radii [1]
  std::ostream* log = &std::clog;  ///< where warnings go

  Balls balls;
  std::vector<Wall> walls;
  Contacts<BallLaw> ball_contacts;
  Contacts<WallLaw> wall_contacts;
  double time = 0.0;       ///< [s]
  std::int64_t steps = 0;  ///< taken so far
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

  /// Advances by time_step. @throws std::invalid_argument if time_step or local_damping is out of range
  void step() {
    contactlaws::require_in(contactlaws::Range::positive(), time_step, "Simulation", "time_step", "s");
    contactlaws::require_in({0.0, 1.0, true, false}, local_damping, "Simulation", "local_damping", "1");
    start();
    kick((last_step + time_step) / 2.0);  // from the middle of the last step to the middle of this one
    drift(time_step);
    last_step = time_step;
    time += time_step;
    ++steps;
    if (farthest_move() > margin_ / 2.0) list_neighbours();
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
    warn_of_overlaps(ball_contacts, "ball", *log);
    warn_of_overlaps(wall_contacts, "wall", *log);
  }

 private:
  bool started_ = false;
  double margin_ = 0.0;          ///< how far neighbours were listed beyond the laws' reach [m]
  std::vector<Vec3> listed_at_;  ///< where balls, then walls, were when neighbours were listed [m]

  static std::size_t checked_id(int id, std::size_t count, const char* kind) {
    contactlaws::require_in({0.0, static_cast<double>(count), true, false}, id, "Simulation", kind, "1");
    return static_cast<std::size_t>(id);
  }

  // Motion ------------------------------------------------------------------------------------------------------------

  void kick(double dt) {
    for (std::size_t b = 0; b < balls.size(); ++b) {
      if (!balls.free[b]) continue;
      const Vec3 force = balls.force[b] + balls.mass[b] * gravity;
      balls.velocity[b] += damped(force, balls.velocity[b]) * (dt / balls.mass[b]);
      balls.spin[b] += damped(balls.moment[b], balls.spin[b]) * (dt / balls.inertia[b]);
    }
  }

  /// What local damping leaves of an unbalanced force or moment F: F - alpha |F| sign(v), per component (Itasca).
  Vec3 damped(const Vec3& load, const Vec3& velocity) const {
    Vec3 left = load;
    for (int i = 0; i < 3; ++i) {
      if (velocity[i] > 0.0) left[i] -= local_damping * std::abs(load[i]);
      if (velocity[i] < 0.0) left[i] += local_damping * std::abs(load[i]);
    }
    return left;
  }

  void drift(double dt) {
    for (std::size_t b = 0; b < balls.size(); ++b) balls.position[b] += balls.velocity[b] * dt;
    for (Wall& wall : walls) wall.point += wall.velocity * dt;
  }

  // Neighbours --------------------------------------------------------------------------------------------------------

  double farthest_move() const {
    double square = 0.0;
    for (std::size_t b = 0; b < balls.size(); ++b)
      square = std::max(square, (balls.position[b] - listed_at_[b]).squaredNorm());
    for (std::size_t w = 0; w < walls.size(); ++w)
      square = std::max(square, (walls[w].point - listed_at_[balls.size() + w]).squaredNorm());
    return std::sqrt(square);
  }

  void list_neighbours() {
    margin_ = balls.size() > 0 ? skin * *std::min_element(balls.radius.begin(), balls.radius.end()) : 0.0;
    std::vector<double> reach(balls.size());  // a law's range is taken to grow with the smaller radius of the pair
    std::vector<Pair> at_walls;
    for (std::size_t b = 0; b < balls.size(); ++b) {
      reach[b] = ball_law.interaction_range(twins(balls.side[b])) + margin_;
      const double reach_of_wall = wall_law.interaction_range(twins(balls.side[b])) + margin_;
      for (std::size_t w = 0; w < walls.size(); ++w)
        if (-meet_wall(w, b).overlap <= reach_of_wall) at_walls.push_back({static_cast<int>(w), static_cast<int>(b)});
    }
    ball_contacts.list(
        ball_law, find_neighbours(balls.position, balls.radius, reach), margin_,
        [this](std::size_t i, std::size_t j) { return contactlaws::pair_properties(balls.side[i], balls.side[j]); },
        [this](std::size_t i, std::size_t j) { return meet_balls(i, j); });
    wall_contacts.list(
        wall_law, at_walls, margin_,
        [this](std::size_t w, std::size_t b) { return contactlaws::pair_properties(walls[w].side, balls.side[b]); },
        [this](std::size_t w, std::size_t b) { return meet_wall(w, b); });
    listed_at_ = balls.position;
    for (const Wall& wall : walls) listed_at_.push_back(wall.point);
  }

  // Forces ------------------------------------------------------------------------------------------------------------

  contactlaws::ContactGeometry<double> meet_balls(std::size_t i, std::size_t j) const {
    return contactlaws::meet_spheres(balls.position[i], balls.radius[i], balls.position[j], balls.radius[j]);
  }
  contactlaws::ContactGeometry<double> meet_wall(std::size_t w, std::size_t b) const {
    return contactlaws::meet_plane(walls[w].point, walls[w].facing, balls.position[b], balls.radius[b]);
  }

  void find_forces(double dt) {
    gather(dt);
    ball_contacts.ask(ball_law);
    wall_contacts.ask(wall_law);
    scatter();
  }

  void gather(double dt) {
    for (std::size_t c = 0; c < ball_contacts.size(); ++c) {
      const std::size_t i = ball_contacts.first(c), j = ball_contacts.second(c);
      const auto geometry = meet_balls(i, j);
      const auto motion = contactlaws::contact_kinematics(geometry, balls.motion(i), balls.motion(j), dt);
      ball_contacts.geometry[c] = geometry;
      ball_contacts.motion[c] = at_full_step(motion, balls.velocity[j] - balls.velocity[i],
                                             balls.radius[i] + balls.radius[j] - geometry.overlap);
    }
    for (std::size_t c = 0; c < wall_contacts.size(); ++c) {
      const std::size_t w = wall_contacts.first(c), b = wall_contacts.second(c);
      wall_contacts.geometry[c] = meet_wall(w, b);
      wall_contacts.motion[c] =
          contactlaws::contact_kinematics(wall_contacts.geometry[c], walls[w].motion(), balls.motion(b), dt);
    }
  }

  void scatter() {
    for (std::size_t b = 0; b < balls.size(); ++b) balls.force[b] = balls.moment[b] = Vec3::Zero();
    for (Wall& wall : walls) wall.force = Vec3::Zero();
    for (std::size_t c = 0; c < ball_contacts.size(); ++c) {
      if (!ball_contacts.response[c].active) continue;
      const Vec3& force = ball_contacts.response[c].force;
      push(ball_contacts.first(c), ball_contacts.geometry[c].arm1, -force);
      push(ball_contacts.second(c), ball_contacts.geometry[c].arm2, force);
    }
    for (std::size_t c = 0; c < wall_contacts.size(); ++c) {
      if (!wall_contacts.response[c].active) continue;
      const Vec3& force = wall_contacts.response[c].force;
      walls[wall_contacts.first(c)].force -= force;
      push(wall_contacts.second(c), wall_contacts.geometry[c].arm2, force);
    }
  }

  void push(std::size_t ball, const Vec3& arm, const Vec3& force) {
    balls.force[ball] += force;
    balls.moment[ball] += arm.cross(force);
  }
};

}  // namespace dem
