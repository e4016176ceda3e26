#include "contactlaws/tangential/rotation.hpp"

#include <array>
#include <utility>

#include "catch.hpp"
#include "contactlaws/laws.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

using Vector = Vec3<double>;

/// v turned about a unit axis.
Vector turned(const Vector& v, const Vector& axis, double angle) { return Eigen::AngleAxisd(angle, axis) * v; }

/// A pair turns rigidly by `total` about `axis`, in `steps`; how far the followed shear of length 1 ends from the truth.
template <class Rotation>
double error_of(const Vector& axis, double total, int steps) {
  const Vector normal(1, 0, 0), shear(0, 0.6, 0.8);
  typename Rotation::State state{};
  Vector followed = Rotation::apply(state, Vector(0, 0, 0), normal, 0.0);  // a new contact has no shear
  followed = shear;
  const double angle = total / steps;
  for (int i = 1; i <= steps; ++i) {
    const Vector n = turned(normal, axis, angle * i).normalized();
    followed = Rotation::apply(state, followed, n, angle * axis.dot(n));
  }
  return (followed - turned(shear, axis, total)).norm();
}

template <class Rotation>
double order_of(const Vector& axis) {
  return std::log2(error_of<Rotation>(axis, 1.0, 100) / error_of<Rotation>(axis, 1.0, 200));
}

using Project = rotation::Project<double>;
using ProjectRestore = rotation::ProjectRestore<double>;
using Rotate = rotation::Rotate<double>;

}  // namespace

TEST_CASE("Rotation: error per radian of a turning pair halves with the step for projections, quarters for Rotate") {
  const Vector across(0, 0, 1);
  // The next order's share at 100 steps a radian is of the order of a per cent.
  CHECK(order_of<Project>(across) == Approx(1.0).epsilon(0.02));
  CHECK(order_of<ProjectRestore>(across) == Approx(1.0).epsilon(0.02));
  CHECK(error_of<Project>(across, 1.0, 100) == Approx(0.6 * 0.5 / 100).epsilon(0.02));  // cos(angle)^steps
  CHECK(error_of<Rotate>(across, 1.0, 100) <= 100 * 4 * 2.3e-16);                       // exact: 4 roundings a step

  // About an oblique axis the pair spins about its normal too. Projections do not see that: their error is the spin's.
  const Vector oblique = Vector(1, 0, 1).normalized();
  CHECK(order_of<Rotate>(oblique) == Approx(2.0).epsilon(0.02));
  CHECK(error_of<Rotate>(oblique, 1.0, 100) < 1e-5);
  CHECK(error_of<ProjectRestore>(oblique, 1.0, 100) > 0.1);
}

TEST_CASE("Rotation: a common spin about the normal turns the shear with Rotate, exactly, and with nothing else") {
  const Vector normal(0, 0, 1), shear(3, 0, 0);
  // Lambert's fraction is cut off after five terms: x^11 / 8.9e8 of an angle 4 x.
  const std::array<std::pair<double, double>, 5> off{
      {{1e-9, 0.0}, {-0.5, 5e-17}, {0.7, 2e-15}, {-1.0, 1e-13}, {3.0, 1.7e-8}}};
  for (const auto& [twist, angle] : off) {
    Rotate::State state{{0, 0, 1}};
    const Vector followed = Rotate::apply(state, shear, normal, twist);
    CHECK((followed - turned(shear, normal, twist)).norm() <= 3 * (angle + 3 * 2.3e-16));
    CHECK(followed.norm() == Approx(3.0).epsilon(4 * 2.3e-16));
    CHECK((Rotate::slip(shear, normal, twist) - turned(shear, normal, twist / 2)).norm() <= 3 * (angle + 3 * 2.3e-16));
    CHECK(Project::slip(shear, normal, twist) == shear);
    CHECK(ProjectRestore::slip(shear, normal, twist) == shear);
    Project::State none;
    CHECK(Project::apply(none, shear, normal, twist) == shear);
    ProjectRestore::State nothing;
    CHECK(ProjectRestore::apply(nothing, shear, normal, twist) == shear);
  }
}

