#include "catch.hpp"
#include "properties/oblique_impact.hpp"

namespace contactlaws::test {

TEST_CASE("Oblique impact: the spin of each shear history, also below 30 degrees where they differ") {
  // 1e-9 s is a ten thousandth of the impact; the printed digits at 10 degrees are good to 3e-6.
  CHECK(ObliqueImpact{}.worst_error(1e-9) < 1e-4);
}

}  // namespace contactlaws::test
