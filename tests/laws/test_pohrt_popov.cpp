#include "contactlaws/normal/pohrt_popov.hpp"

#include <algorithm>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "catch.hpp"
#include "contactlaws/energy.hpp"
#include "contactlaws/laws.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

using Elastic = PohrtPopov<double>;
using Plastic = PohrtPopovElastoPlastic<double>;

/// Table 1 of Tolomeo & McDowell (2022): R* = 2.36 mm of two equal grains.
constexpr RoughSurface<double> ballast_surface{2.13, 26.1e-6};
const ElasticMaterial<double> ballast_rock{60e9, 0.25, 2700.0};

PairProperties<double> ballast_pair() {
  return pair_properties(sphere(ballast_rock, 4.72e-3), sphere(ballast_rock, 4.72e-3));
}

RoughSurface<double> random_surface(Random& random) {
  return {random.uniform(2.0, 3.0), random.log_uniform(1e-9, 1e-3)};
}

template <class Law, class T>
NormalResponse<T> virgin(const Law& law, const PairProperties<T>& pair, const T& overlap) {
  typename Law::State state;
  return law.respond(state, pair, overlap);
}

/// Work along a path of overlaps, by trapezia: exact bookkeeping where a path returns over the same overlaps.
double trapezia(const std::vector<double>& overlaps, const std::vector<double>& forces) {
  double work = 0.0;
  for (std::size_t i = 1; i < overlaps.size(); ++i)
    work += (forces[i - 1] + forces[i]) / 2.0 * (overlaps[i] - overlaps[i - 1]);
  return work;
}

/// Integral of f from a to b by Gauss-Legendre with 5 points on each of n pieces.
template <class Function>
double integral(const Function& f, double a, double b, int pieces) {
  const double x[] = {0.0, 0.538469310105683091, 0.906179845938663993};
  const double w[] = {0.568888888888888889, 0.478628670499366468, 0.236926885056189088};
  double sum = 0.0;
  for (int i = 0; i < pieces; ++i) {
    const double half = (b - a) / pieces / 2.0, middle = a + (2 * i + 1) * half;
    sum += half * w[0] * f(middle);
    for (int k = 1; k < 3; ++k) sum += half * w[k] * (f(middle - half * x[k]) + f(middle + half * x[k]));
  }
  return sum;
}

}  // namespace

TEST_CASE("Pohrt-Popov: the ballast of the paper's Table 1") {
  const PairProperties<double> pair = ballast_pair();
  CHECK(pair.effective_radius == Approx(2.36e-3).epsilon(1e-15));
  CHECK(pair.effective_young == Approx(32e9).epsilon(1e-15));
  CHECK(mindlin_ratio(pair) == Approx(2 * (1 - 0.25) / (2 - 0.25)).epsilon(1e-15));  // Eq. 7
  CHECK(ballast_surface.stiffness_exponent() == Approx(0.546771).epsilon(1e-15));

  // As printed: 3 and 4 digits.
  const double area = ballast_surface.full_contact_area(pair.effective_radius);
  const HertzResponse<double> transition = hertz_response(pair, ballast_surface.transition_indentation());
  CHECK(area == Approx(6.68e-7).epsilon(2e-3));
  CHECK(transition.force == Approx(1775.0).epsilon(1e-3));
  // Recomputed from Eqs 1 and 3-5, to the digits given.
  CHECK(area == Approx(6.689091e-7).epsilon(1e-6));
  CHECK(transition.force == Approx(1776.24400).epsilon(1e-8));
  CHECK(transition.stiffness == Approx(2.95317111e7).epsilon(1e-8));
  CHECK(transition.stiffness ==
        Approx(2 * pair.effective_young * std::sqrt(area / pi<double>())).epsilon(1e-14));  // Eq. 3

  const Elastic law = Elastic::of(ballast_surface);
  CHECK(law.exponent * 1.5 == Approx(2.2063901).epsilon(1e-7));
  CHECK(law.transition_overlap == Approx(132.70776e-6).epsilon(1e-7));
  CHECK(law.transition_overlap - law.transition_indentation() == Approx(42.48725e-6).epsilon(1e-7));
  const double overlaps[] = {1e-6, 5e-6, 10e-6, 20e-6, 30e-6};
  const double forces[] = {0.03677605122, 1.28163874, 5.915006726, 27.29888187, 66.78376177};
  for (int i = 0; i < 5; ++i) CHECK(virgin(law, pair, overlaps[i]).force == Approx(forces[i]).epsilon(1e-9));
  // C of k = C F^beta.
  const NormalResponse<double> at_10um = virgin(law, pair, 10e-6);
  CHECK(at_10um.stiffness / std::pow(at_10um.force, 0.546771) == Approx(4.93804237e5).epsilon(1e-8));
}

