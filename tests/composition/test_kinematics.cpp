#include "contactlaws/kinematics.hpp"
#include "make_laws.hpp"

#include "catch.hpp"
#include "contactlaws/laws.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

using Vector = Vec3<double>;
constexpr double eps = std::numeric_limits<double>::epsilon();

BodyMotion<double> random_body(Random& random, const Vector& position) {
  return {position, random.log_uniform(1e-3, 10) * random.direction(),
          random.log_uniform(1e-3, 1e3) * random.direction()};
}

}  // namespace

TEST_CASE("Kinematics: the normal points from body 1 to body 2, the contact point is the middle of the overlap") {
  const ContactGeometry<double> g = sphere_sphere<double>({1, 1, 1}, 2.0, {1, 1, 4.5}, 1.75);
  CHECK(g.normal == Vector(0, 0, 1));
  CHECK(g.overlap == 0.25);
  CHECK(g.arm1 == Vector(0, 0, 1.875));   // R1 - o/2
  CHECK(g.arm2 == Vector(0, 0, -1.625));  // R2 - o/2, back towards body 1
  const ContactGeometry<double> apart = sphere_sphere<double>({0, 0, 0}, 1.0, {3, 0, 0}, 1.0);
  CHECK(apart.overlap == -1.0);  // a gap
  CHECK(apart.arm1 == Vector(1.5, 0, 0));
}

TEST_CASE("Kinematics: a plane and a sphere") {
  const ContactGeometry<double> g = plane_sphere<double>({5, 5, 0}, {0, 0, 1}, {7, 5, 0.75}, 1.0);
  CHECK(g.normal == Vector(0, 0, 1));
  CHECK(g.overlap == 0.25);
  CHECK(g.arm2 == Vector(0, 0, -0.875));
  CHECK(g.arm1 == Vector(2, 0, -0.125));  // from the plane's point to the middle of the overlap
}

TEST_CASE("Kinematics: separating is positive, and the sign of omega x r is that of a rolling wheel") {
  const ContactGeometry<double> g = plane_sphere<double>({0, 0, 0}, {0, 0, 1}, {0, 0, 1.0}, 1.0);
  const BodyMotion<double> ground{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  const auto velocity = [&](const Vector& v, const Vector& spin) {
    return contact_kinematics(g, ground, BodyMotion<double>{{0, 0, 1}, v, spin}, 1e-3).velocity;
  };
  CHECK(velocity({0, 0, 2}, {0, 0, 0}).dot(g.normal) == 2.0);  // lifts off
  CHECK(velocity({3, 0, 0}, {0, 3, 0}) == Vector(0, 0, 0));    // rolls along x: spins about +y
  CHECK(velocity({3, 0, 0}, {0, -3, 0}) == Vector(6, 0, 0));   // spins backwards
  CHECK(velocity({0, 3, 0}, {-3, 0, 0}) == Vector(0, 0, 0));   // rolls along y: spins about -x
}

TEST_CASE("Kinematics: spin is the mean about the normal") {
  const ContactGeometry<double> g = sphere_sphere<double>({0, 0, 0}, 1.0, {0, 1.9, 0}, 1.0);
  const BodyMotion<double> a{{0, 0, 0}, {0, 0, 0}, {7, 2, 5}}, b{{0, 1.9, 0}, {0, 0, 0}, {1, 4, 9}};
  CHECK(contact_kinematics(g, a, b, 0.5).normal_spin == 3.0);
  CHECK(contact_kinematics(g, a, b, 0.5).dt == 0.5);
}

TEST_CASE("Kinematics: seen from either body, one contact") {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const double radius1 = random.log_uniform(1e-3, 1.0), radius2 = random.log_uniform(1e-3, 1.0);
    const Vector x1 = random.direction();
    const Vector x2 = x1 + (radius1 + radius2) * random.uniform(0.9, 1.1) * random.direction();
    const ContactGeometry<double> here = sphere_sphere(x1, radius1, x2, radius2);
    const ContactGeometry<double> there = sphere_sphere(x2, radius2, x1, radius1);
    CHECK(there.normal == -here.normal);
    CHECK(there.overlap == here.overlap);
    CHECK(there.arm1 == here.arm2);
    CHECK(there.arm2 == here.arm1);
    // Both arms end at the same point: 4 roundings of the coordinates.
    CHECK((x1 + here.arm1 - x2 - here.arm2).norm() <= 4 * eps * (x1.norm() + x2.norm() + radius1 + radius2));

    const BodyMotion<double> a = random_body(random, x1), b = random_body(random, x2);
    const ContactKinematics<double> ab = contact_kinematics(here, a, b, 1e-6),
                                    ba = contact_kinematics(there, b, a, 1e-6);
    CHECK(ba.velocity == -ab.velocity);
    CHECK(ba.normal_spin == -ab.normal_spin);
  }
}

