// Item 1: the largest error of every kernel, in double and in float, against the same template at 200 bits.
#include "contactlaws/contactlaws.hpp"
#include "contactlaws/damping/restitution.hpp"
#include "contactlaws/timestep.hpp"
#include "judge.hpp"

using namespace contactlaws;
using namespace contactlaws::test;

namespace {

constexpr double of_roots = 3.0;   ///< the target where only + - * / and square roots come in [ULP]
constexpr double of_powers = 6.0;  ///< where pow, exp or log do [ULP]

template <class S>
PairProperties<S> pair_of(const S& radius, const S& young, const S& shear = S(1)) {
  return {radius, young, shear, S(1), radius, radius};
}

template <class T>
class Kernels {
 public:
  explicit Kernels(const Effort& effort) : roots_(effort(300000, 100000000)), powers_(effort(100000, 100000000)) {}

  void pairs() const {
    const auto draw = [](Random& r) {
      const auto poisson = [&r] {
        const T near_edge = r.binary<T>(-20, -3);
        return r.chance(0.2) ? T(T(-1) + near_edge) : r.chance(0.25) ? T(0.5) : static_cast<T>(r.uniform(-0.9, 0.5));
      };
      const T young = r.binary<T>(10, 40), other_young = r.binary<T>(10, 40);
      return std::array<T, 8>{young,       poisson(), r.binary<T>(5, 15), r.binary<T>(-20, 4),
                              other_young, poisson(), r.binary<T>(5, 15), r.binary<T>(-20, 4)};
    };
    const auto pair = [](const auto& x) {
      using S = std::decay_t<decltype(x[0])>;
      return pair_properties(sphere(ElasticMaterial<S>{x[0], x[1], x[2]}, x[3]),
                             sphere(ElasticMaterial<S>{x[4], x[5], x[6]}, x[7]));
    };
    const std::string inputs = "E1 nu1 rho1 R1 E2 nu2 rho2 R2";
    roots(
        "pair.effective_radius", inputs, [pair](const auto& x) { return pair(x).effective_radius; }, draw);
    roots(
        "pair.effective_young", inputs, [pair](const auto& x) { return pair(x).effective_young; }, draw,
        "a chain of 7 roundings, once per pair");
    roots(
        "pair.effective_shear", inputs, [pair](const auto& x) { return pair(x).effective_shear; }, draw,
        "a chain of 9 roundings, once per pair");
    roots(
        "pair.effective_mass", inputs, [pair](const auto& x) { return pair(x).effective_mass; }, draw,
        "a chain of 10 roundings (4/3 pi R R R rho, inverted, summed, inverted), once per pair");
  }

  void hertz() const {
    const auto draw = [](Random& r) {
      return std::array<T, 3>{r.binary<T>(-30, 8), r.binary<T>(10, 40), r.binary<T>(smallest_exponent<T>, 4)};
    };
    const auto response = [](const auto& x) { return hertz_response(pair_of(x[0], x[1]), x[2]); };
    roots(
        "hertz.force", "R* E* o", [response](const auto& x) { return response(x).force; }, draw,
        "six roundings in a chain");
    roots(
        "hertz.stiffness", "R* E* o", [response](const auto& x) { return response(x).stiffness; }, draw);
    roots(
        "hertz.secant", "R* E* o", [response](const auto& x) { return response(x).secant; }, draw,
        "a product more than the stiffness, with a rounded 2/3");
    roots(
        "hertz.energy", "R* E* o", [](const auto& x) { return hertz_energy(pair_of(x[0], x[1]), x[2]); }, draw,
        "two products more than the force; no step reads it");
    roots(
        "mindlin.stiffness", "R* G* o",
        [](const auto& x) {
          using S = std::decay_t<decltype(x[0])>;
          const PairProperties<S> pair = pair_of(x[0], S(1), x[1]);
          return Mindlin<S>{}.stiffness(pair, hertz_response(pair, x[2]));
        },
        draw);
  }