TEST_CASE("Pohrt-Popov: stiffness is the force's slope, and goes with its power beta") {
  Random random;
  for (int i = 0; i < cases(1000); ++i) {
    const RoughSurface<double> surface = random_surface(random);
    const Elastic law = Elastic::of(surface);
    const PairProperties<double> pair = random_pair(random);
    const double overlap = law.transition_overlap * random.log_uniform(1e-6, 0.5);
    const NormalResponse<double> here = virgin(law, pair, overlap), deeper = virgin(law, pair, 2 * overlap);
    const double slope = std::log(deeper.stiffness / here.stiffness) / std::log(deeper.force / here.force);
    CHECK(slope == Approx(surface.stiffness_exponent()).epsilon(1e-13));  // logarithms of 1 of numbers 10 eps off

    // F goes with o^q, q from 2 to 4.4: a central difference of relative step s errs by (q-1)(q-2)/6 s^2 < 2 s^2.
    const double s = 1e-5;
    const double rise = virgin(law, pair, overlap * (1 + s)).force - virgin(law, pair, overlap * (1 - s)).force;
    CHECK(here.stiffness == Approx(rise / (2 * s * overlap)).epsilon(1e-9));
    CHECK(here.secant == Approx(here.force / law.indentation(overlap).depth).epsilon(1e-15));
    CHECK(here.max_tangent == here.stiffness);
  }
}

TEST_CASE("Pohrt-Popov: force and slope are continuous at the transition, Hertz's slope beyond") {
  Random random;
  const double eps = std::numeric_limits<double>::epsilon();
  for (int i = 0; i < cases(1000); ++i) {
    const auto surface = random_surface(random);
    const Elastic elastic = Elastic::of(surface);
    const Plastic plastic = Plastic::of(surface);
    const PairProperties<double> pair = random_pair(random);
    const double at = elastic.transition_overlap;
    const auto compare = [&](const auto& law) {
      const NormalResponse<double> below = virgin(law, pair, at * (1 - eps)), above = virgin(law, pair, at);
      CHECK(below.force <= above.force);
      CHECK(below.force == Approx(above.force).epsilon(12 * eps));  // two values 6 ULP off
      CHECK(below.stiffness == Approx(above.stiffness).epsilon(12 * eps));
    };
    compare(elastic);
    compare(plastic);
    const NormalResponse<double> beyond = virgin(elastic, pair, at * random.log_uniform(1.0, 100.0));
    const double hertz =
        std::cbrt(6 * pair.effective_young * pair.effective_young * beyond.force * pair.effective_radius);  // Eq. 1
    CHECK(beyond.stiffness == Approx(hertz).epsilon(12 * eps));
  }
}

TEST_CASE("Pohrt-Popov: without roughness it is Hertz") {
  const PairProperties<double> pair = ballast_pair();
  for (const double overlap : {1e-9, 1e-6, 1e-4}) {
    const double hertz = hertz_response(pair, overlap).force;
    for (const double roughness : {1e-12, 1e-15, 1e-30, 5e-324}) {
      if (overlap < 100 * roughness) continue;
      // Hertz, shifted by o_c - d_c: some five roughnesses at most.
      const double share = 1.5 * 8 * roughness / overlap;
      for (const double fractal_dimension : {2.0, 2.13, 3.0}) {
        CHECK(virgin(Elastic::of({fractal_dimension, roughness}), pair, overlap).force ==
              Approx(hertz).epsilon(share + 1e-15));
        CHECK(virgin(Plastic::of({fractal_dimension, roughness}), pair, overlap).force ==
              Approx(hertz).epsilon(share + 1e-15));
      }
    }
  }
}