TEST_CASE("Kinematics: spheres from a host's arrays are the same contact, with the same torques") {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const double radius1 = random.log_uniform(1e-3, 1.0), radius2 = random.log_uniform(1e-3, 1.0);
    const Vector x1 = random.direction();
    const Vector x2 = x1 + (radius1 + radius2) * random.uniform(0.9, 1.1) * random.direction();
    const BodyMotion<double> a = random_body(random, x1), b = random_body(random, x2);
    const ContactGeometry<double> geometry = sphere_sphere(x1, radius1, x2, radius2);
    const auto expected = contact_kinematics(geometry, a, b, 1e-6);
    const auto contact = sphere_contact(a.position.data(), a.velocity.data(), a.spin.data(), radius1, b.position.data(),
                                        b.velocity.data(), b.spin.data(), radius2, 1e-6);
    const auto& k = contact.kinematics;
    // Coordinates of size |x| are rounded once, normals twice more.
    const double distance = contact.distance, size = x1.norm() + x2.norm() + radius1 + radius2;
    CHECK((k.normal - expected.normal).norm() <= 4 * eps);
    CHECK(std::abs(k.overlap - expected.overlap) <= 4 * eps * size);
    CHECK(std::abs(distance - (x2 - x1).norm()) <= 2 * eps * size);
    const double speeds = a.velocity.norm() + b.velocity.norm() + (a.spin.norm() * radius1 + b.spin.norm() * radius2);
    CHECK((k.velocity - expected.velocity).norm() <= 16 * eps * speeds);
    CHECK(std::abs(k.normal_spin - expected.normal_spin) <= 8 * eps * (a.spin.norm() + b.spin.norm()));
    CHECK(k.relative_spin == expected.relative_spin);
    CHECK(k.dt == 1e-6);
    CHECK((k.normal * contact.arm1 - geometry.arm1).norm() <= 8 * eps * size);
    CHECK((k.normal * -contact.arm2 - geometry.arm2).norm() <= 8 * eps * size);

    const Vector force = random.direction(), couple = random.direction();
    const Torques<double> torque = torques(contact, force, couple);
    CHECK((torque.on1 - (geometry.arm1.cross(-force) - couple)).norm() <= 16 * eps * (size + 1));
    CHECK((torque.on2 - (geometry.arm2.cross(force) + couple)).norm() <= 16 * eps * (size + 1));
  }
}

TEST_CASE("Kinematics: a sphere of radius 0 at the nearest point of a wall is the wall") {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const double radius = random.log_uniform(1e-3, 1.0);
    const Vector facing = random.direction(), point = random.direction();
    const Vector x2 = point + radius * random.uniform(0.9, 1.1) * facing;
    const BodyMotion<double> wall{point, random.direction(), {0, 0, 0}}, body = random_body(random, x2);
    const ContactGeometry<double> geometry = plane_sphere<double>(point, facing, x2, radius);
    const auto expected = contact_kinematics(geometry, wall, body, 1e-6);
    const auto contact = sphere_contact(point.data(), wall.velocity.data(), wall.spin.data(), 0.0, x2.data(),
                                        body.velocity.data(), body.spin.data(), radius, 1e-6);
    // Coordinates of size 1 + radius are rounded, and give the direction over a distance of 0.9 radius or more.
    const double size = 1 + radius, turned = 8 * eps * size / radius;
    CHECK((contact.kinematics.normal - facing).norm() <= turned);
    CHECK(std::abs(contact.kinematics.overlap - geometry.overlap) <= 8 * eps * size);
    CHECK((contact.kinematics.velocity - expected.velocity).norm() <=
          (turned + 16 * eps) * (wall.velocity.norm() + body.velocity.norm() + body.spin.norm() * radius));
    CHECK((contact.kinematics.normal * -contact.arm2 - geometry.arm2).norm() <= 2 * turned * radius);
  }
}

TEST_CASE("Kinematics: forces and torques of a pair balance") {
  Random random;
  const DryHill<double> law = test::dry_hill<double>(0.4, 0.3);
  for (int i = 0; i < 1000; ++i) {
    const double radius1 = 7.5e-3, radius2 = 5e-3;
    const Vector x1 = 0.1 * random.direction(), x2 = x1 + 12.4e-3 * random.direction();
    const ContactGeometry<double> g = sphere_sphere(x1, radius1, x2, radius2);
    const auto kinematics = contact_kinematics(g, random_body(random, x1), random_body(random, x2), 1e-6);
    const Vector force = law.step(granite_pair<double>(), kinematics, {}).force;
    REQUIRE(force.norm() > 0.0);
    // Body 2 gets the force and its torque, body 1 the opposite force: no net moment about the origin.
    const Vector moment = x2.cross(force) + g.arm2.cross(force) + x1.cross(-force) + g.arm1.cross(-force);
    CHECK(moment.norm() <= 16 * eps * 0.2 * force.norm());
  }
}

