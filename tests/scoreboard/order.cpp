// Item 9: on neighbouring numbers, a larger overlap never has a smaller force, a wider gap never a stronger bridge, and a
// larger force never a smaller stiffness.
#include "ballast/pohrt_popov_incremental.hpp"
#include "contactlaws/contactlaws.hpp"
#include "judge.hpp"

using namespace contactlaws;
using namespace contactlaws::test;

namespace {

/// `draw(random)` yields a function of one number that shall not fall, and the number.
template <class T, class Draw>
void never_falls(const std::string& name, std::int64_t count, const Draw& draw, const char* reason = "") {
  Random random;
  std::int64_t falls = 0;
  T farthest = T(0);
  std::string worst;
  for (std::int64_t i = 0; i < count; ++i) {
    const auto [value_at, x, inputs] = draw(random);
    const T next = std::nextafter(x, std::numeric_limits<T>::max());
    const T here = value_at(x), there = value_at(next);
    if (there >= here) continue;
    ++falls;
    const T depth = (here - there) / here;
    if (depth <= farthest) continue;
    farthest = depth;
    worst = text_of("x = ", x, ", ", inputs, ": ", here, ", then ", there);
  }
  report(
      {9, name + precision_name<T>(), static_cast<double>(falls), "falls", 0.0, count, worst, falls > 0 ? reason : ""});
}

template <class Function, class T>
struct Drawn {
  Function value_at;
  T x;
  std::string inputs;
};
template <class Function, class T>
Drawn(Function, T, std::string) -> Drawn<Function, T>;

template <class T>
std::string text_of_pair(const PairProperties<T>& pair) {
  return text_of("R* = ", pair.effective_radius, ", E* = ", pair.effective_young);
}

template <class T>
void all(const Effort& effort) {
  const std::int64_t count = effort(500000, 100000000);
  const auto overlap = [](Random& r) { return r.binary<T>(smallest_exponent<T>, 4); };

  never_falls<T>("hertz.force(o)", count, [overlap](Random& r) {
    const PairProperties<T> pair = wide_pair<T>(r);
    return Drawn{[pair](T o) { return hertz_response(pair, o).force; }, overlap(r), text_of_pair(pair)};
  });
  never_falls<T>("hertz.stiffness(o)", count, [overlap](Random& r) {
    const PairProperties<T> pair = wide_pair<T>(r);
    return Drawn{[pair](T o) { return hertz_response(pair, o).stiffness; }, overlap(r), text_of_pair(pair)};
  });
  never_falls<T>("linear.force from a modulus(o)", count, [overlap](Random& r) {
    const PairProperties<T> pair = wide_pair<T>(r);
    return Drawn{[pair](T o) {
                   typename LinearModulus<T>::State none;
                   return LinearModulus<T>{pair.effective_young}.respond(none, pair, o).force;
                 },
                 overlap(r), text_of_pair(pair)};
  });
  never_falls<T>("minus bridge.force(gap)", count, [](Random& r) {
    const PairProperties<T> pair = wide_pair<T>(r);
    const T rupture = r.binary<T>(-3, 3);
    const SuctionBridge<T> bridge{r.binary<T>(-10, 30), rupture * r.binary<T>(-3, 3), rupture};
    const T share = r.chance(0.5) ? static_cast<T>(r.uniform(0.0, 1.1)) : static_cast<T>(r.log_uniform(1e-30, 1.0));
    return Drawn{[pair, bridge](T gap) {
                   typename SuctionBridge<T>::State wet{T(2)};
                   return T(-bridge.respond(wet, pair, T(-gap)).force);
                 },
                 share * rupture * pair.min_radius,
                 text_of("R_o = ", pair.min_radius, ", lambda/R_o = ", bridge.decay_length)};
  });

  // Along the rough law, and about its transition.
  using Rough = PohrtPopovElastoPlastic<T>;
  const auto rough = [](Random& r) {
    Rough law;
    law.exponent = static_cast<T>(r.uniform(1.37, 2.9));  // p of D_f from 2 to 3
    law.transition_overlap = r.binary<T>(-30, 0);
    return law;
  };
  const auto place = [](Random& r, const Rough& law) {
    if (r.chance(0.3))
      return T(law.transition_overlap * (T(1) + std::numeric_limits<T>::epsilon() * static_cast<T>(r.uniform(-6, 6))));
    return T(law.transition_overlap * static_cast<T>(r.log_uniform(1e-9, 1e2)));
  };
  const auto text_of_rough = [](const Rough& law, const PairProperties<T>& pair) {
    return text_of("p = ", law.exponent, ", o_c = ", law.transition_overlap, ", ", text_of_pair(pair));
  };
  const char* at_the_seam = "the two branches that meet at the transition are each rounded in its own way";
  never_falls<T>(
      "pohrt_popov.force(o)", count,
      [=](Random& r) {
        const PairProperties<T> pair = wide_pair<T>(r);
        const Rough law = rough(r);
        return Drawn{[pair, law](T o) {
                       typename Rough::State state{};
                       return law.respond(state, pair, o).force;
                     },
                     place(r, law), text_of_rough(law, pair)};
      },
      at_the_seam);
  never_falls<T>(
      "pohrt_popov.stiffness(o)", count,
      [=](Random& r) {
        const PairProperties<T> pair = wide_pair<T>(r);
        const Rough law = rough(r);
        return Drawn{[pair, law](T o) {
                       typename Rough::State state{};
                       return law.respond(state, pair, o).stiffness;
                     },
                     place(r, law), text_of_rough(law, pair)};
      },
      at_the_seam);
  never_falls<T>(
      "pohrt_popov.force(o), reloading to virgin", count,
      [=](Random& r) {
        const PairProperties<T> pair = wide_pair<T>(r);
        const Rough law = rough(r);
        const T largest = place(r, law);
        const T below = law.indentation(largest).depth * static_cast<T>(r.chance(0.5) ? r.uniform(0.0, 1.1) : 0.0);
        const T x = r.chance(0.2) ? std::nextafter(largest, T(0)) : T(largest - below);
        return Drawn{[pair, law, largest](T o) {
                       typename Rough::State state{largest};
                       return law.respond(state, pair, o).force;
                     },
                     x, text_of_rough(law, pair) + text_of(", o_m = ", largest)};
      },
      at_the_seam);
  never_falls<T>(
      "pohrt_popov_incremental.stiffness(F)", count,
      [=](Random& r) {
        using Incremental = PohrtPopovIncremental<T, Unloads::elastically>;
        const PairProperties<T> pair = wide_pair<T>(r);
        const Rough surface = rough(r);
        Incremental law;
        law.exponent = surface.exponent;
        law.transition_overlap = surface.transition_overlap;
        const T transition = hertz_response(pair, surface.transition_indentation()).force;
        const T about = T(1) + std::numeric_limits<T>::epsilon() * static_cast<T>(r.uniform(-6, 6));
        const T force = transition * (r.chance(0.3) ? about : static_cast<T>(r.log_uniform(1e-20, 1e3)));
        return Drawn{[pair, law](T f) {
                       typename Incremental::State state{f, f, T(1)};
                       return law.respond(state, pair, T(1)).stiffness;
                     },
                     force, text_of_rough(surface, pair)};
      },
      at_the_seam);
}

}  // namespace

int main(int argc, char** argv) {
  const Effort effort(argc, argv);
  all<double>(effort);
  all<float>(effort);
}