TEST_CASE("Pohrt-Popov: two materials, one of them rigid, spheres and walls") {
  const ElasticMaterial<double> soft{5e9, 0.4, 1200.0}, hard{200e9, 0.3, 7800.0};
  const Elastic law = Elastic::of(ballast_surface);
  const auto force = [&law](const ContactBody<double>& a, const ContactBody<double>& b) {
    return virgin(law, pair_properties(a, b), 10e-6).force;
  };
  const ContactBody<double> ball = sphere(soft, 4e-3), rock = sphere(hard, 6e-3);
  // The indentation is the surface's alone: forces go with 4/3 E* sqrt(R*).
  const double depth = law.indentation(10e-6).depth;
  const double compliance = (1 - 0.16) / 5e9 + (1 - 0.09) / 200e9;
  CHECK(force(ball, rock) == Approx(4.0 / 3.0 / compliance * std::sqrt(2.4e-3 * depth) * depth).epsilon(1e-14));
  CHECK(force(ball, rock) == force(rock, ball));
  CHECK(force(ball.rigid(), rock) > force(ball, rock));
  CHECK(force(ball, plane(hard)) == Approx(force(ball, rock) * std::sqrt(4e-3 / 2.4e-3)).epsilon(1e-14));
}

TEST_CASE("Elasto-plastic: virgin curve, or Hertz from the largest overlap") {
  const PairProperties<double> pair = ballast_pair();
  const Elastic elastic = Elastic::of(ballast_surface);
  const Plastic law = Plastic::of(ballast_surface);
  // F = min(F_v(o), k_n max(o - o_p, 0)^(3/2)), o_p := max(o_p, o - (F_v(o)/k_n)^(2/3))
  const double k_n = 4.0 / 3.0 * pair.effective_young * std::sqrt(pair.effective_radius);
  Random random;
  for (int repeat = 0; repeat < cases(200); ++repeat) {
    Plastic::State state;
    double plastic_overlap = 0.0, largest_force = 0.0;
    const double scale = random.log_uniform(1e-7, 5e-4);
    for (int i = 0; i < 20; ++i) {
      const double overlap = scale * random.uniform(0.0, 1.0);
      const double on_curve = virgin(elastic, pair, overlap).force;
      plastic_overlap = std::max(plastic_overlap, overlap - std::pow(on_curve / k_n, 2.0 / 3.0));
      const double expected = std::min(on_curve, k_n * std::pow(std::max(overlap - plastic_overlap, 0.0), 1.5));
      const NormalResponse<double> response = law.respond(state, pair, overlap);
      largest_force = std::max(largest_force, on_curve);
      // This form's plastic overlap is eps o off, times the steepest slope, k = 3/2 F/d with o/d < 1e3.
      CHECK(std::abs(response.force - expected) <= 1e-12 * largest_force);
      CHECK(law.plastic_overlap(state) == Approx(plastic_overlap).epsilon(1e-14).margin(1e-15 * scale));
      CHECK(response.max_tangent >= response.stiffness);
    }
  }
}

