// Items 6, 7 and 8: what must not matter - the observer's frame, which body is called the first, the units - and how far a
// turning pair drifts.
#include "properties/symmetries.hpp"
#include "row.hpp"

using namespace contactlaws;
using namespace contactlaws::test;

namespace {

template <class Draw>
void objectivity(const std::string& name, std::int64_t count, const Draw& draw, const char* reason) {
  const Worst worst = worst_of<double>(name, count, [&draw](const auto& law, const auto& now, Random& random) {
    return error_in_frame(law, now, draw(random)).force;
  });
  report({6, name, worst.figure, "eps of the largest part", 8.0, worst.tried, worst.where, reason});
}

/// How far the length of a turned shear drifts from 1, as a pair turns `steps` times by `angle` [rad].
template <class Rotation>
double drift(double angle, std::int64_t steps, bool tumbles) {
  Random random;
  Vec3<double> normal(1, 0, 0), shear(0, 0.6, 0.8), axis(0, 0, 1);
  typename Rotation::State state{};
  Rotation::apply(state, Vec3<double>(0, 0, 0), normal, 0.0);
  for (std::int64_t i = 1; i <= steps; ++i) {
    if (tumbles) {
      if (i % 100 == 1) axis = random.direction();
      normal = (normal + angle * axis.cross(normal)).normalized();
    } else {
      const double turned_by = angle * static_cast<double>(i);
      normal = {std::cos(turned_by), std::sin(turned_by), 0.0};
    }
    shear = Rotation::apply(state, shear, normal, 0.0);
  }
  return std::abs(shear.norm() - 1.0);
}

template <class Rotation>
void drift_of(const std::string& name, std::int64_t steps) {
  for (const bool tumbles : {false, true}) {
    Worst worst;
    for (const double angle : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1.4e-8})
      worst.see(drift<Rotation>(angle, steps, tumbles), angle, " rad a step");
    report({6, "drift of length, " + name + (tumbles ? ", a tumbling pair" : ", a steadily turning pair"), worst.figure,
            "of the length", 1e-12, steps, worst.where,
            "roundings of a slow turn, the normal's length above all, repeat and do not cancel: below an eps a step"});
  }
}

void swap(std::int64_t count) {
  std::int64_t other_bits = 0;
  const Worst worst = worst_of<double>("swap", count, [&other_bits](const auto& law, const auto& now, Random&) {
    const int changed = changed_by_swap(law, now);
    other_bits += changed > 0;
    return changed;
  });
  report({7, "bodies swapped, all laws", static_cast<double>(other_bits), "steps with other bits", 0.0, worst.tried,
          worst.where});
}

void units(const std::string& name, bool binary, int most, std::int64_t count, double target, const char* reason) {
  const Worst worst = worst_of<double>(name, count, [&](const auto& law, const auto& now, Random& random) {
    return error_in_units(law, now, Units<double>::random(random, binary, most)).force;
  });
  report({8, name, worst.figure, "eps of the largest part", target, worst.tried, worst.where, reason});
}

}  // namespace

int main(int argc, char** argv) {
  const Effort effort(argc, argv);
  const std::int64_t instants = effort(20000, 400000);  // of each law
  objectivity(
      "turns that exchange axes, all laws", instants, random_exchange_of_axes<double>,
      "v.n is summed in another order, and cancels where a contact slides fast; dashpots multiply its rounding");
  objectivity("any rigid rotation, all laws", instants, random_turn<double>,
              "turned inputs are rounded before the law sees them; v.n, which cancels where a contact slides fast, "
              "shows it most");

  const std::int64_t steps = effort(1000000, 1000000);
  drift_of<rotation::ProjectRestore<double>>("ProjectRestore", steps);
  drift_of<rotation::Rotate<double>>("Rotate", steps);

  swap(instants);

  units("units times powers of two, all laws", true, 8, instants, 0.0, "no digit changes");
  units(
      "units times powers of ten, all laws", false, 9, instants, 4.0,
      "a dozen inputs are rounded anew in the other units; a law by increments of the overlap, a difference, shows it "
      "most");
}
