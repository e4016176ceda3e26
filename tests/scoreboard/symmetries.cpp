// Items 6, 7 and 8: what must not matter - the observer's frame, which body is called the first, the units - and how far a
// turning pair drifts.
#include "laws_along_paths.hpp"

using namespace contactlaws;
using namespace contactlaws::test;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
using Turn = Eigen::Matrix<long double, 3, 3>;

/// A contact in the midst of a path, and the largest part of a force on the way there [N].
template <class Law>
struct Moment {
  PairProperties<double> pair;
  ContactKinematics<double> kinematics;
  typename Law::State state;
  double force;
};

/// Calls `visit` with each moment of random paths, `count` in all.
template <class Law, class Visit>
void visit_moments(const Law& law, std::int64_t count, const Visit& visit) {
  Random random;
  for (std::int64_t seen = 0; seen < count;) {
    const Path path = random_path(random, 10);
    Moment<Law> now{path.pair, {}, start<Law>(path), 0.0};
    for (const auto& kinematics : path.steps) {
      now.kinematics = kinematics;
      const auto step = law.step(now.pair, now.kinematics, now.state);
      now.force = std::max(now.force, largest_part(step));
      visit(now, step, random);
      now.state = step.state;
      ++seen;
    }
  }
}

Vec3<double> turned(const Turn& turn, const Vec3<double>& v) {
  return (turn * v.template cast<long double>()).template cast<double>();
}

/// The state with its vectors turned: an entry that changes sign with the bodies is the first of a vector's three.
template <class Law>
typename Law::State turned(const Turn& turn, typename Law::State state) {
  if constexpr (Law::state_size >= 3) {
    double* const values = values_of<Law>(state);
    for (std::size_t i = 0; i + 2 < Law::state_size; ++i) {
      if (Law::exchange_sign(i) > 0) continue;
      const Vec3<double> vector = turned(turn, Vec3<double>(values[i], values[i + 1], values[i + 2]));
      for (int k = 0; k < 3; ++k) values[i + static_cast<std::size_t>(k)] = vector[k];
      i += 2;
    }
  }
  return state;
}

Turn random_turn(Random& random) {
  const Vec3<long double> axis = random.direction().cast<long double>().normalized();
  return Eigen::AngleAxis<long double>(static_cast<long double>(random.uniform(-3.1, 3.1)), axis).toRotationMatrix();
}
/// One of the 24 turns that exchange axes, exact in any arithmetic.
Turn random_exchange_of_axes(Random& random) {
  const Vec3<long double> axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto first = random.engine() % 3, second = (first + 1 + random.engine() % 2) % 3;
  Turn turn;
  turn.col(0) = axes[first] * (random.chance(0.5) ? 1 : -1);
  turn.col(1) = axes[second] * (random.chance(0.5) ? 1 : -1);
  turn.col(2) = turn.col(0).cross(turn.col(1));
  return turn;
}

struct Worst {
  double figure = 0.0;
  std::string where = {};
  void see(double error, const std::string& at) {
    if (error <= figure || std::isnan(figure)) return;
    figure = error;
    where = at;
  }
};

template <class Draw>
void objectivity(const std::string& name, std::int64_t count, const Draw& draw, const char* reason) {
  Worst worst;
  std::int64_t tried = 0;
  visit_laws([&](const char* law_name, std::size_t, const auto& law) {
    using Law = std::decay_t<decltype(law)>;
    visit_moments(law, count, [&](const Moment<Law>& m, const auto& step, Random& random) {
      const Turn turn = draw(random);
      Moment<Law> other = m;
      other.kinematics.normal = turned(turn, m.kinematics.normal);
      other.kinematics.velocity = turned(turn, m.kinematics.velocity);
      other.state = turned<Law>(turn, m.state);
      const auto seen = law.step(other.pair, other.kinematics, other.state);
      const Vec3<double> expected = turned(turn, step.force);
      ++tried;
      if (m.force > 0.0) worst.see((seen.force - expected).norm() / m.force / eps, text_of(law_name, ", case ", tried));
    });
  });
  report({6, name, worst.figure, "eps of the largest part", 8.0, tried, worst.where, reason});
}

/// How far the length of a carried shear drifts from 1, as a pair turns `steps` times by `angle` [rad].
template <class Carry>
double drift(double angle, std::int64_t steps, bool tumbles) {
  Random random;
  Vec3<double> normal(1, 0, 0), shear(0, 0.6, 0.8), axis(0, 0, 1);
  typename Carry::State state{};
  Carry::apply(state, Vec3<double>(0, 0, 0), normal, 0.0);
  for (std::int64_t i = 1; i <= steps; ++i) {
    if (tumbles) {
      if (i % 100 == 1) axis = random.direction();
      normal = (normal + angle * axis.cross(normal)).normalized();
    } else {
      const double turned_by = angle * static_cast<double>(i);
      normal = {std::cos(turned_by), std::sin(turned_by), 0.0};
    }
    shear = Carry::apply(state, shear, normal, 0.0);
  }
  return std::abs(shear.norm() - 1.0);
}

template <class Carry>
void drift_of(const std::string& name, std::int64_t steps) {
  for (const bool tumbles : {false, true}) {
    Worst worst;
    for (const double angle : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1.4e-8})
      worst.see(drift<Carry>(angle, steps, tumbles), text_of(angle, " rad a step"));
    report({6, "drift of length, " + name + (tumbles ? ", a tumbling pair" : ", a steadily turning pair"), worst.figure,
            "of the length", 1e-12, steps, worst.where,
            "roundings of a slow turn, the normal's length above all, repeat and do not cancel: below an eps a step"});
  }
}