TEST_CASE("Elasto-plastic: the tangent of the active branch, which a shear stiffness in constant ratio takes") {
  const PairProperties<double> pair = ballast_pair();
  const Plastic rough = Plastic::of(ballast_surface);
  const ContactLaw<Plastic, NoDashpots<double>, ShearForce<double, ConstantRatio<double>>> law{
      rough, {}, {{0.6}, {1e6}}, {}, {}};
  const double slip = 1e-9, deep = rough.transition_overlap / 3;
  const auto shear_stiffness = [&](double overlap, const auto& state) {
    return -law.step(pair, {{0, 0, 1}, overlap, {slip, 0, 0}, 1.0}, state).force.x() / slip;
  };
  // Virgin: F goes with o^(1/(1 - beta)).
  Plastic::State state;
  const NormalResponse<double> loading = rough.respond(state, pair, deep);
  const double virgin_tangent = loading.force / deep / (1 - ballast_surface.stiffness_exponent());
  CHECK(loading.stiffness == Approx(virgin_tangent).epsilon(1e-13));
  CHECK(shear_stiffness(deep, decltype(law)::State{}) == Approx(0.6 * virgin_tangent).epsilon(1e-13));
  // Unloading: Hertz over the plastic overlap.
  const double half = deep - rough.indentation(deep).depth / 2;
  const NormalResponse<double> unloading = rough.respond(state, pair, half);
  const double elastic_tangent = 1.5 * unloading.force / (half - rough.plastic_overlap(state));
  CHECK(unloading.stiffness == Approx(elastic_tangent).epsilon(1e-12));
  decltype(law)::State loaded{};
  loaded.largest_overlap = deep;
  CHECK(shear_stiffness(half, loaded) == Approx(0.6 * elastic_tangent).epsilon(1e-12));
  CHECK(loading.max_tangent > 1.2 * loading.stiffness);  // or the two could not be told apart
}

TEMPLATE_TEST_CASE("Pohrt-Popov: the next larger overlap never has a smaller force", "", double, float) {
  using T = TestType;
  const PairProperties<T> pair = ballast_pair().cast<T>();
  Random random;
  int falls = 0, slope_falls = 0;
  const auto surface = [&random] {
    return RoughSurface<T>{static_cast<T>(random.uniform(2, 3)), static_cast<T>(random.log_uniform(1e-8, 1e-3))};
  };
  for (int block = 0; block < cases(1000); ++block) {
    const auto elastic = PohrtPopov<T>::of(surface());
    const auto plastic = slot_cast<T>(PohrtPopovElastoPlastic<T>{{elastic.exponent, elastic.transition_overlap}});
    const T largest = elastic.transition_overlap * static_cast<T>(random.log_uniform(1e-3, 10.0));
    // Start anywhere, or just below a place where the formula changes.
    const T starts[] = {elastic.transition_overlap * static_cast<T>(random.log_uniform(1e-9, 10.0)),
                        elastic.transition_overlap, largest, plastic.plastic_overlap({largest}),
                        largest * static_cast<T>(random.uniform(0.5, 1.0))};
    for (const T& start : starts) {
      T overlap = start;
      for (int i = 0; i < 60; ++i) overlap = std::nextafter(overlap, T(0));
      T elastic_before(0), stiffness_before(0), plastic_before(0);
      for (int i = 0; i < 120; ++i) {
        typename PohrtPopovElastoPlastic<T>::State state{largest};
        const NormalResponse<T> response = virgin(elastic, pair, overlap);
        const T reloaded = plastic.respond(state, pair, overlap).force;
        if (response.force < elastic_before || reloaded < plastic_before) ++falls;
        if (response.stiffness < stiffness_before) ++slope_falls;
        elastic_before = response.force;
        stiffness_before = response.stiffness;
        plastic_before = reloaded;
        overlap = std::nextafter(overlap, T(1));
      }
    }
  }
  CHECK(falls == 0);
  CHECK(slope_falls == 0);
}

TEST_CASE("Elasto-plastic: unloading never lies above loading") {
  Random random;
  int above = 0;
  for (int i = 0; i < cases(200000); ++i) {
    const Plastic law = Plastic::of(random_surface(random));
    const PairProperties<double> pair = ballast_pair();
    const double largest = law.transition_overlap * random.log_uniform(1e-6, 10.0);
    const double share = random.chance(0.3) ? 1.0 - random.log_uniform(1e-15, 1e-3) : random.uniform(0.0, 1.0);
    Plastic::State state{largest};
    const double unloading = law.respond(state, pair, largest * share).force;
    const NormalResponse<double> loading = virgin(law, pair, largest * share);
    // Both indentations are 3 ULP of the larger one off; the force follows with Hertz's slope.
    const double rounding = 6 * std::numeric_limits<double>::epsilon() * law.indentation(largest).depth;
    if (unloading > loading.force + loading.max_tangent * rounding) ++above;
  }
  CHECK(above == 0);
}

