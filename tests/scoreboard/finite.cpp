// Item 10 and the extremes: no finite input within the ranges of the parameters makes a result that is not finite; and what
// an input that is not finite makes. Written in bits, since -ffast-math folds std::isfinite away.
#include <cstring>

#include <xmmintrin.h>

#include "edges.hpp"

using namespace contactlaws;
using namespace contactlaws::test;

namespace {

bool is_finite(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return (bits >> 52 & 0x7ff) != 0x7ff;
}
bool is_finite(float x) {
  std::uint32_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return (bits >> 23 & 0xff) != 0xff;
}

template <class T>
bool is_finite(const ErasedLaw<T>& law, const Step<T, typename ErasedLaw<T>::State>& step) {
  bool all = is_finite(step.normal_elastic) && is_finite(step.normal_force) && is_finite(step.bridge_force);
  for (int i = 0; i < 3; ++i) all = all && is_finite(step.force[i]) && is_finite(step.couple[i]);
  for (std::size_t i = 0; i < law.state_size(); ++i) all = all && is_finite(step.state[i]);
  return all;
}

template <class T>
std::string text_of(const PairProperties<T>& p, const ContactKinematics<T>& k) {
  return contactlaws::test::text_of("R* = ", p.effective_radius, ", E* = ", p.effective_young,
                                    ", m* = ", p.effective_mass, ", o = ", k.overlap, ", v = (", k.velocity.transpose(),
                                    "), dt = ", k.dt, ", n = (", k.normal.transpose(), ")");
}

template <class T, class Draw>
void finite(const std::string& name, std::int64_t paths, const Draw& draw, const std::string& note = "") {
  std::int64_t tried = 0, found = 0;
  std::string worst;
  for (const auto& law : all_laws<T>()) {
    Random random = random_for(name, law->name);
    for (std::int64_t i = 0; i < paths; ++i) {
      const Path path = draw.path(random);
      draw.tune(*law, random);
      const PairProperties<T> pair = path.pair.template cast<T>();
      auto state = start(*law, path);
      for (const auto& motion : path.steps) {
        const ContactKinematics<T> kinematics = motion.template cast<T>();
        const auto step = law->step(pair, kinematics, state);
        ++tried;
        if (!is_finite(*law, step)) {
          if (found++ == 0) worst = law->name + ": " + text_of(pair, kinematics);
          break;
        }
        state = step.state;
      }
    }
  }
  report({10, name + (sizeof(T) == 4 ? " (float)" : " (double)"), static_cast<double>(found), "results not finite", 0.0,
          tried, worst, note});
}

/// Every input of a step in turn not finite: how often the force does not show it, and where.
void not_finite(double value, const char* value_name) {
  std::int64_t tried = 0, silent = 0;
  std::string where;
  for (const auto& law : all_laws<double>()) {
    const PairProperties<double> pair = granite_pair<double>();
    const auto ask = [&](const char* input, const auto& change) {
      PairProperties<double> p = pair;
      ContactKinematics<double> k{{0.0, 0.6, 0.8}, 1e-5, {1e-3, 1e-3, 1e-3}, 1e-6, 0.5, {0.1, 0.2, 0.3}};
      auto state = law->virgin();
      law->make_wet(state, 0.0, 0.0);
      change(p, k, state);
      const auto step = law->step(p, k, state);
      ++tried;
      bool shows = false;
      for (int i = 0; i < 3; ++i) shows = shows || !is_finite(step.force[i]);
      if (shows) return;
      ++silent;
      if (law->name == "Hill") where += (where.empty() ? "Hill: " : ", ") + std::string(input);
    };
    ask("R*", [value](auto& p, auto&, auto&) { p.effective_radius = value; });
    ask("E*", [value](auto& p, auto&, auto&) { p.effective_young = value; });
    ask("G*", [value](auto& p, auto&, auto&) { p.effective_shear = value; });
    ask("m*", [value](auto& p, auto&, auto&) { p.effective_mass = value; });
    ask("R_o", [value](auto& p, auto&, auto&) { p.min_radius = value; });
    ask("L", [value](auto& p, auto&, auto&) { p.length = value; });
    ask("normal", [value](auto&, auto& k, auto&) { k.normal.x() = value; });
    ask("overlap", [value](auto&, auto& k, auto&) { k.overlap = value; });
    ask("velocity", [value](auto&, auto& k, auto&) { k.velocity.y() = value; });
    ask("dt", [value](auto&, auto& k, auto&) { k.dt = value; });
    ask("spin", [value](auto&, auto& k, auto&) { k.normal_spin = value; });
    for (std::size_t i = 0; i < law->state_size(); ++i)
      ask(law->state_values[i].name, [value, i](auto&, auto&, auto& state) { state[i] = value; });
  }
  report({10,
          std::string("one input ") + value_name + ": force finite all the same",
          static_cast<double>(silent),
          "of the cases",
          {},
          tried,
          where,
          "published: not read by the law, or a comparison that it fails; no trap, no hang"});
}

}  // namespace

int main(int argc, char** argv) {
  const Effort effort(argc, argv);
  finite<double>("in the field", effort(5000, 4000000), Field{});
  finite<float>("in the field", effort(1000, 400000), Field{});
  const std::int64_t edges = effort(10000, 400000);
  finite<double>("at the edges of the ranges", edges, Edges{std::numeric_limits<double>::denorm_min()});
  finite<float>("at the edges of the ranges", edges, Edges{std::numeric_limits<float>::denorm_min()});
  _mm_setcsr(_mm_getcsr() | 0x8040u);  // flush denormal results to zero, and take denormal inputs for it
  finite<double>("at the edges, denormals flushed to zero", edges, Edges{std::numeric_limits<double>::min()});
  finite<float>("at the edges, denormals flushed to zero", edges, Edges{std::numeric_limits<float>::min()});
  _mm_setcsr(_mm_getcsr() & ~0x8040u);
  not_finite(std::numeric_limits<double>::quiet_NaN(), "NaN");
  not_finite(std::numeric_limits<double>::infinity(), "infinite");
}
