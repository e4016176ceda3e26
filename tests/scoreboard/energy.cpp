// Item 5: energy gained on random closed loops by each shear history, and the loop that gains most.
//
// Undamped granite grains move on a grid of overlaps and along one tangent. Between the same two overlaps the normal force
// does the same work there and back by the trapezoidal rule, and a spring's force is linear in its slip, for which the rule
// is exact: a loop that sticks books the shear energy alone. The loop found in double is then booked at 200 bits, where a
// gain by rounding is gone.
#include "contactlaws/energy.hpp"
#include "contactlaws/laws.hpp"
#include "contactlaws/scalars/multiprecision.hpp"
#include "oracle.hpp"
#include "random.hpp"
#include "row.hpp"

using namespace contactlaws;
using namespace contactlaws::test;

namespace {

template <class Shear>
class Booked {
 public:
  using T = decltype(Shear::friction);

  explicit Booked(double friction) {
    law_.shear.friction = T(friction);
    pair_ = granite_pair<T>();
  }

  /// To grid line `to` (of 10 um) and by `slip` micrometres.
  void move(int to, double slip) {
    const T overlap = T(to) / T(100000), distance = T(slip) / T(1000000);
    const ContactKinematics<T> k{{T(0), T(0), T(1)}, overlap, {distance, T(0), T(overlap_ - overlap)}, T(1)};
    const auto step = law_.step(pair_, k, state_);
    ledger_.enter(law_, pair_, k, step);
    state_ = step.state;
    overlap_ = overlap;
    const T stiffness = law_.stiffness(pair_, overlap, state_).shear;
    const T in_spring = step.force.x() * step.force.x() / (T(2) * stiffness);
    if (to > 0 && in_spring > largest_) largest_ = in_spring;
  }
  /// Of a closed loop: what it gave, in the largest shear energy that was in the spring on the way.
  double gain() const {
    // A billionth of a joule: less, and rounding of the normal work, some 0.1 J, is all there is.
    return largest_ > T(1e-9) ? static_cast<double>(T(-ledger_.dissipated() / largest_)) : 0.0;
  }

 private:
  ContactLaw<Hertz<T>, NoDashpots<T>, Shear> law_{};
  PairProperties<T> pair_{};
  typename ContactLaw<Hertz<T>, NoDashpots<T>, Shear>::State state_{};
  EnergyLedger<T> ledger_{};
  T overlap_ = T(0), largest_ = T(0);
};

/// A closed loop: from touch up to a grid line, a walk over grid lines and slips, all slip undone, down to touch.
struct Loop {
  double friction;
  std::vector<std::pair<int, double>> moves;  ///< grid line, slip [um]

  Loop(Random& random, bool sticks) : friction(sticks ? 1e6 : random.uniform(0.1, 1.0)) {
    int level = 1 + static_cast<int>(random.engine() % 10);
    for (int up = 1; up <= level; ++up) moves.emplace_back(up, 0.0);
    double strain = 0.0;
    const auto length = 2 + random.engine() % 30;
    for (std::uint64_t i = 0; i < length; ++i) {
      if (random.chance(0.5)) {
        level += level == 1 || random.chance(0.5) ? 1 : -1;
        moves.emplace_back(level, 0.0);
      } else {
        const double slip = std::round(random.uniform(-200.0, 200.0)) / 128.0;  // sums of these are exact
        strain += slip;
        moves.emplace_back(level, slip);
      }
    }
    moves.emplace_back(level, -strain);
    while (level-- > 0) moves.emplace_back(level, 0.0);
  }

  template <class Shear>
  double gain() const {
    Booked<Shear> contact(friction);
    for (const auto& [line, slip] : moves) contact.move(line, slip);
    return contact.gain();
  }

  std::string text() const {
    std::string all = friction > 1e3 ? "sticks; overlap [10 um]" : text_of("mu ", friction, "; overlap [10 um]");
    for (const auto& [line, slip] : moves) all += slip != 0.0 ? text_of(" slip ", slip, " um") : text_of(" ", line);
    return all;
  }
};

template <template <class> class Shear>
void search(const char* name, std::int64_t loops, std::optional<double> target, const char* reason) {
  for (const bool sticks : {true, false}) {
    Random random;
    double most = -1.0;
    Loop best(random, sticks);
    for (std::int64_t i = 0; i < loops; ++i) {
      const Loop loop(random, sticks);
      const double gain = loop.gain<Shear<double>>();
      if (gain <= most) continue;
      most = gain;
      best = loop;
    }
    const double exact = std::max(best.gain<Shear<Binary200>>(), 0.0);
    report({5, std::string(name) + (sticks ? ", sticking" : ", with slip"), exact,
            "of the largest shear energy in the loop", target, loops, best.text(),
            exact > 0.0 ? reason : "in double: " + text_of(most)});
  }
}

template <class T>
using Force = ShearForce<T>;
template <class T>
using ForceRescaled = ShearForceRescaled<T>;
template <class T>
using Displacement = ShearDisplacement<T>;
template <class T>
using DisplacementRescaled = ShearDisplacementRescaled<T>;

}  // namespace

int main(int argc, char** argv) {
  const Effort effort(argc, argv);
  const std::int64_t loops = effort(100000, 1000000);
  const std::optional<double> published;
  search<Force>("ShearForce", loops, published, "published: a force kept while the stiffness falls holds more energy");
  search<ForceRescaled>("ShearForceRescaled", loops, 1e-50, "");
  search<Displacement>("ShearDisplacement", loops, published,
                       "published: a displacement kept while the stiffness grows holds more energy");
  search<DisplacementRescaled>(
      "ShearDisplacementRescaled", loops, 1e-50,
      "Thornton's rule, as codes have it, lowers on unloading but raises on loading without work");
}