  void adhesion_and_rolling() const {
    // Beside the pull, so that the error is in eps of the larger term: the force is their difference.
    roots(
        "dmt.force and its pull", "w R* E* o",
        [](const auto& x) {
          using S = std::decay_t<decltype(x[0])>;
          const PairProperties<S> pair = pair_of(x[1], x[2]);
          const Dmt<S> law{x[0]};
          typename Dmt<S>::State none;
          return Vec3<S>(law.respond(none, pair, x[3]).force, law.pull_off_force(pair), S(0));
        },
        [](Random& r) {
          return std::array<T, 4>{r.binary<T>(-20, 4), r.binary<T>(-20, 0), r.binary<T>(20, 40), r.binary<T>(-40, -10)};
        },
        "the roundings of the force, and one of the difference");
    roots(
        "rolling.couple", "mu_r R* k_n w dt P",
        [](const auto& x) {
          using S = std::decay_t<decltype(x[0])>;
          typename RollingSpring<S>::State none{};
          const PairProperties<S> pair = pair_of(x[1], S(1));
          const ContactKinematics<S> k{{S(0), S(0), S(1)},    S(1), {S(0), S(0), S(0)}, x[4], S(0),
                                       {x[3], S(-x[3]), S(1)}};
          return Vec3<S>(RollingSpring<S>{x[0]}.respond(none, {pair, k, x[2], x[5]}).couple);
        },
        [](Random& r) {
          return std::array<T, 6>{r.binary<T>(-10, 0), r.binary<T>(-20, 0),  r.binary<T>(10, 30),
                                  r.binary<T>(-5, 5),  r.binary<T>(-30, -5), r.binary<T>(-10, 20)};
        },
        "k_r is a chain of five roundings");
    // Spring and dashpot from no history, so that both have one sign.
    roots(
        "twisting.couple with dashpot", "alpha_t R* E* G* k_n m* w dt",
        [](const auto& x) {
          using S = std::decay_t<decltype(x[0])>;
          typename TwistingSpring<S>::State none{};
          const PairProperties<S> pair{x[1], x[2], x[3], x[5], x[1], x[1]};
          const ContactKinematics<S> k{{S(0), S(0), S(1)}, S(1), {S(0), S(0), S(0)}, x[7], S(0), {S(0), S(0), x[6]}};
          return TwistingSpringDashpot<S>{{S(1e9), x[0]}}.respond(none, {pair, k, x[4], S(1e9)}).couple.z();
        },
        [](Random& r) {
          return std::array<T, 8>{r.binary<T>(-10, 2), r.binary<T>(-20, 0), r.binary<T>(20, 30), r.binary<T>(20, 30),
                                  r.binary<T>(10, 20), r.binary<T>(-30, 0), r.binary<T>(-5, 5),  r.binary<T>(-20, -5)};
        },
        "k_t and c_t are chains of six roundings, and then a sum");
  }

  void yield() const {
    roots(
        "thornton_ning.loading force", "p_y R* E* o",
        [](const auto& x) {
          using S = std::decay_t<decltype(x[0])>;
          typename ThorntonNing<S>::State none{};
          return ThorntonNing<S>{x[0]}.respond(none, pair_of(x[1], x[2]), x[3]).force;
        },
        [](Random& r) {
          return std::array<T, 4>{r.binary<T>(10, 30), r.binary<T>(-20, 0), r.binary<T>(25, 40), r.binary<T>(-40, -5)};
        },
        "the yield overlap is a chain of five roundings, three times a square");
    roots(
        "linear_hysteretic.loading force", "k_1 k_2 phi R* o",
        [](const auto& x) {
          using S = std::decay_t<decltype(x[0])>;
          typename LinearHysteretic<S>::State none{};
          return LinearHysteretic<S>{x[0], S(x[0] * x[1]), S(0), x[2]}.respond(none, pair_of(x[3], S(1)), x[4]).force;
        },
        [](Random& r) {
          return std::array<T, 5>{r.binary<T>(10, 30), T(1) + r.binary<T>(-4, 6), r.binary<T>(-10, 0),
                                  r.binary<T>(-20, 0), r.binary<T>(-40, -5)};
        },
        "beyond the plastic depth the roundings of it count k_2/k_1 times");
  }

