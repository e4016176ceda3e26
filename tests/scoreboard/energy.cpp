// Item 5: energy gained on random closed loops by each shear history, and the loop that gains most. The loop found in double is
// then entered at 200 bits, where a gain by rounding is gone.
#include "properties/energy.hpp"
#include "contactlaws/laws.hpp"
#include "contactlaws/scalars/multiprecision.hpp"
#include "contactlaws/tangential/mindlin_deresiewicz.hpp"
#include "row.hpp"

using namespace contactlaws;
using namespace contactlaws::test;

namespace {

template <template <class> class Shear>
void search(const char* name, std::int64_t loops, std::optional<double> target, const char* reason) {
  for (const bool sticks : {true, false}) {
    const auto [most, best] = largest_gain<Undamped<Shear<double>>>(Random(), loops, sticks);
    const double exact = std::max(best.template gain<Undamped<Shear<Binary200>>>(), 0.0);
    report({5, std::string(name) + (sticks ? ", sticking" : ", with slip"), exact,
            "of the largest shear energy in the loop", target, loops, best.text(),
            exact > 0.0 ? reason : "in double: " + text_of(most)});
  }
}

/// The rough law with a shear stiffness in proportion to one of its tangents.
template <class Stiffness>
void rough(const char* name, std::optional<double> target, const char* reason) {
  using Rough = PohrtPopovElastoPlastic<double>;
  ContactLaw<Rough, NoDashpots<double>, ShearForce<double, Stiffness>> law;
  law.normal = Rough::of({2.13, 26.1e-6});
  law.shear.ratio = 0.6;
  report({5, std::string("RoughBallast, ") + name + ", slip at the largest overlap", gain_at_largest_overlap(law),
          "of k S^2/2", target, 2, "opened by 1e-10 of the overlap, slipped back, closed", reason});
}

template <class T>
using Force = ShearForce<T>;
template <class T>
using ForceRescaled = ShearForceRescaled<T>;
template <class T>
using Displacement = ShearDisplacement<T>;
template <class T>
using DisplacementRescaled = ShearDisplacementRescaled<T>;
template <class T>
using PartialSlip = MindlinDeresiewicz<T>;

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
  search<PartialSlip>("MindlinDeresiewicz", loops, published,
                      "published: the work of a step in which a corner of the history is dropped is not linear in the "
                      "slip; the same loops in eighths of a step gain nothing");
  rough<ConstantRatio<double>>("ConstantRatio", published, "published: the virgin tangent and Hertz's differ there");
  rough<ElasticRatio<double>>("ElasticRatio", 1e-6, "the rounding of the normal work");
}
