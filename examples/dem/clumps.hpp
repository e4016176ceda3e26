// SPDX-License-Identifier: MIT
// Clumps: rigid bodies of overlapping spheres (pebbles). The pebbles are balls of a scene that their clump moves. One step:
//
//   kick      V += F/m dt,  L += M dt          V, L, w half a step behind X, q (leapfrog)
//   drift     X += V dt,  q turns by w dt      w = J(q at half the step)^-1 L   (Fincham 1992)
//   place     x = X + a,  v = V + w x a        of each pebble; a is its arm, turned by q
//   forces    those of the scene (simulation.hpp)
//   sum       F = sum f,  M = sum (m + a x f)
//
// L is kept in the frame of space, so that a free clump keeps it to rounding. Only pebbles with listed contacts are placed and
// summed; all are placed before neighbours are listed.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "clump_shape.hpp"
#include "simulation.hpp"

namespace dem {

struct Clump {
  Vec3 position;                 ///< of the centre of mass, at the time of the scene [m]
  Vec3 velocity = Vec3::Zero();  ///< half a step earlier [m/s]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< of the principal axes, at the time of the scene
  Vec3 angular_momentum = Vec3::Zero();                             ///< half a step earlier [kg m^2/s]
  Vec3 spin = Vec3::Zero();                                         ///< half a step earlier [rad/s]
  Vec3 force = Vec3::Zero();                                        ///< of all contacts [N]
  Vec3 torque = Vec3::Zero();                                       ///< of all contacts, about the centre of mass [N m]
  double mass = 0.0;                                                ///< [kg]
  Vec3 inertia = Vec3::Zero();                                      ///< principal moments of inertia [kg m^2]
  double reach = 0.0;               ///< largest distance of the surface from the centre [m]
  bool free = true;                 ///< whether forces move it
  std::size_t first = 0, last = 0;  ///< its pebbles are the balls first .. last - 1

  double kinetic_energy() const { return 0.5 * (mass * velocity.squaredNorm() + spin.dot(angular_momentum)); }
  /// Whether no point of the clump is farther than `allowed` [m] from where it was `then`.
  bool is_near(const Clump& then, double allowed) const {
    const double turn = 2.0 * (orientation * then.orientation.conjugate()).vec().norm();  // a chord of the unit circle
    return (position - then.position).norm() + turn * reach <= allowed;
  }
};

class Clumps {
 public:
  std::vector<Clump> all;

  std::size_t size() const { return all.size(); }

  /// Adds a clump of this material, at `where` [m], and its pebbles to the scene. The mass of a pebble, which enters m* of its
  /// contacts and so their dashpots, is that of the clump times `mass_share`. 1 is right where a clump touches another body with
  /// one pebble; where n pebbles touch at once, as a flat face does, 1/n gives the restitution that the law was asked for
  /// (tests/dem/test_clumps.cpp). Laws without dashpots do not read it. Returns the clump's id.
  template <class Scene>
  int add(Scene& scene, const ClumpShape& shape, const contactlaws::ElasticMaterial<double>& material,
          const Vec3& where, const Eigen::Quaterniond& orientation = Eigen::Quaterniond::Identity(),
          double mass_share = 1.0) {
    Clump clump;
    clump.position = where;
    clump.orientation = orientation;
    clump.mass = shape.volume * material.density;
    clump.inertia = shape.inertia * material.density;
    clump.reach = shape.reach;
    clump.first = scene.balls.size();
    clump.last = clump.first + shape.pebbles.size();
    const int id = static_cast<int>(size());
    for (const Pebble& pebble : shape.pebbles) {
      const auto side = contactlaws::sphere(material, pebble.radius).with_mass(clump.mass * mass_share);
      scene.add(Ball{side, where + orientation * pebble.centre, Vec3::Zero(), Vec3::Zero(), false, id});
      arm_.resize(scene.balls.size());
      arm_.back() = pebble.centre;
    }
    all.push_back(clump);
    listing_ = -1;
    return id;
  }