TEST_CASE("Kinematics: bodies that move as one rigid body do not move relative to each other") {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Vector x1 = random.direction(), x2 = x1 + 0.195 * random.direction();
    const Vector spin = 100 * random.direction(), velocity = random.direction();
    const auto rigid = [&](const Vector& x) { return BodyMotion<double>{x, velocity + spin.cross(x), spin}; };
    const ContactGeometry<double> g = sphere_sphere(x1, 0.1, x2, 0.1);
    const ContactKinematics<double> k = contact_kinematics(g, rigid(x1), rigid(x2), 1e-6);
    CHECK(k.velocity.norm() <= 16 * eps * 100 * (x1.norm() + x2.norm()));
    CHECK(k.normal_spin == Approx(spin.dot(g.normal)).margin(16 * eps * 100));
  }
}

TEST_CASE("Kinematics: at_full_step turns the velocity of half a step ago with the normal") {
  // Two spheres that turn about each other at `turn` and approach at `speed`: seen along the normal of each instant the
  // contact point does not slip. Half a step ago the velocity was `speed` along the normal of then.
  const double turn = 3.0, speed = 0.2, slip = 0.05, distance = 0.15;
  for (const double dt : {1e-3, 1e-4, 1e-5}) {
    const double angle = turn * dt / 2;
    const Vector n(1, 0, 0), across(0, 1, 0);
    const Vector before(std::cos(angle), -std::sin(angle), 0), across_before(std::sin(angle), std::cos(angle), 0);
    const ContactKinematics<double> half{n, 1e-6, -speed * before + slip * across_before, dt, 7.0, {1, 2, 3}};
    const Vector centres = -speed * before + turn * distance * across_before;
    const ContactKinematics<double> full = at_full_step<double>(half, centres, distance);
    // What is left is of second order: the angle squared, and the change of the distance within half a step.
    const double second_order = angle * angle + angle * speed * dt / distance;
    CHECK(std::abs(full.velocity.dot(n) + speed) <= 2 * second_order * (speed + slip));
    CHECK(std::abs(full.velocity.dot(across) - slip) <= 2 * second_order * (speed + slip));
    CHECK(std::abs(half.velocity.dot(across) - slip) >= 0.9 * angle * speed);  // unturned: first order
    CHECK(full.normal == n);
    CHECK(full.overlap == half.overlap);
    CHECK(full.dt == dt);
    CHECK(full.normal_spin == 7.0);
    CHECK(full.relative_spin == Vector(1, 2, 3));
  }
}

TEST_CASE("Kinematics: overlap of 0.1 um of 5 mm spheres cancels, in float to a per cent: geometry belongs in double") {
  const double radius = 5e-3, distance = 2 * radius - 1e-7;
  const auto overlap = [&](auto type) {
    using T = decltype(type);
    const T r = static_cast<T>(radius);
    return static_cast<double>(
        sphere_sphere<T>({T(0), T(0), T(0)}, r, {static_cast<T>(distance), T(0), T(0)}, r).overlap);
  };
  CHECK(overlap(1.0) == Approx(1e-7).epsilon(1e-10));  // eps R/o
  CHECK(std::abs(overlap(1.0f) / 1e-7 - 1) < 0.012);   // the same with the eps of float
  CHECK(std::abs(overlap(1.0f) / 1e-7 - 1) > 1e-3);
}

TEST_CASE("Vector expressions and integer radii are taken as they are") {
  const Vec3<double> a(0.1, 0.2, 0.3), b(0.0, 0.0, 1.5);
  const ContactGeometry<double> plain = sphere_sphere(a, 1.0, Vec3<double>(a + b), 2.0);
  const ContactGeometry<double> same = sphere_sphere(a, 1, a + b, 2);
  CHECK(same.normal == plain.normal);
  CHECK(same.overlap == plain.overlap);
  CHECK(same.arm1 == plain.arm1);
  CHECK(same.arm2 == plain.arm2);
  const ElasticMaterial<double> rock{29e9, 0.15, 2650.0};
  CHECK(sphere(rock, 2).radius == 2.0);
}

}  // namespace contactlaws::test
