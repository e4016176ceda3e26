#include "contactlaws/tangential/mindlin_deresiewicz.hpp"

#include <iostream>

#include "catch.hpp"
#include "contactlaws/energy.hpp"
#include "contactlaws/laws.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

template <class T, int corners = 4>
using PartialSlip = ContactLaw<Hertz<T>, NoDashpots<T>, MindlinDeresiewicz<T, rotation::ProjectRestore<T>, corners>>;

constexpr double mu = 0.4, deep = 1e-4;  // [1], [m]
constexpr double hertz_0 = 1.08330463206478e9,
                 shear_0 = 1.49320368203524e9;  // F/o^(3/2), k/o^(1/2) of the granite grains
double load(double overlap) { return hertz_0 * std::pow(overlap, 1.5); }
double stiffness(double overlap) { return shear_0 * std::sqrt(overlap); }
/// mu E*/(4 G*), the slope of the cone.
constexpr double cone = mu * 1.5 * hertz_0 / shear_0;

/// Loading and unloading at a constant load, as shares of mu P and of the slip at which all slides.
double virgin(double s) { return s < 1.0 ? 1.0 - std::pow(1.0 - s, 1.5) : 1.0; }
double slip_of(double f) { return 1.0 - std::pow(1.0 - f, 2.0 / 3.0); }

/// The granite grains, normal +z, slipping in the plane of x and y.
template <class T, int corners = 4>
struct Slipping {
  using Law = PartialSlip<T, corners>;
  Law law{};
  PairProperties<T> pair = granite_pair<T>();
  typename Law::State state{};
  T overlap = T(0);
  T work = T(0), heat = T(0), largest = T(0);  ///< of the shear force, of friction, shear energy so far [J]
  Vec3<T> last = Vec3<T>(T(0), T(0), T(0));    ///< force against the motion [N]

  explicit Slipping(double friction = mu) { law.shear.friction = T(friction); }

  T stored(const T& at, const typename Law::State& of) const {
    return law.shear.energy(of, law.stiffness(pair, at, of).shear);
  }
  /// In `steps` equal steps. The shear force against the motion [N].
  Vec3<T> move(double to, double x, double y = 0.0, int steps = 1) {
    const T start = overlap;
    for (int i = 1; i <= steps; ++i) {
      const T next = i == steps ? T(to) : T(start + (T(to) - start) * T(i) / T(steps));
      const Vec3<T> slip(T(x) / T(steps), T(y) / T(steps), T(0));
      const auto step = law.step(pair, {{T(0), T(0), T(1)}, next, slip, T(1)}, state);
      work += dot<T>(Vec3<T>(last - step.shear_force), slip) / T(2);
      heat += step.friction_work;
      largest = maximum<T>(largest, stored(next, step.state));
      state = step.state;
      overlap = next;
      last = -step.shear_force;
    }
    return last;
  }
};

/// The springs of the header, each by itself: independent of the chain of corners.
struct Row {
  static constexpr int count = 1000;
  std::vector<double> along = std::vector<double>(count), across = std::vector<double>(count);  ///< e [m]
  double overlap = 0.0;

  /// Springs at equal distances of x sqrt(o) = sqrt(o - h): at rest in the surface, to the largest overlap.
  Vec3<double> move(double to, double x, double y, int steps) {
    const double before = overlap;
    for (int i = 1; i <= steps; ++i) {
      const double was = before + (to - before) * (i - 1) / steps;
      overlap = before + (to - before) * i / steps;
      for (std::size_t j = 0; j < count; ++j) {
        const double place = std::sqrt(deep) * (static_cast<double>(j) + 0.5) / count, h = overlap - place * place;
        const double part = h > overlap - was ? 1.0 : h / (overlap - was);  // of the step since it touches
        along[j] = h > 0.0 ? along[j] + part * x / steps : 0.0;
        across[j] = h > 0.0 ? across[j] + part * y / steps : 0.0;
        const double length = std::hypot(along[j], across[j]);
        if (length > cone * h && h > 0.0) along[j] *= cone * h / length, across[j] *= cone * h / length;
      }
    }
    double sum_x = 0.0, sum_y = 0.0;
    for (std::size_t j = 0; j < count; ++j) sum_x += along[j], sum_y += across[j];
    return shear_0 * std::sqrt(deep) / count * Vec3<double>(sum_x, sum_y, 0.0);
  }
};