TEST_CASE("Rough laws: no closed path gains energy") {
  // Random walks on a grid of overlaps, back to the start: what trapezia miss on the way up they miss on the way down.
  Random random;
  double greatest_gain = 0.0;
  for (int repeat = 0; repeat < cases(2000); ++repeat) {
    const auto surface = random_surface(random);
    const Elastic elastic = Elastic::of(surface);
    const Plastic plastic = Plastic::of(surface);
    const PairProperties<double> pair = ballast_pair();
    const double grid = elastic.transition_overlap * random.log_uniform(1e-4, 0.1);
    Elastic::State none;
    Plastic::State state;
    std::vector<double> overlaps, elastic_forces, plastic_forces;
    int place = 0, turning = 0;
    const auto visit = [&] {
      overlaps.push_back(place * grid);
      elastic_forces.push_back(elastic.respond(none, pair, overlaps.back()).force);
      plastic_forces.push_back(plastic.respond(state, pair, overlaps.back()).force);
    };
    const int begin = place = static_cast<int>(random.uniform(0, 20));
    visit();
    for (int i = 0; i < 8; ++i) {
      turning = i == 7 ? begin : static_cast<int>(random.uniform(0, 60));
      while (place != turning) {
        place += place < turning ? 1 : -1;
        visit();
      }
    }
    const double most = *std::max_element(elastic_forces.begin(), elastic_forces.end()) * 60 * grid;
    const double of_elastic = trapezia(overlaps, elastic_forces), of_plastic = trapezia(overlaps, plastic_forces);
    // Some hundred terms, each right to 6 eps.
    CHECK(std::abs(of_elastic) <= 1e-13 * most);
    CHECK(of_plastic >= -1e-13 * most);
    greatest_gain = std::max(greatest_gain, -of_plastic / most);
  }
  std::cout << "Elasto-plastic, largest gain of energy on 2000 closed paths: " << greatest_gain
            << " of largest force times overlap\n";
}

TEST_CASE("Elasto-plastic: the area of a loop, and work = stored + dissipated") {
  Random random;
  for (int i = 0; i < cases(300); ++i) {
    const auto surface = random_surface(random);
    const Plastic law = Plastic::of(surface);
    const PairProperties<double> pair = ballast_pair();
    const double largest = law.transition_overlap * random.log_uniform(1e-3, 10.0);
    const double bend = std::min(largest, law.transition_overlap);
    const auto loading = [&](double overlap) { return virgin(law, pair, overlap).force; };
    const auto unloading = [&](double overlap) {
      Plastic::State state{largest};
      return law.respond(state, pair, overlap).force;
    };
    // Pieces end where the formula changes. Overlaps as squares: forces that start as o^1.5 or o^2.05 are smooth then.
    const auto from = [](const auto& force, double start, double end) {
      return integral([&](double u) { return force(start + u * u) * 2 * u; }, 0.0, std::sqrt(end - start), 40);
    };
    const double work = from(loading, 0.0, bend) + integral(loading, bend, largest, 40);
    const double plastic_overlap = law.plastic_overlap({largest});
    const double turn = plastic_overlap + (largest - plastic_overlap) * random.uniform(0.01, 1.0);
    const double returned = from(unloading, plastic_overlap, largest);
    const double still_stored = from(unloading, plastic_overlap, turn);
    // To 1e-9 of the work: what 40 pieces leave, and the rounding of the plastic overlap.
    const double margin = 1e-9 * work;
    CHECK(law.energy({largest}, pair, largest) == Approx(returned).margin(margin));
    CHECK(law.energy({largest}, pair, turn) == Approx(still_stored).margin(margin));
    CHECK(law.plastic_dissipation({largest}, pair) == Approx(work - returned).margin(margin));
    CHECK(Elastic::of(surface).energy({}, pair, largest) == Approx(work).margin(margin));
    if (largest < law.transition_overlap) {  // closed form: F_m (o_m / (q + 1) - 2/5 d_m), F = o^q
      const double force = loading(largest), q = 1.0 / (1.0 - surface.stiffness_exponent());
      CHECK(work - returned == Approx(force * (largest / (q + 1) - 0.4 * (largest - plastic_overlap))).margin(margin));
    }
    CHECK(law.energy({largest}, pair, plastic_overlap * 0.999) == 0.0);
  }
}

