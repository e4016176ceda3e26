// The properties of every law, for every scalar that compares to one bool.
#include <tuple>

#include "catch.hpp"
#include "contactlaws/scalars/multiprecision.hpp"
#include "properties/symmetries.hpp"

namespace contactlaws::test {
namespace {

// Sanitizers look for other things than digits, and Boost's arithmetic would take them minutes.
using Scalars = std::conditional_t<sanitized, std::tuple<double, float, long double>,
                                   std::tuple<double, float, long double, Binary200>>;

/// Checks that `property` is at most `largest` over some instants of each law.
template <class T, class Property>
void check(const char* name, double largest, const Property& property) {
  const Worst worst = worst_of<T>(name, cases(400), property);
  INFO(name << ", " << worst.where);
  CHECK(worst.figure <= largest);
  CHECK(worst.tried > 0);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("an open contact exerts nothing but its bridge's pull, and its shear history is reset", "",
                        Scalars) {
  check<TestType>("wrong when open", 0,
                  [](const auto& law, const auto& now, Random&) { return wrong_when_opened(law, now); });
}

TEMPLATE_LIST_TEST_CASE("a closed contact pushes, and resists motion", "", Scalars) {
  check<TestType>("wrong when closed", 0,
                  [](const auto& law, const auto& now, Random&) { return wrong_when_closed(law, now); });
}

TEMPLATE_LIST_TEST_CASE("friction bounds the shear force", "", Scalars) {
  check<TestType>("friction", 8, [](const auto& law, const auto& now, Random&) {
    return friction_error(law, now.pair, now.kinematics, now.step);
  });
}

TEMPLATE_LIST_TEST_CASE("the frame of the observer does not matter", "", Scalars) {
  // Each turned vector is 3 eps off; a step multiplies and adds some 20 of them.
  check<TestType>("frame", 64, [](const auto& law, const auto& now, Random& random) {
    const FrameErrors errors = error_in_frame(law, now, random_turn<TestType>(random));
    return maximum(errors.force, errors.state);
  });
}

TEMPLATE_LIST_TEST_CASE("forces on swapped bodies are exactly opposite", "", Scalars) {
  check<TestType>("swap", 0, [](const auto& law, const auto& now, Random&) { return changed_by_swap(law, now); });
}

TEMPLATE_LIST_TEST_CASE("units do not matter", "", Scalars) {
  using T = TestType;
  // Squares of forces and couples keep their digits in all units tried, so that all take the same branches.
  const auto keeps_branches = [](const auto& now) {
    const T couple = now.force * now.pair.effective_radius;
    return square_is_exact<T>(T(now.force * now.force * T(0x1p-40))) &&
           square_is_exact<T>(T(couple * couple * T(0x1p-40)));
  };
  check<T>("binary units", 0, [&](const auto& law, const auto& now, Random& random) {
    const auto units = Units<T>::random(random, true, 4);
    if (!keeps_branches(now)) return 0.0;
    const UnitErrors errors = error_in_units(law, now, units);
    return errors.force + errors.changed;
  });
  if (std::numeric_limits<T>::digits == 24) return;  // ten powers of ten leave the range of a float
  // Each of some 10 inputs is rounded anew and enters once or twice; where T is no narrower than the factors, these have up
  // to 9 roundings each.
  check<T>("decimal units", 200, [&](const auto& law, const auto& now, Random& random) {
    const auto units = Units<T>::random(random, false, 9);
    return keeps_branches(now) ? error_in_units(law, now, units).force : 0.0;
  });
}

TEMPLATE_LIST_TEST_CASE("queries change nothing, and the same step twice gives the same answer", "", Scalars) {
  check<TestType>("queries", 0, [](const auto& law, const auto& now, Random&) { return changed_by_queries(law, now); });
}

TEMPLATE_LIST_TEST_CASE("a step of dt = 0 repeats the force of the last one, and leaves its state", "", Scalars) {
  // The history is projected and limited once more: some 16 operations on it, half an eps each.
  check<TestType>("set-up", 8, [](const auto& law, const auto& now, Random&) { return changed_by_set_up(law, now); });
}

}  // namespace contactlaws::test
