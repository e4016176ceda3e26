// Item 2: kernels in float at every value of one argument (a stride of a prime in the quick look), against long double, whose
// 40 further bits make the judge's error nothing. A result that is not finite where the exact one is within float's range,
// or finite where it is not, is unexplained, as is an error beyond the bound that the header states.
#include <cstring>

#include "contactlaws/contactlaws.hpp"
#include "contactlaws/damping/restitution.hpp"
#include "judge.hpp"

using namespace contactlaws;
using namespace contactlaws::test;

namespace {

float float_of(std::uint32_t bits) {
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// `bound(x)`: what the header promises at x [ULP].
template <class Kernel, class Bound>
void every_float(const Effort& effort, const std::string& name, float last, const Kernel& kernel, const Bound& bound,
                 const std::string& note = "") {
  std::uint32_t end;
  std::memcpy(&end, &last, sizeof end);
  const auto stride = static_cast<std::uint32_t>(effort(1009, 1));
  double worst = 0.0;
  float worst_at = 0.0f;
  std::int64_t count = 0, unexplained = 0;
  for (std::uint64_t bits = 1; bits <= end; bits += stride) {
    const float x = float_of(static_cast<std::uint32_t>(bits));
    const float computed = kernel(x);
    const Sieve exact = kernel(Sieve(x));
    ++count;
    if (!fits<float>(exact)) {
      if (std::isfinite(computed) && computed < std::numeric_limits<float>::max()) ++unexplained;
      continue;
    }
    const double error = distance<float>(computed, exact);
    if (!(error <= bound(x))) ++unexplained;
    if (error <= worst) continue;
    worst = error;
    worst_at = x;
  }
  const std::string worst_text = text_of("x = ", worst_at);
  report(
      {2, name + ": unexplained results", static_cast<double>(unexplained), "results", 0.0, count, worst_text, note});
  report({2, name + ": largest error", worst, "ULP", {}, count, worst_text});
}

}  // namespace

int main(int argc, char** argv) {
  // Here --count is a stride.
  const Effort effort(argc, argv);
  const PairProperties<float> pair = granite_pair<double>().cast<float>();
  const auto pair_for = [&pair](auto x) { return pair.cast<decltype(x)>(); };
  const float huge = std::numeric_limits<float>::max();

  every_float(
      effort, "hertz.force(o)", huge, [&](auto o) { return hertz_response(pair_for(o), o).force; },
      [](float) { return 4.0; });
  every_float(
      effort, "hertz.stiffness(o)", huge, [&](auto o) { return hertz_response(pair_for(o), o).stiffness; },
      [](float) { return 3.0; });
  every_float(
      effort, "linear.force from a modulus(o)", huge,
      [&](auto o) {
        using S = decltype(o);
        typename LinearModulus<S>::State none;
        return LinearModulus<S>{S(29e9f)}.respond(none, pair_for(o), o).force;
      },
      [](float) { return 5.0; });
  every_float(
      effort, "bridge.force(gap)", 0.0099f,  // short of rupture, where the range's own rounding decides
      [&](auto gap) {
        using S = decltype(gap);
        typename SuctionBridge<S>::State wet{S(2)};
        return SuctionBridge<S>{S(2e5f)}.respond(wet, pair_for(gap), S(-gap)).force;
      },
      [](float gap) { return 5.0 + 2.0 * static_cast<double>(gap) / 0.01; });
  const auto rough = PohrtPopovElastoPlastic<float>::of({2.13f, 26.1e-6f});
  every_float(
      effort, "pohrt_popov.force(o)", huge,
      [&](auto o) {
        using S = decltype(o);
        typename PohrtPopovElastoPlastic<S>::State virgin{};
        return slot_cast<S>(rough).respond(virgin, pair_for(o), o).force;
      },
      [](float) { return 7.0; });
  const auto restituted = [&](Tension tension) {
    return [tension](auto e) { return damping_ratio_of_restitution(e, tension); };
  };
  every_float(effort, "restitution.damping ratio(e), tension allowed", 1.0f, restituted(Tension::allowed),
              [](float) { return 3.0; });
  every_float(effort, "restitution.damping ratio(e), tension clipped", 1.0f, restituted(Tension::clipped),
              [](float e) { return 4.0 - 2.0 * std::log(static_cast<double>(e)); });
}