TEST_CASE("Rotation: a contact that sticks, sheared and spun in cycles, does not drift with Rotate") {
  using Law = ContactLaw<Hertz<double>, NoDashpots<double>, ShearForce<double, Mindlin<double>, Rotate>>;
  const Law law{{}, {}, {{}, 1e3}, {}};
  const PairProperties<double> pair = granite_pair<double>();
  const double overlap = 1e-5, amplitude = 0x1p-23, spin = 0x1p-6;
  // Of so few bits that the moves of a cycle add up to zero without rounding.
  const auto place = [](int i) { return std::round(0x1p30 * std::sin(2e-2 * 3.14159265358979323846 * i)) * 0x1p-30; };
  Law::State state{};
  const int steps = 100, cycles = cases(10000);
  Vector first(0, 0, 0), last(0, 0, 0);
  for (int cycle = 0; cycle < cycles; ++cycle)
    for (int i = 0; i < steps; ++i) {
      // Slip and spin of a step of length 1, in phase: the force would gain amplitude spin pi / steps in each cycle, 3e-4 of itself.
      const double by = place(i + 1) - place(i);
      ContactKinematics<double> motion{Vector(0, 0, 1), overlap, Vector(amplitude * by, 0, 0), 1.0};
      motion.normal_spin = spin * by;
      const auto step = law.step(pair, motion, state);
      state = step.state;
      if (i == steps / 4) (cycle == 0 ? first : last) = step.shear_force;
    }
  const double force = amplitude * law.stiffness(pair, overlap, {}).shear;
  CHECK(first.norm() == Approx(force).epsilon(0.01));  // at the crest of the cycle, to half a step
  CHECK((last - first).norm() <= 1e-12 * force);       // sqrt(1e6 steps) eps is 2e-13
}

TEST_CASE("Rotation: Rotate is exact for any turn short of reversal, of any normal") {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Vector from = random.direction(), axis = random.direction_across(from);
    const double angle = random.uniform(0.0, 3.0);
    const Vector to = turned(from, axis, angle), shear = random.log_uniform(1e-9, 1e9) * random.direction_across(from);
    Rotate::State state{{from.x(), from.y(), from.z()}};
    const Vector followed = Rotate::apply(state, shear, to, 0.0);
    // 1/(1 + cos) is 100 at 3 rad, and multiplies the rounding of the two unit vectors.
    CHECK((followed - turned(shear, axis, angle)).norm() <= 1e-13 * shear.norm());
    CHECK(Vector(state.last_normal[0], state.last_normal[1], state.last_normal[2]) == to);
  }
}

TEST_CASE("Rotation: all keep the shear in the plane; Project shortens it, the others do not") {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Vector from = random.direction();
    const Vector to = (from + random.log_uniform(1e-12, 1.0) * random.direction()).normalized();
    const Vector shear = random.log_uniform(1e-9, 1e9) * random.direction_across(from);
    const double length = shear.norm(), rounding = 8 * 2.3e-16 * length;
    Project::State none;
    ProjectRestore::State nothing;
    Rotate::State state{{from.x(), from.y(), from.z()}};
    const Vector projected = Project::apply(none, shear, to, 0.0);
    const Vector restored = ProjectRestore::apply(nothing, shear, to, 0.0);
    const Vector rotated = Rotate::apply(state, shear, to, 0.0);
    for (const Vector& followed : {projected, restored, rotated}) CHECK(std::abs(followed.dot(to)) <= 2 * rounding);
    CHECK(projected.norm() <= length + rounding);
    CHECK(restored.norm() == Approx(length).epsilon(1e-15).margin(rounding));
    CHECK(rotated.norm() == Approx(length).epsilon(1e-15).margin(rounding));
    CHECK(restored.cross(projected).norm() <= rounding * projected.norm());  // the same direction
  }
}

