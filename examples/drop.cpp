// SPDX-License-Identifier: MIT
// A whole discrete element method in one file: balls fall into a box, collide, slide, roll and come to rest.
//
//   drop FOLDER [--balls 100] [--time 0.5]
//
// Writes FOLDER/balls.pvd and contacts.pvd for ParaView (docs/paraview.md), with a .vtp file a frame, and FOLDER/drop.csv.
// Exit status: 0, 2 on a fault, 130 after Ctrl-C. After a fault or Ctrl-C the files of an earlier run are unchanged.
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "common/output_file.hpp"
#include "common/program.hpp"
#include "common/progress.hpp"
#include "common/table.hpp"
#include "common/vtk.hpp"
#include "contactlaws/laws.hpp"

namespace {

using namespace contactlaws;
using Law = DryHill<double>;
using Vector = Vec3<double>;

const ElasticMaterial<double> plastic{1e8, 0.3, 1200.0};  // E [Pa], nu [1], density [kg/m^3]
const Vector gravity(0.0, 0.0, -9.81);                    // [m/s^2]
constexpr double width = 60e-3;                           // of the box, inside [m]
constexpr double skin = 1e-3;                             // pairs with a smaller gap are listed [m]

struct Ball {
  ContactBody<double> body;                // radius, mass, elasticity
  BodyMotion<double> motion;               // position, velocity, spin
  double mass, inertia;                    // [kg], [kg m^2]
  Vector force{0, 0, 0}, torque{0, 0, 0};  // [N], [N m] about the centre
  Vector listed_at{0, 0, 0};               // position when the neighbours were listed [m]
};
struct Wall {
  Vector point, facing;  // facing: unit vector towards the balls
};
struct Contact {
  std::size_t first, second;  // indices of two balls, or of a wall and a ball
  PairProperties<double> pair;
  Step<double, Law::State> step{Vector::Zero(), Vector::Zero(), {}, 0.0, 0.0, 0.0, false, false};  // the last one
};
struct Scene {
  Law law;
  std::vector<Ball> balls;
  std::vector<Wall> walls;
  std::vector<Contact> ball_contacts, wall_contacts;
  Vector force_on_walls{0, 0, 0};  // [N]
  double stored_energy = 0.0;      // in the contacts [J]
};

/// Lists the pairs of balls with a gap below the skin; every pair is tried. A pair that was listed before keeps its state.
void list_neighbours(Scene& scene) {
  std::map<std::pair<std::size_t, std::size_t>, Law::State> states;
  for (const Contact& contact : scene.ball_contacts) states[{contact.first, contact.second}] = contact.step.state;
  scene.ball_contacts.clear();
  for (std::size_t i = 0; i < scene.balls.size(); ++i) {
    Ball& one = scene.balls[i];
    one.listed_at = one.motion.position;
    for (std::size_t j = i + 1; j < scene.balls.size(); ++j) {
      const Ball& two = scene.balls[j];
      const double distance = (two.motion.position - one.motion.position).norm();
      if (distance - one.body.radius - two.body.radius < skin) {
        scene.ball_contacts.push_back({i, j, pair_properties(one.body, two.body)});
        scene.ball_contacts.back().step.state = states[{i, j}];
      }
    }
  }
}

/// Forces and torques on the balls, and the next state of each contact, over a step `dt` [s].
void compute_forces(Scene& scene, double dt) {
  for (Ball& ball : scene.balls) {
    ball.force = ball.mass * gravity;
    ball.torque = Vector::Zero();
  }
  scene.force_on_walls = Vector::Zero();
  scene.stored_energy = 0.0;

  const auto force_on_second = [&scene](Contact& contact, const ContactKinematics<double>& kinematics) {
    contact.step = scene.law.step(contact.pair, kinematics, contact.step.state);
    scene.stored_energy += scene.law.stored_energy(contact.pair, kinematics.overlap, contact.step.state);
    return contact.step.force;
  };
  for (Contact& contact : scene.ball_contacts) {
    Ball &one = scene.balls[contact.first], &two = scene.balls[contact.second];
    const auto geometry = sphere_sphere(one.motion.position, one.body.radius, two.motion.position, two.body.radius);
    const auto kinematics = contact_kinematics(geometry, one.motion, two.motion, dt);
    // Velocities are half a step older than positions, so the relative velocity is turned as the normal turned since.
    const Vector centres = two.motion.velocity - one.motion.velocity;
    const double distance = (two.motion.position - one.motion.position).norm();
    const Vector force = force_on_second(contact, at_full_step(kinematics, centres, distance));
    one.force -= force;
    one.torque -= geometry.arm1.cross(force);
    two.force += force;
    two.torque += geometry.arm2.cross(force);
  }
  for (Contact& contact : scene.wall_contacts) {
    const Wall& wall = scene.walls[contact.first];
    Ball& ball = scene.balls[contact.second];
    const auto geometry = plane_sphere(wall.point, wall.facing, ball.motion.position, ball.body.radius);
    const BodyMotion<double> at_rest{wall.point, Vector::Zero(), Vector::Zero()};
    const Vector force = force_on_second(contact, contact_kinematics(geometry, at_rest, ball.motion, dt));
    scene.force_on_walls -= force;
    ball.force += force;
    ball.torque += geometry.arm2.cross(force);
  }
}

/// A step of velocity Verlet: half a kick, drift, forces, half a kick.
void advance(Scene& scene, double dt) {
  const auto half_a_kick = [&scene, dt] {
    for (Ball& ball : scene.balls) {
      ball.motion.velocity += ball.force * (dt / 2.0 / ball.mass);
      ball.motion.spin += ball.torque * (dt / 2.0 / ball.inertia);
    }
  };
  half_a_kick();
  bool moved_far = false;
  for (Ball& ball : scene.balls) {
    ball.motion.position += ball.motion.velocity * dt;
    moved_far = moved_far || (ball.motion.position - ball.listed_at).norm() > skin / 2.0;
  }
  if (moved_far) list_neighbours(scene);
  compute_forces(scene, dt);
  half_a_kick();
}

/// An open box, and above its floor layers of 4 x 4 balls with gaps between them.
Scene make_scene(int count) {
  DryHillProperties<double> properties;
  properties.friction = 0.4;
  properties.damping_constant = 0.2;
  Scene scene{dry_hill(properties), {}, {}, {}, {}};
  scene.walls.push_back({Vector::Zero(), Vector::UnitZ()});
  for (const Vector& facing : {Vector(1, 0, 0), Vector(-1, 0, 0), Vector(0, 1, 0), Vector(0, -1, 0)})
    scene.walls.push_back({-width / 2.0 * facing, facing});

  std::mt19937 random(1);
  std::uniform_real_distribution<double> radius(4e-3, 6e-3), speed(-0.3, 0.3);  // [m], [m/s]
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const ContactBody<double> body = sphere(plastic, radius(random));
    const double mass = 1.0 / body.inverse_mass;
    const Vector cell(double(i % 4) - 1.5, double(i / 4 % 4) - 1.5, double(i / 16) + 1.0);
    const BodyMotion<double> motion{cell * (width / 4.0), Vector(speed(random), 0.0, 0.0), Vector::Zero()};
    scene.balls.push_back({body, motion, mass, 0.4 * mass * body.radius * body.radius});
    for (std::size_t w = 0; w < scene.walls.size(); ++w)
      scene.wall_contacts.push_back({w, i, pair_properties(plane(plastic), body)});
  }
  list_neighbours(scene);
  compute_forces(scene, 0.0);
  return scene;
}