  /// From now on the clump moves at this velocity [m/s] and spin [rad/s] (of its frame of space).
  void set_motion(std::size_t clump, const Vec3& velocity, const Vec3& spin) {
    Clump& c = all[clump];
    const Eigen::Matrix3d axes = c.orientation.toRotationMatrix();
    c.velocity = velocity;
    c.spin = spin;
    c.angular_momentum = axes * c.inertia.cwiseProduct(axes.transpose() * spin);
  }
  void stop() {
    for (Clump& c : all) c.velocity = c.spin = c.angular_momentum = Vec3::Zero();
  }

  /// Advances the scene and its clumps by the scene's time step. @throws as Simulation::step()
  template <class Scene>
  void step(Scene& scene) {
    start(scene);
    const double kick = scene.kick(), drift = scene.time_step;
    const bool others_moved_far = scene.begin_step(), moved_far = move(scene, kick, drift) || others_moved_far;
    if (moved_far) place_all(scene);
    scene.finish_step(moved_far);
    sum_forces(scene);
  }

  /// The parts of a step that are not the scene's. Moves clumps and active pebbles; whether a clump has moved far enough for
  /// neighbours to be listed anew.
  template <class Scene>
  bool move(Scene& scene, double kick, double drift) {
    bool moved_far = false;
    for (std::size_t i = 0; i < size(); ++i) {
      move(all[i], scene, kick, drift);
      moved_far = moved_far || !all[i].is_near(listed_[i], scene.allowed_motion());
      place(scene, all[i], active_.begin() + start_[i], active_.begin() + start_[i + 1]);
    }
    return moved_far;
  }
  template <class Scene>
  void sum_forces(const Scene& scene) {
    using Vector = contactlaws::PlainVec3<double>;  // GCC 12 stores Eigen's cross product and waits to load it again
    if (listing_ != scene.listings) note_listing(scene);
    for (std::size_t i = 0; i < size(); ++i) {
      Clump& c = all[i];
      const Vector centre = c.position;
      Vector force(0.0, 0.0, 0.0), torque = force;
      for (std::ptrdiff_t k = start_[i]; k < start_[i + 1]; ++k) {
        const std::size_t b = active_[static_cast<std::size_t>(k)];
        const Vector on_pebble = scene.balls.force[b], arm = Vector(scene.balls.position[b]) - centre;
        force += on_pebble;
        torque += Vector(scene.balls.torque[b]) + arm.cross(on_pebble);
      }
      c.force = force;
      c.torque = torque;
    }
  }

  /// Places all pebbles and computes the forces of the bodies as they are; no time passes. step() begins with it where needed.
  template <class Scene>
  void start(Scene& scene) {
    if (listing_ >= 0) return;
    place_all(scene);
    scene.start();
    sum_forces(scene);
  }
  /// After positions were changed by hand, or a scene was restored: neighbours are listed anew.
  template <class Scene>
  void resume(Scene& scene) {
    place_all(scene);
    scene.resume();
    note_listing(scene);
  }

  /// From now on each step places these pebbles too, whether or not they have listed contacts in this scene.
  template <class Scene>
  void keep_placed(const Scene& scene, const std::vector<std::size_t>& pebbles) {
    kept_.assign(scene.balls.size(), 0);
    for (const std::size_t b : pebbles) kept_[b] = 1;
    if (listing_ >= 0) list_active(scene);
  }
  /// Writes position, velocity and spin of all pebbles: a step writes only those that may touch something.
  template <class Scene>
  void place_all(Scene& scene) const {
    std::vector<std::size_t> ids;
    for (const Clump& c : all) {
      ids.clear();
      for (std::size_t b = c.first; b < c.last; ++b) ids.push_back(b);
      place(scene, c, ids.cbegin(), ids.cend());
    }
  }

 private:
  std::vector<Row> arm_;               ///< of each ball, from the centre of its clump, in the frame of the clump [m]
  std::vector<char> kept_;             ///< whether each ball is placed in any case
  std::vector<std::size_t> active_;    ///< pebbles with listed contacts, and those kept placed, by clump
  std::vector<std::ptrdiff_t> start_;  ///< those of clump i are active_[start_[i]] to before active_[start_[i + 1]]
  std::vector<Clump> listed_;          ///< as they were when neighbours were listed
  std::int64_t listing_ = -1;          ///< the scene's number of listings then; -1 before the first