  void linear() const {
    const auto draw = [](Random& r) {
      const T smaller = r.binary<T>(-30, 8);
      return std::array<T, 4>{r.binary<T>(10, 40), smaller, smaller * r.binary<T>(0, 6),
                              r.binary<T>(smallest_exponent<T>, 4)};
    };
    roots(
        "linear.force", "k o",
        [](const auto& x) {
          using S = std::decay_t<decltype(x[0])>;
          typename LinearSpring<S>::State none;
          return LinearSpring<S>{x[0]}.respond(none, pair_of(S(1), S(1)), x[1]).force;
        },
        [draw](Random& r) {
          const auto x = draw(r);
          return std::array<T, 2>{x[0], x[3]};
        });
    roots(
        "linear.force from a modulus", "E r L o",
        [](const auto& x) {
          using S = std::decay_t<decltype(x[0])>;
          typename LinearModulus<S>::State none;
          return LinearModulus<S>{x[0]}.respond(none, {S(1), S(1), S(1), S(1), x[1], x[2]}, x[3]).force;
        },
        draw, "k = E pi r (r/L) is computed anew at each step: five roundings and that of pi");
  }

  void dashpots() const {
    roots(
        "dashpots.coefficient", "alpha m* k",
        [](const auto& x) {
          using S = std::decay_t<decltype(x[0])>;
          return Dashpots<S>{x[0]}.coefficients(x[1], S(1), x[2]).shear;
        },
        [](Random& r) {
          return std::array<T, 3>{r.binary<T>(-20, 1), r.binary<T>(-60, 20), r.binary<T>(-40, 40)};
        });
    roots(
        "dashpots.stiffening", "alpha",
        [](const auto& x) { return Dashpots<std::decay_t<decltype(x[0])>>{x[0]}.stiffness_factor(); },
        [](Random& r) { return std::array<T, 1>{r.binary<T>(-20, 4)}; },
        "a square doubles the error of the root; enters only the estimate of a stable step");
    const auto draw = [](Random& r) {
      const auto way = r.engine() % 3;
      const double e = way == 0   ? r.uniform(0.0, 1.0)
                       : way == 1 ? r.log_uniform(0.01, 1.0)
                                  : std::exp(-2.0) * (1.0 + r.uniform(-3e-3, 3e-3));  // about critical damping
      return std::array<T, 1>{maximum(static_cast<T>(e), T(0.01))};
    };
    for (const Tension tension : {Tension::allowed, Tension::clipped}) {
      const std::string which = tension == Tension::allowed ? ", tension allowed" : ", tension clipped";
      few_powers(
          "restitution.alpha of e" + which, "e",
          [tension](const auto& x) { return damping_constant(x[0], Spring::hertz, tension); }, draw,
          "far from e = 1 alpha inherits the ULPs of ln e; computed once per law");
      few_powers(
          "restitution.e of alpha" + which, "alpha",
          [tension](const auto& x) { return restitution(x[0], Spring::hertz, tension); },
          [draw, tension](Random& r) { return std::array<T, 1>{damping_constant(draw(r)[0], Spring::hertz, tension)}; },
          "e = exp(-d): the roundings of d count |ln e| times; a question, not part of a step");
    }
  }

  void bridge() const {
    // A length R_o of the decay, so that x = gap/lambda is what is drawn.
    const auto force = [](const auto& x) {
      using S = std::decay_t<decltype(x[0])>;
      typename SuctionBridge<S>::State wet{S(2)};
      return SuctionBridge<S>{x[0], x[1], S(1e6)}.respond(wet, pair_of(x[2], S(1)), S(-x[3])).force;
    };
    const auto draw = [](double most) {
      return [most](Random& r) {
        const T decay = r.binary<T>(-3, 3), radius = r.binary<T>(-30, 8);
        const T share =
            r.chance(0.5) ? static_cast<T>(r.uniform(0.0, most)) : static_cast<T>(r.log_uniform(1e-20, most));
        return std::array<T, 4>{r.binary<T>(-10, 30), decay, radius, share * decay * radius};
      };
    };
    powers("bridge.force, gap <= a decay length", "psi lambda/R_o R_o gap", force, draw(1.0));
    powers("bridge.force, gap <= 8 decay lengths", "psi lambda/R_o R_o gap", force, draw(8.0),
           "exp(-x) multiplies the two roundings of x = gap/lambda by x");
  }