/// sqrt(m/k)/5 [s], the smallest of all balls, with the stiffness k of a contact that overlaps by a twentieth of the radius.
double safe_time_step(const Scene& scene) {
  double step = 1.0;
  for (const Ball& ball : scene.balls) {
    const auto pair = pair_properties(ball.body, ball.body);
    step = std::min(step, std::sqrt(ball.mass / scene.law.stiffness(pair, ball.body.radius / 20.0, {}).normal));
  }
  return step / 5.0;
}

/// Kinetic, potential and elastic energy [J].
double energy_of(const Scene& scene) {
  double energy = scene.stored_energy;
  for (const Ball& ball : scene.balls) {
    energy -= ball.mass * gravity.dot(ball.motion.position);
    energy +=
        ball.mass * ball.motion.velocity.squaredNorm() / 2.0 + ball.inertia * ball.motion.spin.squaredNorm() / 2.0;
  }
  return energy;
}

common::VtkData balls_for_vtk(const Scene& scene) {
  common::VtkData data;
  auto& diameter = data.scalars["diameter"];
  auto &velocity = data.vectors["velocity"], &force = data.vectors["force"];
  for (const Ball& ball : scene.balls) {
    data.points.push_back(ball.motion.position);
    diameter.push_back(2.0 * ball.body.radius);
    velocity.push_back(ball.motion.velocity);
    force.push_back(ball.force);
  }
  return data;
}