  /// q turned by a small `turn` [rad]: to second order, and a unit quaternion.
  static Eigen::Quaterniond turned(const Eigen::Quaterniond& q, const Vec3& turn) {
    const Vec3 half = turn / 2.0;
    return (Eigen::Quaterniond(1.0, half.x(), half.y(), half.z()) * q).normalized();
  }
  static Vec3 spin_of(const Clump& c, const Eigen::Matrix3d& axes) {
    return axes * (axes.transpose() * c.angular_momentum).cwiseQuotient(c.inertia);
  }

  template <class Scene>
  static void move(Clump& c, const Scene& scene, double kick, double drift) {
    const bool is_round = c.inertia.x() == c.inertia.z();  // a single pebble then moves as a ball does, to the bit
    if (c.free) {
      const Vec3 force = c.force + c.mass * scene.gravity;
      c.velocity += scene.damped(force, c.velocity) * (kick / c.mass);
      const Vec3 torque = scene.damped(c.torque, c.spin);
      c.angular_momentum += torque * kick;
      if (is_round) c.spin += torque * (kick / c.inertia.x());
    }
    c.position += c.velocity * drift;
    if (!is_round && c.free) {
      const Vec3 before = spin_of(c, c.orientation.toRotationMatrix());
      c.spin = spin_of(c, turned(c.orientation, before * (drift / 2.0)).toRotationMatrix());
    }
    c.orientation = turned(c.orientation, c.spin * drift);
  }

  template <class Scene, class Ids>
  void place(Scene& scene, const Clump& c, Ids ids, const Ids& end) const {
    // Position and velocity are linear in the arm in the frame of the clump: X + A arm, and V + w x (A - w x A dt/2) arm.
    const auto row = [](const Vec3& v) { return Eigen::Vector4d(v.x(), v.y(), v.z(), 0.0); };
    const Eigen::Matrix3d axes = c.orientation.toRotationMatrix();
    std::array<Eigen::Vector4d, 3> turned_arm, turning;
    for (int i = 0; i < 3; ++i) {
      const Vec3 axis = axes.col(i);
      const Vec3 half_a_step_ago = axis - c.spin.cross(axis) * (scene.last_step / 2.0);
      turned_arm[static_cast<std::size_t>(i)] = row(axis);
      turning[static_cast<std::size_t>(i)] = row(c.spin.cross(half_a_step_ago));
    }
    const Eigen::Vector4d centre = row(c.position), velocity = row(c.velocity), spin = row(c.spin);
    for (; ids != end; ++ids) {
      const std::size_t b = *ids;
      const Row& arm = arm_[b];
      const Eigen::Vector4d place =
          centre + (turned_arm[0] * arm.x() + turned_arm[1] * arm.y() + turned_arm[2] * arm.z());
      scene.balls.position[b] = place.head<3>();  // w, the radius, keeps its value
      scene.balls.velocity[b].all() = velocity + (turning[0] * arm.x() + turning[1] * arm.y() + turning[2] * arm.z());
      scene.balls.spin[b].all() = spin;
    }
  }
  template <class Scene>
  void note_listing(const Scene& scene) {
    listing_ = scene.listings;
    listed_ = all;
    list_active(scene);
  }
  template <class Scene>
  void list_active(const Scene& scene) {
    std::vector<char> touched = kept_;
    touched.resize(scene.balls.size(), 0);
    for (std::size_t c = 0; c < scene.ball_contacts.size(); ++c)
      touched[scene.ball_contacts.first(c)] = touched[scene.ball_contacts.second(c)] = 1;
    for (std::size_t c = 0; c < scene.wall_contacts.size(); ++c) touched[scene.wall_contacts.second(c)] = 1;
    active_.clear();
    start_ = {0};
    for (const Clump& clump : all) {
      for (std::size_t b = clump.first; b < clump.last; ++b)
        if (touched[b]) active_.push_back(b);
      start_.push_back(static_cast<std::ptrdiff_t>(active_.size()));
    }
  }
};

}  // namespace dem