  void rough() const {
    const auto of = [](const auto& x) {
      using S = std::decay_t<decltype(x[0])>;
      PohrtPopovElastoPlastic<S> law;
      law.exponent = x[0];
      law.transition_overlap = x[1];
      return law;
    };
    const auto response = [of](const auto& x) {
      using S = std::decay_t<decltype(x[0])>;
      typename PohrtPopovElastoPlastic<S>::State state{x[5]};
      return of(x).respond(state, pair_of(x[2], x[3]), x[4]);
    };
    const auto draw = [](double steepest) {
      return [steepest](Random& r) {
        const T transition = r.binary<T>(-30, 0);
        const auto way = r.engine() % 4;  // anywhere, about the transition, near it
        const T overlap =
            way == 0   ? r.binary<T>(smallest_exponent<T> / 2, 4)
            : way == 1 ? T(transition * (T(1) + std::numeric_limits<T>::epsilon() * static_cast<T>(r.uniform(-20, 20))))
                       : T(transition * static_cast<T>(r.log_uniform(1e-9, 1e3)));
        const double exponent = r.chance(0.1) ? steepest : r.uniform(1.37, steepest);  // p of D_f = 2 to ...
        return std::array<T, 6>{static_cast<T>(exponent), transition, r.binary<T>(-30, 8),
                                r.binary<T>(10, 40),      overlap,    T(0)};
      };
    };
    const std::string inputs = "p o_c R* E* o o_m";
    const char* x_counts = "a rounding of x = o/o_c counts 3/2 (p - 1) times, on top of pow and Hertz";
    const auto force = [response](const auto& x) { return response(x).force; };
    powers("pohrt_popov.force, D_f <= 2.4", inputs, force, draw(1.735), x_counts);
    powers("pohrt_popov.force", inputs, force, draw(2.9), x_counts);
    const auto stiffness = [response](const auto& x) { return response(x).stiffness; };
    powers("pohrt_popov.stiffness", inputs, stiffness, [draw, of](Random& r) {
      auto x = draw(2.9)(r);
      while (of(x).indentation(x[4]).depth < std::numeric_limits<T>::min()) x = draw(2.9)(r);
      return x;
    });
    powers(
        "pohrt_popov.stiffness, d denormal", inputs, stiffness,
        [draw, of](Random& r) {
          auto x = draw(2.9)(r);
          while (of(x).indentation(x[4]).depth >= std::numeric_limits<T>::min()) x = draw(2.9)(r);
          return x;
        },
        "the stiffness is taken from the indentation, which has lost its digits there; the force has not");
    powers(
        "pohrt_popov.stored energy", inputs,
        [of](const auto& x) { return of(x).energy({}, pair_of(x[2], x[3]), x[4]); }, draw(2.9),
        "the error of the indentation counts 5/2 times; no step reads it");
    // Unloading to a share of the largest indentation that keeps the subtraction harmless.
    powers(
        "pohrt_popov.unloading force, d >= d(o_m)/2", inputs, force,
        [draw, of](Random& r) {
          auto x = draw(2.9)(r);
          x[4] = x[1] * static_cast<T>(r.log_uniform(1e-6, 1e2));
          x[5] = x[4];
          const T deepest = of(x).indentation(x[5]).depth;
          x[4] = x[5] - deepest * static_cast<T>(r.uniform(0.0, 0.5));
          if (x[5] - x[4] > deepest / T(2)) x[4] = x[5];  // the rounding of o took more than half
          return x;
        },
        "d = d(o_m) - (o_m - o): the ULPs of d(o_m), a power, count up to 3/2 * 2 times");
  }