/// The state in the frame of the swapped bodies.
template <class Law>
typename Law::State swapped(typename Law::State state) {
  for (std::size_t i = 0; i + 1 <= Law::state_size; ++i) values_of<Law>(state)[i] *= Law::exchange_sign(i);
  return state;
}

void swap(std::int64_t count) {
  std::int64_t other_bits = 0, tried = 0;
  std::string where;
  visit_laws([&](const char* name, std::size_t, const auto& law) {
    using Law = std::decay_t<decltype(law)>;
    visit_moments(law, count, [&](const Moment<Law>& m, const auto& step, Random&) {
      const ContactKinematics<double>& k = m.kinematics;
      const auto seen =
          law.step(m.pair, {-k.normal, k.overlap, -k.velocity, k.dt, -k.normal_spin}, swapped<Law>(m.state));
      ++tried;
      if (same_values(values_of(seen.force), values_of(Vec3<double>(-step.force))) &&
          same_values(stored<Law>(seen.state), stored<Law>(swapped<Law>(step.state))) && seen.sliding == step.sliding)
        return;
      ++other_bits;
      where = text_of(name, ", case ", tried);
    });
  });
  report({7, "bodies swapped, all laws", static_cast<double>(other_bits), "steps with other bits", 0.0, tried, where});
}

/// Other units: a factor on metre, kilogram and second.
struct Units {
  long double length, mass, time;

  long double factor(const std::string& unit) const {
    const long double force = mass * length / (time * time);
    if (unit == "m") return length;
    if (unit == "N") return force;
    if (unit == "N/m") return force / length;
    if (unit == "Pa") return force / (length * length);
    return 1.0L;
  }
  static double times(double x, long double factor) {
    return static_cast<double>(static_cast<long double>(x) * factor);
  }
  template <class Slot>
  Slot slot(Slot slot) const {
    for (const auto& p : Slot::parameters()) slot.*p.member = times(slot.*p.member, factor(p.unit));
    return slot;
  }
  template <class Law>
  typename Law::State state(typename Law::State state) const {
    for (std::size_t i = 0; i < Law::state_size; ++i)
      values_of<Law>(state)[i] = times(values_of<Law>(state)[i], factor(Law::state_values()[i].unit));
    return state;
  }
  template <class Law>
  Moment<Law> moment(const Moment<Law>& m) const {
    const long double pascal = factor("Pa");
    const auto& p = m.pair;
    const auto& k = m.kinematics;
    const auto velocity = [&](int i) { return times(k.velocity[i], length / time); };
    return {{times(p.effective_radius, length), times(p.effective_young, pascal), times(p.effective_shear, pascal),
             times(p.effective_mass, mass), times(p.min_radius, length), times(p.length, length)},
            {k.normal,
             times(k.overlap, length),
             {velocity(0), velocity(1), velocity(2)},
             times(k.dt, time),
             times(k.normal_spin, 1.0L / time)},
            state<Law>(m.state),
            times(m.force, factor("N"))};
  }
};

template <class Draw>
void units(const std::string& name, std::int64_t count, double target, const Draw& draw, const char* reason) {
  Worst worst;
  std::int64_t tried = 0;
  visit_laws([&](const char* law_name, std::size_t, const auto& law) {
    using Law = std::decay_t<decltype(law)>;
    visit_moments(law, count, [&](const Moment<Law>& m, const auto& step, Random& random) {
      const Units units = draw(random);
      const Law rescaled{units.slot(law.normal), units.slot(law.damping), units.slot(law.shear),
                         units.slot(law.bridge)};
      const Moment<Law> other = units.moment(m);
      const auto seen = rescaled.step(other.pair, other.kinematics, other.state);
      ++tried;
      if (!(other.force > 0.0)) return;
      double off = 0.0;
      for (int i = 0; i < 3; ++i)
        off = std::max(off, std::abs(seen.force[i] - Units::times(step.force[i], units.factor("N"))));
      worst.see(off / other.force / eps, text_of(law_name, ", case ", tried, ", units of ", units.length, " m, ",
                                                 units.mass, " kg, ", units.time, " s"));
    });
  });
  report({8, name, worst.figure, "eps of the largest part", target, tried, worst.where, reason});
}

}  // namespace

int main(int argc, char** argv) {
  const Effort effort(argc, argv);
  const std::int64_t moments = effort(20000, 400000);  // of each law
  objectivity(
      "turns that exchange axes, all laws", moments, random_exchange_of_axes,
      "v.n is summed in another order, and cancels where a contact slides fast; dashpots multiply its rounding");
  objectivity("any rigid rotation, all laws", moments, random_turn,
              "turned inputs are rounded before the law sees them; v.n, which cancels where a contact slides fast, "
              "shows it most");

  const std::int64_t steps = effort(1000000, 1000000);
  drift_of<rotation::ProjectRestore<double>>("ProjectRestore", steps);
  drift_of<rotation::Rotate<double>>("Rotate", steps);

  swap(moments);

  const auto exponent = [](Random& random, int most) {
    return static_cast<int>(random.engine() % static_cast<unsigned>(2 * most + 1)) - most;
  };
  // The law takes square roots of single lengths, so of those a power of 4.
  units(
      "units times powers of two, all laws", moments, 0.0,
      [exponent](Random& r) {
        return Units{std::ldexp(1.0L, 2 * exponent(r, 4)), std::ldexp(1.0L, exponent(r, 8)),
                     std::ldexp(1.0L, exponent(r, 8))};
      },
      "no digit changes");
  units(
      "units times powers of ten, all laws", moments, 4.0,
      [exponent](Random& r) {
        const auto power = [&] { return std::pow(10.0L, static_cast<long double>(exponent(r, 9))); };
        return Units{power(), power(), power()};
      },
      "a dozen inputs are rounded anew in the other units; a law by increments of the overlap, a difference, shows it "
      "most");
}