TEST_CASE("Pohrt-Popov: overlap and indentation invert each other") {
  Random random;
  for (int i = 0; i < cases(10000); ++i) {
    const Elastic law = Elastic::of(random_surface(random));
    const double x = random.log_uniform(1e-9, 100.0);
    const double overlap = law.transition_overlap * x;
    // 1/p is half an eps off, and stands over the logarithm of the indentation.
    const double tolerance = 1e-15 * (3.0 + law.exponent * std::abs(std::log(x)));
    CHECK(law.overlap_of(law.indentation(overlap).depth) == Approx(overlap).epsilon(tolerance));
    CHECK(law.indentation(law.overlap_of(overlap)).depth == Approx(overlap).epsilon(3 * tolerance));
  }
  CHECK(Elastic::of(ballast_surface).overlap_of(0.0) == 0.0);
}

TEST_CASE("Rough laws: no branch is stiffer than the stiffness for the time step") {
  Random random;
  for (int i = 0; i < cases(5000); ++i) {
    const auto surface = random_surface(random);
    const PairProperties<double> pair = ballast_pair();
    const ContactLaw<Elastic> elastic{Elastic::of(surface), {}, {}, {}};
    const ContactLaw<Plastic> plastic{Plastic::of(surface), {}, {}, {}};
    const double largest = elastic.normal.transition_overlap * random.log_uniform(1e-3, 10.0);
    const double overlap = largest * random.uniform(0.01, 1.2);
    const double step = overlap * 1e-4;
    const auto observed = [&](const auto& law, auto state) {
      double most = 0.0;
      const double force = law.normal.respond(state, pair, overlap).force;
      for (const double to : {overlap - step, overlap + step}) {
        auto next = state;
        most = std::max(most, (law.normal.respond(next, pair, to).force - force) / (to - overlap));
      }
      // A convex curve's chord over this step is steeper than its tangent: by 1e-4 times d ln k/d ln o <= 3.4, over 2;
      // for an unloading contact with d in place of o, where a chord may also begin at the reopening.
      const double depth = force > 0 ? 1.5 * force / law.stiffness(pair, overlap, state).normal : 0.0;
      if (depth < 10 * step) return;
      CHECK(most <= law.stiffness(pair, overlap, state).normal * (1 + 2 * step / depth));
    };
    observed(elastic, decltype(elastic)::State{});
    typename decltype(plastic)::State loaded{};
    loaded.largest_overlap = largest;
    observed(plastic, loaded);
    observed(plastic, decltype(plastic)::State{});
  }
}

TEST_CASE("Elasto-plastic: a contact says where on its history it stands") {
  const PairProperties<double> pair = ballast_pair();
  const Plastic law = Plastic::of(ballast_surface);
  Plastic::State state;
  const auto step_to = [&](double overlap, double separating) {
    const Loading loading = law.loading(state, overlap, separating);
    law.respond(state, pair, overlap);
    return loading;
  };
  CHECK(step_to(-1e-6, -1.0) == Loading::open);
  CHECK(step_to(0.0, -1.0) == Loading::open);
  CHECK(step_to(10e-6, -1.0) == Loading::virgin);
  CHECK(step_to(20e-6, -1.0) == Loading::virgin);
  CHECK(step_to(19e-6, 1.0) == Loading::unloading);
  CHECK(step_to(18e-6, 1.0) == Loading::unloading);
  CHECK(step_to(19e-6, -1.0) == Loading::reloading);
  const double reopening = law.plastic_overlap(state);
  CHECK(step_to(reopening * 1.001, 1.0) == Loading::unloading);
  CHECK(step_to(reopening * 0.999, 1.0) == Loading::open);  // no force: counted as apart, as the paper does
  CHECK(step_to(reopening * 1.001, -1.0) == Loading::reloading);
  CHECK(step_to(21e-6, -1.0) == Loading::virgin);
}