  void vectors() const {
    const auto vector = [](const auto& x, std::size_t at) {
      using S = std::decay_t<decltype(x[0])>;
      return Vec3<S>(x[at], x[at + 1], x[at + 2]);
    };
    const auto component = [](Random& r) { return static_cast<T>(r.uniform(-1.0, 1.0)); };
    roots(
        "shear.friction limit", "Fx Fy Fz limit",
        [vector](const auto& x) {
          using S = std::decay_t<decltype(x[0])>;
          const Vec3<S> force = vector(x, 0);
          return Vec3<S>(force * detail::length_limit<S>(force, x[3], x[3]).factor);
        },
        [component](Random& r) {
          const T size = r.binary<T>(smallest_exponent<T> / 4, 60), limit = r.binary<T>(-30, 0);
          return std::array<T, 4>{size * component(r), size * component(r), size * component(r), size * limit};
        });
    roots(
        "kinematics.normal", "x1 y1 z1 x2 y2 z2",
        [vector](const auto& x) {
          using S = std::decay_t<decltype(x[0])>;
          return sphere_sphere<S>(vector(x, 0), S(1), vector(x, 3), S(1)).normal;
        },
        [component](Random& r) {
          return std::array<T, 6>{component(r),        component(r),        component(r),
                                  component(r) + T(3), component(r) + T(3), component(r)};
        });
    const auto turn = [component](Random& r) {
      const Vec3<double> from = r.direction(), to = (from + r.log_uniform(1e-9, 1.0) * r.direction()).normalized();
      const Vec3<double> shear = r.direction_across(from);
      const auto at = [](const Vec3<double>& v, int i) { return static_cast<T>(v[i]); };
      return std::array<T, 10>{
          at(from, 0), at(from, 1),  at(from, 2),  at(to, 0),    at(to, 1),
          at(to, 2),   at(shear, 0), at(shear, 1), at(shear, 2), r.chance(0.5) ? T(0) : component(r)};
    };
    const auto turned = [vector](const auto& x, auto state) {
      using S = std::decay_t<decltype(x[0])>;
      using Rotation = typename decltype(state)::type;
      typename Rotation::State memory{};
      Rotation::apply(memory, Vec3<S>(S(0), S(0), S(0)), vector(x, 0), S(0));
      return Vec3<S>(Rotation::apply(memory, vector(x, 6), vector(x, 3), x[9]));
    };
    const std::string inputs = "nx ny nz n'x n'y n'z sx sy sz twist";
    roots(
        "rotation.project", inputs,
        [turned](const auto& x) { return turned(x, Carrier<rotation::Project<std::decay_t<decltype(x[0])>>>{}); },
        turn);
    roots(
        "rotation.project and restore", inputs,
        [turned](const auto& x) {
          return turned(x, Carrier<rotation::ProjectRestore<std::decay_t<decltype(x[0])>>>{});
        },
        turn, "near a right angle most of the shear lies along the new normal: |s|^2 less that part cancels");
    powers(
        "rotation.rotate", inputs,
        [turned](const auto& x) { return turned(x, Carrier<rotation::Rotate<std::decay_t<decltype(x[0])>>>{}); }, turn);
  }

 private:
  template <class Rotation>
  struct Carrier {
    using type = Rotation;
  };

  template <class Kernel, class Draw>
  void roots(const std::string& name, const std::string& inputs, const Kernel& kernel, const Draw& draw,
             const char* reason = "") const {
    judge<T>({1, name, 0.0, "", of_roots, roots_, "", reason}, inputs, kernel, draw);
  }
  template <class Kernel, class Draw>
  void powers(const std::string& name, const std::string& inputs, const Kernel& kernel, const Draw& draw,
              const char* reason = "") const {
    judge<T>({1, name, 0.0, "", of_powers, powers_, "", reason}, inputs, kernel, draw);
  }
  /// Restitution solves an equation by iteration: a tenth of the inputs.
  template <class Kernel, class Draw>
  void few_powers(const std::string& name, const std::string& inputs, const Kernel& kernel, const Draw& draw,
                  const char* reason) const {
    judge<T>({1, name, 0.0, "", of_powers, (powers_ + 9) / 10, "", reason}, inputs, kernel, draw);
  }

  std::int64_t roots_, powers_;
};

template <class T>
void judge_all(const Effort& effort) {
  const Kernels<T> kernels(effort);
  kernels.pairs();
  kernels.hertz();
  kernels.adhesion_and_rolling();
  kernels.yield();
  kernels.linear();
  kernels.dashpots();
  kernels.bridge();
  kernels.rough();
  kernels.vectors();
}

}  // namespace

int main(int argc, char** argv) {
  const Effort effort(argc, argv);
  judge_all<double>(effort);
  judge_all<float>(effort);
}