/// The largest difference of a chain from the row of springs over random walks, in mu P of the largest overlap.
template <int corners>
double off_the_row(bool plane, int walks) {
  double worst = 0.0;
  Random random(53);
  for (int w = 0; w < walks; ++w) {
    Row row;
    Slipping<double, corners> chain;
    for (int i = 0; i < 12; ++i) {
      const double to = deep * random.uniform(0.3, 1.0);
      const double x = cone * deep * random.uniform(-1.0, 1.0);
      const double y = plane ? cone * deep * random.uniform(-1.0, 1.0) : 0.0;
      const int steps = plane ? 20 : 1;
      const Vec3<double> expected = row.move(to, x, y, steps), seen = chain.move(to, x, y, steps);
      worst = std::max(worst, (expected - seen).norm() / (mu * load(deep)));
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("Partial slip: loading, unloading and reloading at a constant load are Mindlin's curves; the loop closes") {
  const double limit = mu * load(deep), most = cone * deep;
  // Sums of slips are off by 1e-16 of them, and force and slip have roundings of their own.
  const auto is = [&](double share) { return Approx(share * limit).margin(1e-12 * limit).epsilon(0); };
  for (const int steps : {1, 7, 1000}) {
    Slipping<double> contact;
    contact.move(deep, 0.0);
    const double turn = 0.7;  // s*/s_max
    CHECK(contact.move(deep, 0.2 * most, 0.0, steps).x() == is(virgin(0.2)));
    CHECK(contact.move(deep, 0.5 * most, 0.0, steps).x() == is(virgin(turn)));
    CHECK(contact.move(deep, -0.4 * most, 0.0, steps).x() == is(virgin(turn) - 2 * virgin(0.4 / 2)));
    CHECK(contact.move(deep, -1.0 * most, 0.0, steps).x() == is(-virgin(turn)));
    CHECK(contact.move(deep, 0.9 * most, 0.0, steps).x() == is(-virgin(turn) + 2 * virgin(0.9 / 2)));
    CHECK(contact.move(deep, 0.5 * most, 0.0, steps).x() == is(virgin(turn)));        // the loop closes
    CHECK(contact.move(deep, 0.1 * most, 0.0, steps).x() == is(virgin(turn + 0.1)));  // and the virgin curve goes on
    CHECK(contact.move(deep, 0.5 * most, 0.0, steps).x() == is(1.0));
    CHECK(contact.move(deep, -1.0 * most, 0.0, steps).x() == is(1.0 - 2 * virgin(0.5)));
  }
  Slipping<double> begins;
  begins.move(deep, 0.0);
  CHECK(begins.move(deep, 1e-9 * most).x() == Approx(stiffness(deep) * 1e-9 * most).epsilon(1e-8));  // initial tangent
}

TEST_CASE("Partial slip: the area of a loop, in closed form") {
  // Mindlin, Mason, Osmer & Deresiewicz (1952); Mindlin & Deresiewicz (1953):
  //   9 mu^2 P^2 / (10 a G*) (1 - (1 - L)^(5/3) - 5 L/6 (1 + (1 - L)^(2/3))),  L = F*/(mu P)
  const double limit = mu * load(deep), most = cone * deep;
  for (const double share : {0.1, 0.5, 0.9, 1.0}) {
    Slipping<double> contact;
    contact.move(deep, 0.0);
    const double there = slip_of(share) * most;
    contact.move(deep, there, 0.0, 1);
    const double before = contact.work, heat = contact.heat;
    constexpr int steps = 4000;  // the trapezoidal rule: 1/steps^2, and ^(3/2) where all slides
    contact.move(deep, -2 * there, 0.0, steps);
    contact.move(deep, 2 * there, 0.0, steps);
    const double rest = std::pow(1.0 - share, 2.0 / 3.0);
    const double area =
        36.0 / 5.0 * limit * limit / stiffness(deep) * (1.0 - rest * (1.0 - share) - 5.0 * share / 6.0 * (1.0 + rest));
    CHECK(contact.work - before == Approx(area).epsilon(share < 0.2 ? 1e-4 : 1e-6));
    CHECK(contact.heat - heat == Approx(area).epsilon(share < 0.2 ? 1e-4 : 1e-6));
    // What is not heat is stored: the trapezoidal rule again.
    CHECK(contact.stored(deep, contact.state) ==
          Approx(contact.work - contact.heat).margin(share < 0.2 ? 1e-3 * area : 1e-6 * contact.work));
  }
}

TEST_CASE("Partial slip: Mindlin and Deresiewicz's oblique paths") {
  const double ratio = shear_0 / (1.5 * hertz_0);  // 4 G*/E*
  const auto is = [](double force) { return Approx(force).epsilon(1e-12); };
  for (const int steps : {1, 10, 1000}) {
    // From touch at a constant angle below friction: nothing slips, F/P is constant; back along the same line.
    Slipping<double> steep;
    CHECK(steep.move(deep, 0.5 * cone * deep, 0.0, steps).x() == is(0.5 * mu * load(deep)));
    CHECK(steep.move(0.3 * deep, -0.7 * 0.5 * cone * deep, 0.0, steps).x() ==
          is(ratio * 0.5 * cone * load(0.3 * deep)));
    // At an angle beyond friction: all slides.
    Slipping<double> flat;
    CHECK(flat.move(deep, 1.5 * cone * deep, 0.0, steps).x() == is(mu * load(deep)));

    // A load that rises keeps the force of a contact that rests, and gives back the state when it falls again.
    Slipping<double> pressed;
    pressed.move(deep, 0.0);
    const double held = pressed.move(deep, 0.6 * cone * deep).x();
    CHECK(pressed.move(1.7 * deep, 0.0, 0.0, steps).x() == is(held));
    CHECK(pressed.move(deep, 0.0, 0.0, steps).x() == is(held));
    CHECK(pressed.move(deep, 0.1 * cone * deep).x() == is(virgin(0.7) * mu * load(deep)));
    // A load that falls lets the edge slip: the virgin curve of the load that is left.
    CHECK(pressed.move(0.8 * deep, 0.0, 0.0, steps).x() == is(virgin(0.7 / 0.8) * mu * load(0.8 * deep)));
    CHECK(pressed.move(0.6 * deep, 0.0, 0.0, steps).x() == is(mu * load(0.6 * deep)));
    // A load that rises more slowly than friction follows: the virgin curve of the load reached.
    Slipping<double> follows;
    follows.move(deep, 0.0);
    follows.move(deep, 0.3 * cone * deep);
    CHECK(follows.move(1.2 * deep, 0.5 * cone * deep, 0.0, steps).x() == is(virgin(0.8 / 1.2) * mu * load(1.2 * deep)));
  }
  // A load that was raised at rest: first the new ring slips, then all is as on the virgin curve.
  Slipping<double> later;
  later.move(deep, 0.0);
  later.move(deep, 0.3 * cone * deep);
  later.move(1.2 * deep, 0.0);
  const double held = virgin(0.3) * mu * load(deep), more = 0.1 * cone * deep;
  CHECK(later.move(1.2 * deep, more).x() == is(held + virgin(0.1 / 1.2) * mu * load(1.2 * deep)));
  CHECK(later.move(1.2 * deep, more).x() == is(virgin(0.5 / 1.2) * mu * load(1.2 * deep)));
}

TEST_CASE("Partial slip: random walks against a row of springs, each by itself") {
  const double exact = off_the_row<24>(false, cases(40)), line = off_the_row<4>(false, cases(40));
  const double plane = off_the_row<48>(true, cases(8)), short_plane = off_the_row<4>(true, cases(8));
  std::cout << "partial slip, off a row of springs in mu P: in one direction " << exact << ", four corners " << line
            << "; in the plane, 48 corners " << plane << ", four " << short_plane << '\n';
  CHECK(exact < 1e-4);  // 4000 springs: 1/count^(3/2)
  CHECK(line < 0.02);   // the rule where a fifth corner is needed
  CHECK(plane < 0.01);
  CHECK(short_plane < 0.1);
}

namespace {

/// The largest difference from the row of springs, in mu P of the largest overlap, where load and slip rise and fall together along
/// smooth curves: each step would add a corner.
template <int corners>
double off_the_row_on_curves(int steps) {
  Row row;
  Slipping<double, corners> chain;
  const auto overlap = [](double t) { return deep * (0.5 - 0.5 * std::cos(4 * 3.14159265358979 * t)) * (1 - 0.4 * t); };
  const auto slip = [](double t) { return 0.4 * cone * deep * (std::sin(15 * t) + 0.3 * std::cos(6 * t)); };
  double worst = 0.0;
  for (int i = 1; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps, to = std::max(overlap(t), 1e-3 * deep);
    const double by = slip(t) - slip(t - 1.0 / steps);
    worst = std::max(worst, (row.move(to, by, 0.0, 1) - chain.move(to, by)).norm() / (mu * load(deep)));
  }
  return worst;
}

}  // namespace

TEST_CASE("Partial slip: along smooth curves four corners stay near a row of springs, however small the steps") {
  for (const int steps : {500, 4000, 20000}) {
    const double four = off_the_row_on_curves<4>(steps), twelve = off_the_row_on_curves<12>(steps);
    std::cout << "partial slip, off a row of springs on curves in mu P, " << steps << " steps: four corners " << four
              << ", twelve " << twelve << '\n';
    CHECK(four < 0.02);     // what the header says, and a quarter more
    CHECK(twelve < 0.002);  // twelve hold a curve nine times as well as four, and the row has 1e-4 of its own
  }
}

TEMPLATE_TEST_CASE("Partial slip: accuracy along paths of 100 steps", "", double, float) {
  using T = TestType;
  Random random(29);
  double worst = 0.0;
  for (int path = 0; path < cases(50); ++path) {
    Slipping<T> contact;
    Slipping<Binary200> precise;
    precise.law.shear.friction = Binary200(contact.law.shear.friction);
    precise.pair = contact.pair.template cast<Binary200>();
    for (int i = 0; i < 100; ++i) {
      const double to = static_cast<T>(deep * random.uniform(0.3, 1.0));
      const double x = static_cast<T>(0.5 * cone * deep * random.uniform(-1.0, 1.0));
      const double y = static_cast<T>(0.5 * cone * deep * random.uniform(-1.0, 1.0));
      const Vec3<T> seen = contact.move(to, x, y);
      const Vec3<Binary200> expected = precise.move(to, x, y);
      for (int k = 0; k < 3; ++k)
        worst = std::max(worst, std::abs(static_cast<double>(Binary200(seen[k]) - expected[k])) / (mu * load(deep)));
    }
  }
  std::cout << "partial slip, off 200 bits" << precision_name<T>() << ": " << worst << " of mu P\n";
  // Sums of 100 slips; where slipping ends is a root of a quadratic, whose roundings a root of a difference may magnify.
  CHECK(worst <= 1e3 * std::numeric_limits<T>::epsilon());
}

TEST_CASE("Partial slip: friction bounds the force, and none of a load bears none; its size and its parameter") {
  Slipping<double> sliding;
  sliding.move(deep, 0.0);
  CHECK(sliding.move(deep, 1.0, 1.0).norm() == Approx(mu * load(deep)).epsilon(1e-14));  // printed to 15 digits
  const auto& law = sliding.law;
  CHECK(law.step(sliding.pair, {{0, 0, 1}, deep, {1, 1, 0}, 1}, sliding.state).sliding);
  CHECK_FALSE(law.step(sliding.pair, {{0, 0, 1}, deep, {-1e-7, -1e-7, 0}, 1}, sliding.state).sliding);
  Slipping<double> smooth(0.0);
  smooth.move(deep, 1e-6);
  CHECK(smooth.move(deep, 1e-6).norm() == 0.0);
  CHECK(PartialSlip<double>::state_size == 17);
  CHECK(PartialSlip<double, 2>::state_size == 9);
  PartialSlip<double> bad;
  bad.shear.friction = -1.0;
  CHECK_THROWS_WITH(checked(bad), Catch::Matchers::Equals("MindlinDeresiewicz: friction is -1, must lie in [0, inf)"));
}

TEST_CASE("Partial slip: a corner that is dropped leaves the force") {
  // Loads that rise in ten straight pieces, each with less slip than the last, below friction: nothing slips, and a chain of
  // 24 corners is exact. To drop a corner here lowers the energy, so that no deflection is scaled.
  Slipping<double, 24> exact;
  Slipping<double> short_chain;
  for (int i = 1; i <= 10; ++i) {
    const double slip = 0.1 * cone * deep * (1.0 - 0.09 * i);
    const double expected = exact.move(0.1 * deep * i, slip).x();
    CHECK(short_chain.move(0.1 * deep * i, slip).x() == Approx(expected).epsilon(1e-13));
  }
}

TEST_CASE("Partial slip: no closed loop gains energy") {
  double most = -1.0, most_in_plane = -1.0;
  for (const bool plane : {false, true}) {
    Random random(11);
    for (int w = 0; w < cases(100); ++w) {
      Slipping<double> contact(w % 2 == 0 ? mu : 1e3);  // where all sticks, only dropped corners could gain
      contact.move(deep * random.uniform(0.1, 1.0), 0.0);
      const double begin = contact.overlap;
      Vec3<double> at(0, 0, 0);
      const int length = random.integer(2, 12);
      const double size = random.log_uniform(0.01, 1.0);
      for (int i = 0; i <= length; ++i) {
        Vec3<double> to(0, 0, 0);
        if (i < length) {
          const double x = random.uniform(-1.0, 1.0);
          const double y = random.uniform(-1.0, 1.0);
          to = size * cone * deep * Vec3<double>(x, plane ? y : 0.0, 0);
        }
        const double overlap = i < length ? deep * random.uniform(0.1, 1.0) : begin;
        contact.move(overlap, to.x() - at.x(), to.y() - at.y(), 100);
        at = to;
      }
      const double gain = (contact.stored(contact.overlap, contact.state) - contact.work) / contact.largest;
      (plane ? most_in_plane : most) = std::max(plane ? most_in_plane : most, gain);
    }
  }
  std::cout << "partial slip, largest gain of a closed loop: " << most << ", in the plane " << most_in_plane << '\n';
  CHECK(most <= 1e-3);
  CHECK(most_in_plane <= 1e-3);
}

}  // namespace contactlaws::test