TEMPLATE_TEST_CASE("Rotation: over a million steps of a tumbling pair the length drifts by random roundings only", "",
                   ProjectRestore, Rotate) {
  using Rotation = TestType;
  Random random;
  for (const double angle : {1e-2, 1e-4, 1e-6, 1.4e-8}) {  // the last turns by less than sqrt(eps)
    Vector normal(1, 0, 0), shear(0, 1, 0), axis(0, 0, 1);
    typename Rotation::State state{};
    Rotation::apply(state, Vector(0, 0, 0), normal, 0.0);
    const int steps = cases(1000000);
    for (int i = 0; i < steps; ++i) {
      if (i % 100 == 0) axis = random.direction();
      normal = (normal + angle * axis.cross(normal)).normalized();
      shear = Rotation::apply(state, shear, normal, angle * 0.1);
    }
    // sqrt(steps) eps is 2e-13; what were biased by half an eps a step would come to 1e-10.
    CHECK(std::abs(shear.norm() - 1.0) <= 2e-12);
  }
}

TEST_CASE("Rotation: a zero history stays zero, and a reversed normal makes no NaN") {
  const Vector zero(0, 0, 0), normal(0, 1, 0);
  Rotate::State fresh{};
  CHECK(Rotate::apply(fresh, zero, normal, 0.1) == zero);
  Rotate::State reversed{{0, -1, 0}};
  CHECK(Rotate::apply(reversed, Vector(1, 0, 0), normal, 0.0).allFinite());
  ProjectRestore::State none;
  CHECK(ProjectRestore::apply(none, zero, normal, 0.0) == zero);
  CHECK(ProjectRestore::apply(none, Vector(0, 2, 0), normal, 0.0).allFinite());  // all of it lies along the normal
}

TEMPLATE_TEST_CASE("Rotation: two spheres that roll on each other have no shear force", "", Project, ProjectRestore,
                   Rotate) {
  using Law = ContactLaw<Hertz<double>, NoDashpots<double>, ShearForce<double, Mindlin<double>, TestType>>;
  const Law law{{}, {}, {{}, 0.4}, {}};
  const PairProperties<double> pair = granite_pair<double>();
  const double radius1 = 7.5e-3, radius2 = 5e-3, overlap = 1e-5, distance = radius1 + radius2 - overlap;
  const double arm1 = radius1 - overlap / 2, arm2 = radius2 - overlap / 2, speed = 0.3, dt = 1e-5;
  typename Law::State gears{}, planet{};
  double largest = 0.0;
  const int steps = 20000;  // six centimetres of rolling: more than a turn
  for (int i = 0; i < steps; ++i) {
    // Gears: the centres rest, the surfaces run alike.
    const BodyMotion<double> one{{0, 0, 0}, {0, 0, 0}, {0, 0, speed / arm1}};
    const BodyMotion<double> two{{distance, 0, 0}, {0, 0, 0}, {0, 0, -speed / arm2}};
    const auto turning = law.step(
        pair, contact_kinematics(sphere_sphere(one.position, radius1, two.position, radius2), one, two, dt), gears);
    gears = turning.state;
    // A planet: the second sphere rolls around the first, which rests.
    const double angle = speed * i * dt / distance;
    const Vector out(std::cos(angle), std::sin(angle), 0), along(-std::sin(angle), std::cos(angle), 0);
    const BodyMotion<double> sun{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    const BodyMotion<double> rolling{distance * out, speed * along, {0, 0, speed / arm2}};
    const auto orbiting = law.step(
        pair, contact_kinematics(sphere_sphere(sun.position, radius1, rolling.position, radius2), sun, rolling, dt),
        planet);
    planet = orbiting.state;
    const auto shear_of = [](const auto& step, const Vector& n) { return (step.force - step.normal_force * n).norm(); };
    largest = std::max({largest, shear_of(turning, Vector(1, 0, 0)), shear_of(orbiting, out)});
  }
  // Slip of that length would give k_s times it, were there no friction; velocities cancel to a few eps.
  const double slip = law.stiffness(pair, overlap, {}).shear * speed * steps * dt;
  CHECK(largest <= 8 * 2.3e-16 * slip);
}

}  // namespace contactlaws::test