/// Contacts as lines between two centres, or from a wall to a centre. `force` acts on the body at its end.
common::VtkData contacts_for_vtk(const Scene& scene) {
  common::VtkData data;
  data.shape = common::VtkData::Shape::lines;
  auto &normal = data.scalars["normal_force"], &shear = data.scalars["shear_force"], &sliding = data.scalars["sliding"];
  auto& force = data.vectors["force"];
  const auto add = [&](const Contact& contact, const Vector& start) {
    if (!contact.step.active) return;
    data.points.push_back(start);
    data.points.push_back(scene.balls[contact.second].motion.position);
    force.push_back(-contact.step.force);
    force.push_back(contact.step.force);
    normal.insert(normal.end(), 2, contact.step.normal_force);
    shear.insert(shear.end(), 2, contact.step.shear_force.norm());
    sliding.insert(sliding.end(), 2, contact.step.sliding ? 1.0 : 0.0);
  };
  for (const Contact& contact : scene.ball_contacts) add(contact, scene.balls[contact.first].motion.position);
  for (const Contact& contact : scene.wall_contacts) {
    const Wall& wall = scene.walls[contact.first];
    const Vector centre = scene.balls[contact.second].motion.position;
    add(contact, centre - wall.facing * wall.facing.dot(centre - wall.point));
  }
  return data;
}

int run(const std::string& folder_name, int count, double time) {
  const common::InterruptGuard guard;
  common::OutputFolder folder(folder_name);
  common::Progress progress("drop");
  common::Table table{"time_s", "energy_J", "fastest_m_per_s", "force_on_box_N"};
  common::VtkSeries balls, contacts;
  Scene scene = make_scene(count);
  constexpr int frames = 50;
  const int steps = static_cast<int>(std::ceil(time / frames / safe_time_step(scene)));  // from frame to frame
  for (int frame = 0; frame <= frames; ++frame) {
    for (int i = 0; frame > 0 && i < steps; ++i) {
      common::stop_if_requested();
      advance(scene, time / frames / steps);
    }
    double fastest = 0.0;
    for (const Ball& ball : scene.balls) fastest = std::max(fastest, ball.motion.velocity.norm());
    table.add({frame * time / frames, energy_of(scene), fastest, -scene.force_on_walls.z()});
    const std::string name = "_" + std::to_string(10000 + frame).substr(1) + ".vtp";
    balls_for_vtk(scene).write(folder.file("balls" + name));
    contacts_for_vtk(scene).write(folder.file("contacts" + name));
    balls.files.emplace_back(frame * time / frames, "balls" + name);
    contacts.files.emplace_back(frame * time / frames, "contacts" + name);
    progress.at(frame / double(frames));
  }
  balls.write(folder.file("balls.pvd"));
  contacts.write(folder.file("contacts.pvd"));
  table.write_csv(folder.file("drop.csv"));
  folder.complete();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Drops balls into a box and writes their motion for ParaView.", "drop");
  std::string folder;
  int count = 100;
  double time = 0.5;
  app.add_option("FOLDER", folder, "where to write the results")->required();
  app.add_option("--balls", count, "how many (default: 100)")->check(CLI::Range(1, 100000));
  app.add_option("--time", time, "how long to run [s] (default: 0.5)")->check(CLI::Range(1e-3, 1e3));
  return common::run_program(app, argc, argv, [&] { return run(folder, count, time); });
}
