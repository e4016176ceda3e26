// An oblique impact of a sphere on a wall, integrated by leapfrog with a law's own force: the shear histories differ below 30
// degrees. The tests and the scoreboard call it.
#pragma once

#include <cmath>

#include "contactlaws/laws.hpp"

namespace contactlaws::test {

/// An aluminium oxide sphere of 2.5 mm on a softer wall at 3.9 m/s; mu 0.092, no damping (after Chung & Ooi 2011, test 4). Arms R - o/2.
struct ObliqueImpact {
  static constexpr double speed = 3.9, radius = 2.5e-3, friction = 0.092;
  ElasticMaterial<double> oxide{380e9, 0.23, 4000.0}, wall{70e9, 0.25, 2700.0};

  /// Spin after the impact [rad/s], of a law with the shear history Shear; `degrees` from the normal.
  template <class Shear>
  double spin(double degrees, double dt) const {
    ContactLaw<Hertz<double>, NoDashpots<double>, Shear> law;
    law.shear.friction = friction;
    const PairProperties<double> pair = pair_properties(plane(wall), sphere(oxide, radius));
    const double mass = pair.effective_mass, inertia = 0.4 * mass * radius * radius;
    const double angle = degrees * pi<double>() / 180;
    const BodyMotion<double> at_rest{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    BodyMotion<double> ball{{0, 0, radius}, {speed * std::sin(angle), 0, -speed * std::cos(angle)}, {0, 0, 0}};
    typename decltype(law)::State state{};
    do {
      ball.position += ball.velocity * dt;
      const auto geometry = plane_sphere<double>({0, 0, 0}, {0, 0, 1}, ball.position, radius);
      const auto step = law.step(pair, contact_kinematics(geometry, at_rest, ball, dt), state);
      state = step.state;
      ball.velocity += step.force / mass * dt;
      ball.spin += geometry.arm2.cross(step.force) / inertia * dt;
    } while (ball.position.z() < radius);
    return ball.spin.norm();
  }

  /// The largest error of the spin, over the angles, against independent integrations at 50 digits, relative.
  double worst_error(double dt) const {
    using Rescaled = ShearForceRescaled<double>;
    double worst = 0.0;
    const auto see = [&worst](double computed, double expected) {
      worst = std::fmax(worst, std::abs(computed / expected - 1));
    };
    see(spin<ShearDisplacement<double>>(10, dt), 206.950);
    see(spin<ShearForce<double>>(10, dt), 196.464);
    see(spin<Rescaled>(10, dt), 198.459);
    see(spin<ShearForce<double>>(30, dt), 619.9230);  // slides throughout: the histories agree
    see(spin<ShearDisplacement<double>>(30, dt), 619.9230);
    see(spin<ShearForce<double>>(45, dt), 506.3529);
    see(spin<Rescaled>(60, dt), 358.2282);
    return worst;
  }
};

}  // namespace contactlaws::test