TEST_CASE("Elasto-plastic: what is left of the history after separation is a choice") {
  const PairProperties<double> pair = ballast_pair();
  using SameSpot = PohrtPopovElastoPlastic<double, Recontact::same_spot>;
  const ContactLaw<SameSpot> same{SameSpot::of(ballast_surface), {}, {}, {}, {}};
  const ContactLaw<Plastic> fresh{Plastic::of(ballast_surface), {}, {}, {}, {}};  // the default
  static_assert(decltype(same)::outlives_separation && !decltype(fresh)::outlives_separation);
  const auto forces = [&pair](const auto& law) {
    typename std::decay_t<decltype(law)>::State state{};
    std::vector<double> result;
    for (const double overlap : {20e-6, 15e-6, 1e-9, 15e-6, -1e-9, 15e-6}) {
      const auto step = law.step(pair, {Vec3<double>::UnitX(), overlap, Vec3<double>::Zero(), 1e-6}, state);
      state = step.state;
      result.push_back(step.normal_elastic);
    }
    return result;
  };
  const std::vector<double> of_same = forces(same), of_fresh = forces(fresh);
  const double first_time = virgin(same.normal, pair, 15e-6).force;
  CHECK(of_same[1] < first_time);
  CHECK(of_same[2] == 0.0);
  CHECK(of_same[3] == of_same[1]);  // without force, but not apart: both keep their history
  CHECK(of_fresh[3] == of_same[1]);
  CHECK(of_same[5] == of_same[1]);
  CHECK(of_fresh[5] == first_time);
}

TEST_CASE("Elasto-plastic: a hundred thousand cycles change no bit") {
  const PairProperties<double> pair = ballast_pair();
  const Plastic law = Plastic::of(ballast_surface);
  Plastic::State state;
  const double first = law.respond(state, pair, 20e-6).force, half = law.respond(state, pair, 15e-6).force;
  int changes = 0;
  for (int i = 0; i < cases(100000); ++i) {
    law.respond(state, pair, 0.0);
    if (law.respond(state, pair, 15e-6).force != half) ++changes;
    if (law.respond(state, pair, 20e-6).force != first) ++changes;
    if (state.largest_overlap != 20e-6) ++changes;
  }
  CHECK(changes == 0);
}

TEST_CASE("Rough laws in a composition: dashpots, shear in a constant ratio, a bridge") {
  const PairProperties<double> pair = ballast_pair();
  const Plastic rough = Plastic::of(ballast_surface);
  using Law = ContactLaw<Plastic, Dashpots<double>, ShearForce<double, ConstantRatio<double>>, SuctionBridge<double>>;
  Law law{rough, {0.1}, {}, {2e4, 2.0, 2.0}};
  law.shear.ratio = mindlin_ratio(pair);
  law.shear.friction = 0.7;
  Law::State state{};
  Law::make_wet(state, 0.0, 0.0);
  const Vec3<double> n = Vec3<double>::UnitX();
  const double dt = 1e-6;
  state = law.step(pair, {n, 20e-6, Vec3<double>::Zero(), dt}, state).state;

  const double turn = 15e-6;
  const Vec3<double> velocity(1e-3, 1e-4, 0.0);
  const auto step = law.step(pair, {n, turn, velocity, dt}, state);
  Plastic::State unloading{20e-6};
  const NormalResponse<double> normal = rough.respond(unloading, pair, turn);
  const double depth = turn - rough.plastic_overlap(unloading);
  const double ratio = 2 * (1 - 0.25) / (2 - 0.25);
  CHECK(normal.stiffness == Approx(1.5 * normal.force / depth).epsilon(1e-13));  // the tangent of the unloading branch
  CHECK(step.normal_elastic == normal.force);
  CHECK(step.bridge_force == Approx(2e4 * pi<double>() * 4.72e-3 * 4.72e-3).epsilon(1e-14));
  const double dashpot =
      0.1 * std::sqrt(pair.effective_mass * normal.force / depth);  // Potyondy (2019) Eq. 13, with d for o
  CHECK(step.normal_force == Approx(normal.force - dashpot * 1e-3).epsilon(1e-13));
  const double spring = ratio * normal.stiffness * 1e-4 * dt;
  const double shear_dashpot = 0.1 * std::sqrt(pair.effective_mass * ratio * normal.stiffness) * 1e-4;
  CHECK(-step.force.y() == Approx(spring + shear_dashpot).epsilon(1e-13));
  CHECK_FALSE(step.sliding);
  CHECK(law.interaction_range(pair) == Approx(2 * 4.72e-3).epsilon(1e-15));
  CHECK(law.step(pair, {n, turn, Vec3<double>(0.0, 1e3, 0.0), dt}, state).sliding);

  const ContactStiffness<double> stiffness = law.stiffness(pair, turn, state);
  CHECK(stiffness.normal == Approx(normal.stiffness * law.damping.stiffness_factor()).epsilon(1e-15));
  CHECK(stiffness.shear == Approx(ratio * stiffness.normal).epsilon(1e-15));
  CHECK(sizeof(RoughBallast<double>::State) == 4 * sizeof(double));
  CHECK(sizeof(ContactLaw<Elastic>::State) == 1);  // no history
}

