#include "contactlaws/normal/linear_hysteretic.hpp"

#include "catch.hpp"
#include "contactlaws/contactlaws.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

constexpr double k1 = 1e6, k2 = 5e6, kc = 5e5, depth = 1e-3;
const PairProperties<double> pair = granite_pair<double>();  // R* = 3 mm
const LinearHysteretic<double> law{k1, k2, kc, depth};
const double plastic = 2 * depth * 3e-3 * k2 / (k2 - k1);  // o_p

/// A contact that goes from overlap to overlap; the work of straight lines by the trapezoidal rule.
struct Pressed {
  LinearHysteretic<double> of = law;
  LinearHysteretic<double>::State state{};
  double overlap = 0.0, force = 0.0, work = 0.0;

  double move(double to, int steps = 1) {
    const double from = overlap;
    for (int i = 1; i <= steps; ++i) {
      const double next = from + (to - from) * i / steps;
      const double now = of.respond(state, pair, next).force;
      work += (force + now) / 2 * (next - overlap);
      force = now;
      overlap = next;
    }
    return force;
  }
};

double unloading_stiffness(double largest) { return k1 + (k2 - k1) * std::min(largest / plastic, 1.0); }

/// e^2 of the header.
double restitution_squared(double ratio, double cohesion) {
  const double k = unloading_stiffness(plastic * ratio);
  const double at = k1 / k - cohesion * (k - k1) * (k - k1) / (k1 * k * (k + cohesion));
  return ratio <= 1.0 ? at : 1.0 - (1.0 - at) / (ratio * ratio);
}

}  // namespace

TEST_CASE("Linear hysteretic: loading, unloading, pulling and reloading are straight lines") {
  for (const double largest : {0.1 * plastic, 0.7 * plastic, plastic}) {
    Pressed contact;
    const double k = unloading_stiffness(largest), zero = (1 - k1 / k) * largest;
    const double turn = (k - k1) / (k + kc) * largest;  // where the largest pull is
    const auto is = [&](double force) { return Approx(force).margin(1e-14 * k1 * largest).epsilon(0); };
    CHECK(contact.move(0.5 * largest) == is(0.5 * k1 * largest));
    CHECK(contact.move(largest) == is(k1 * largest));
    CHECK(contact.move(0.5 * (largest + zero)) == is(0.5 * k1 * largest));
    CHECK(contact.move(zero) == is(0.0));
    CHECK(contact.move(largest) == is(k1 * largest));
    CHECK(contact.move(turn) == is(-kc * turn));
    CHECK(contact.move(zero) == is(0.0));  // not yet beyond the turn
    // Beyond it: a line through the point, of the stiffness of the largest overlap whose line it is.
    CHECK(contact.move(0.4 * turn) == is(-kc * 0.4 * turn));
    const double lowered = contact.state.largest_overlap, lower = unloading_stiffness(lowered);
    CHECK(lowered < largest);
    CHECK(k1 * lowered - lower * (lowered - 0.4 * turn) == is(-kc * 0.4 * turn));
    CHECK(contact.move(0.5 * (lowered + 0.4 * turn)) == is(k1 * lowered - lower * 0.5 * (lowered - 0.4 * turn)));
    CHECK(contact.move(lowered) == is(k1 * lowered));
    CHECK(contact.move(largest) == is(k1 * largest));  // the loading line again
    CHECK(contact.move(0.0) == 0.0);
  }
  // Beyond the plastic depth both ways are the stiffest line.
  Pressed deep;
  CHECK(deep.move(1.5 * plastic) == Approx(k1 * plastic + 0.5 * k2 * plastic).epsilon(1e-14));
  CHECK(deep.move(1.2 * plastic) == Approx(k1 * plastic + 0.2 * k2 * plastic).epsilon(1e-14));
  CHECK(deep.state.largest_overlap == Approx(plastic).epsilon(1e-15));
  // What friction counts and how far a clipped dashpot may pull: k_c o. The tangent of a branch, never negative.
  LinearHysteretic<double>::State fresh{}, loaded{plastic};
  CHECK(law.respond(fresh, pair, 0.5 * plastic).adhesion == Approx(kc * 0.5 * plastic).epsilon(1e-15));
  CHECK(law.respond(fresh, pair, 0.6 * plastic).stiffness == k1);
  CHECK(law.respond(loaded, pair, 0.1 * plastic).stiffness > k1);
}