TEST_CASE("Rough laws: the ledger balances along a random impact") {
  const PairProperties<double> pair = ballast_pair();
  const ContactLaw<Plastic> law{Plastic::of(ballast_surface), {}, {}, {}};
  EnergyLedger<double> ledger;
  ContactLaw<Plastic>::State state{};
  const int steps = 20000;
  double before = 0.0, yielding = 0.0;
  for (int i = 1; i <= steps; ++i) {
    const double overlap = 20e-6 * std::sin(3.0 * i / steps);
    const Vec3<double> velocity(before - overlap, 0.0, 0.0);
    const ContactKinematics<double> kinematics{Vec3<double>::UnitX(), overlap, velocity, 1.0};
    const auto step = law.step(pair, kinematics, state);
    ledger.enter(law, pair, kinematics, step);
    yielding += dissipation(law, pair, state, step).yielding;
    state = step.state;
    before = overlap;
  }
  // Trapezia: 1/12 of the square of the step, relative to the work.
  CHECK(ledger.dissipated() == Approx(law.normal.plastic_dissipation(state, pair)).epsilon(1e-6));
  CHECK(yielding == Approx(ledger.dissipated()).epsilon(1e-6));
}

TEST_CASE("Pohrt-Popov: parameters out of range are named with value and range") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const auto surface_message = [](double fractal_dimension, double roughness) -> std::string {
    try {
      Plastic::of({fractal_dimension, roughness});
    } catch (const std::invalid_argument& fault) {
      return fault.what();
    }
    return "accepted";
  };
  CHECK(surface_message(2.0, 1e-6) == "accepted");
  CHECK(surface_message(3.0, 1e-6) == "accepted");
  CHECK(surface_message(1.875, 1e-6) == "RoughSurface: fractal_dimension is 1.875, must lie in [2, 3]");
  CHECK(surface_message(3.5, 1e-6) == "RoughSurface: fractal_dimension is 3.5, must lie in [2, 3]");
  CHECK(surface_message(nan, 1e-6) == "RoughSurface: fractal_dimension is nan, must lie in [2, 3]");
  CHECK(surface_message(2.5, 0.0) == "RoughSurface: roughness is 0 m, must lie in (0, inf)");
  CHECK(surface_message(2.5, -0.5) == "RoughSurface: roughness is -0.5 m, must lie in (0, inf)");
  CHECK(surface_message(2.5, inf) == "RoughSurface: roughness is inf m, must lie in (0, inf)");
  CHECK(surface_message(2.5, nan) == "RoughSurface: roughness is nan m, must lie in (0, inf)");
  CHECK_THROWS_WITH(Elastic::of({1.5, 1e-6}), ContainsSubstring("fractal_dimension is 1.5"));
  // Given directly, not from a surface.
  CHECK_THROWS_WITH(checked(Elastic{{2.0, 0.0}}), "PohrtPopov: transition_overlap is 0 m, must lie in (0, inf)");
  CHECK_THROWS_WITH(checked(Plastic{{0.5, 1e-5}}), "PohrtPopovElastoPlastic: exponent is 0.5, must lie in (1, 3]");
  CHECK_NOTHROW(checked(Plastic::of(ballast_surface)));
}

}  // namespace contactlaws::test