TEST_CASE("Linear hysteretic: restitution against speed, in closed form") {
  for (const double cohesion : {0.0, 1e5, kc}) {
    double before = 1.0;
    for (const double ratio : {1e-3, 0.2, 0.6, 1.0, 1.5, 4.0}) {
      // The kinetic energy at v/v_p is the work of loading: k_1 o_m^2/2 to o_p, then along the stiffest line.
      const double kinetic = 0.5 * k1 * std::pow(ratio * plastic, 2);
      const double largest = ratio <= 1.0
                                 ? ratio * plastic
                                 : plastic + plastic * (std::sqrt(k1 * k1 + k1 * k2 * (ratio * ratio - 1.0)) - k1) / k2;
      Pressed contact;
      contact.of.cohesive_stiffness = cohesion;
      if (ratio > 1.0) contact.move(plastic);
      contact.move(largest);
      CHECK(contact.work == Approx(kinetic).epsilon(1e-12));
      contact.move(0.0, 100000);  // the two kinks of the way back lie within steps
      const double expected = restitution_squared(ratio, cohesion);
      CHECK(1.0 - contact.work / kinetic == Approx(expected).margin(1e-7));
      if (ratio <= 1.0) CHECK(expected < before);
      if (ratio <= 1.0) before = expected;
    }
  }
}

TEST_CASE("Linear hysteretic: no path gains energy") {
  Random random(3);
  double most = -1.0;
  for (int path = 0; path < cases(2000); ++path) {
    Pressed contact;
    contact.of.cohesive_stiffness = random.chance(0.3) ? 0.0 : random.log_uniform(1e4, 1e7);
    double largest = 0.0;
    const int length = random.integer(1, 8);
    for (int i = 0; i < length; ++i) {
      const double to = plastic * random.uniform(0.0, 1.3);
      contact.move(to, 400);
      const double stored = contact.of.energy(contact.state, pair, contact.overlap);
      largest = std::max(largest, stored);
      most = std::max(most, (stored - contact.work) / largest);
    }
    contact.move(0.0, 400);
    most = std::max(most, -contact.work / largest);
  }
  CHECK(most <= 1e-4);  // kinks within steps, 1/400^2 each
}

TEMPLATE_TEST_CASE("Linear hysteretic: accuracy", "", double, float) {
  using T = TestType;
  Random random(13);
  Worst loading("Linear hysteretic loading" + precision_name<T>()),
      back("Linear hysteretic unloading, of k_1 o_m or |F|" + precision_name<T>());
  for (int i = 0; i < cases(20000); ++i) {
    const T radius = random.binary<T>(-20, 4), soft = random.binary<T>(0, 20);
    const PairProperties<T> any{radius, T(1), T(1), T(1), radius, radius};
    const LinearHysteretic<T> of{soft, soft * static_cast<T>(random.uniform(1.1, 20.0)),
                                 soft * static_cast<T>(random.log_uniform(1e-3, 10.0)),
                                 static_cast<T>(random.log_uniform(1e-4, 1e-1))};
    const LinearHysteretic<Binary200> exact{Binary200(of.loading_stiffness), Binary200(of.unloading_stiffness),
                                            Binary200(of.cohesive_stiffness), Binary200(of.plastic_depth)};
    const auto exact_pair = any.template cast<Binary200>();
    const T largest = radius * of.plastic_depth * static_cast<T>(random.log_uniform(1e-2, 1.0));
    typename LinearHysteretic<T>::State fresh{}, loaded{largest};
    LinearHysteretic<Binary200>::State exact_fresh{}, exact_loaded{Binary200(largest)};
    loading.see(
        ulps(of.respond(fresh, any, largest).force, exact.respond(exact_fresh, exact_pair, Binary200(largest)).force),
        largest);
    const T overlap = largest * static_cast<T>(random.uniform(0.01, 2.0));
    const T seen = of.respond(loaded, any, overlap).force;
    const Binary200 expected = exact.respond(exact_loaded, exact_pair, Binary200(overlap)).force;
    const Binary200 scale = std::max(Binary200(abs(expected)), Binary200(soft) * Binary200(largest));
    back.see(static_cast<double>(abs(Binary200(seen) - expected) / scale / std::numeric_limits<T>::epsilon()), overlap,
             largest);
  }
  CHECK(loading.error() <= 1.0);  // what the header promises
  CHECK(back.error() <= 4.0);
}

TEST_CASE("Linear hysteretic: its parameters are checked; without a stiffer way back it is a spring") {
  LinearHysteretic<double> bad = law;
  bad.plastic_depth = 0.0;
  CHECK_THROWS_WITH(checked(ContactLaw<LinearHysteretic<double>>{bad, {}, {}, {}, {}}),
                    Catch::Matchers::Equals("LinearHysteretic: plastic_depth is 0, must lie in (0, inf)"));
  const LinearHysteretic<double> spring{k1, k1, kc, depth};
  LinearHysteretic<double>::State state{};
  for (const double overlap : {1e-5, 1e-3, 1e-6}) CHECK(spring.respond(state, pair, overlap).force == k1 * overlap);
}

}  // namespace contactlaws::test
