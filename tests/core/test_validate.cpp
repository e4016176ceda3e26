#include "contactlaws/core/validate.hpp"
#include "make_laws.hpp"

#include "catch.hpp"
#include "contactlaws/laws.hpp"

namespace contactlaws::test {
namespace {

using Catch::Matchers::Equals;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

/// A thing with two parameters, as a law declares them.
struct Gadget {
  double width = 1.0;
  double share = 0.5;
  static constexpr const char* name = "Gadget";
  static constexpr std::array<Parameter<Gadget, double>, 2> parameters() {
    return {
        {{"width", "m", &Gadget::width, Range::positive()}, {"share", "1", &Gadget::share, Range::closed(0.0, 1.0)}}};
  }
};

}  // namespace

TEST_CASE("Validate: ranges hold their ends or not, and never infinity or NaN") {
  CHECK_FALSE(Range::positive().contains(0.0));
  CHECK(Range::positive().contains(5e-324));
  CHECK(Range::not_negative().contains(0.0));
  CHECK_FALSE(Range::not_negative().contains(-5e-324));
  CHECK(Range::closed(0.0, 1.0).contains(0.0));
  CHECK(Range::closed(0.0, 1.0).contains(1.0));
  CHECK_FALSE(Range::closed(0.0, 1.0).contains(1.0000000000000002));
  CHECK_FALSE(Range::left_open(-1.0, 0.5).contains(-1.0));
  CHECK(Range::left_open(-1.0, 0.5).contains(0.5));
  CHECK_FALSE(Range{0.0, 1.0, false, false}.contains(1.0));
  for (const Range& range : {Range::positive(), Range::not_negative(), Range::closed(0, 1), Range::left_open(0, 1)}) {
    CHECK_FALSE(range.contains(inf));
    CHECK_FALSE(range.contains(-inf));
    CHECK_FALSE(range.contains(nan));
  }
}

TEST_CASE("Validate: a range reads as mathematics writes it") {
  CHECK(to_string(Range::positive()) == "(0, inf)");
  CHECK(to_string(Range::not_negative()) == "[0, inf)");
  CHECK(to_string(Range::left_open(-1.0, 0.5)) == "(-1, 0.5]");
  CHECK(to_string(Range{-inf, 2.0, false, true}) == "(-inf, 2]");
}

TEST_CASE("Validate: a number reads in the fewest digits that give it back") {
  CHECK(to_string(0.7) == "0.7");
  CHECK(to_string(-1.0) == "-1");
  CHECK(to_string(1.0 / 3.0) == "0.3333333333333333");
  CHECK(to_string(0.1 + 0.2) == "0.30000000000000004");
  CHECK(to_string(29e9) == "2.9e+10");
  CHECK(to_string(inf) == "inf");
  CHECK(to_string(nan) == "nan");
}

TEST_CASE("Validate: the message names owner, parameter, value, unit and range") {
  CHECK_THROWS_WITH(checked(Gadget{-0.25, 0.5}), Equals("Gadget: width is -0.25 m, must lie in (0, inf)"));
  CHECK_THROWS_WITH(checked(Gadget{1.0, 1.5}), Equals("Gadget: share is 1.5, must lie in [0, 1]"));
  CHECK_THROWS_WITH(checked(Gadget{nan, 0.5}), Equals("Gadget: width is nan m, must lie in (0, inf)"));
  CHECK_THROWS_WITH(checked(Gadget{inf, 0.5}), Equals("Gadget: width is inf m, must lie in (0, inf)"));
  CHECK_THROWS_AS(checked(Gadget{-1.0, 0.5}), std::invalid_argument);
}

TEST_CASE("Validate: what is in range is handed back") {
  const Gadget gadget{2.0, 0.0};
  CHECK(checked(gadget).width == 2.0);
  CHECK(checked(gadget).share == 0.0);
  CHECK(checked(test::hill<double>(0.4, 2e5, 0.07)).bridge.suction == 2e5);
}

TEST_CASE("Validate: the slots of a law are looked at one by one") {
  Hill<double> law = test::hill<double>(0.4, 2e5, 0.07);
  law.bridge.suction = -1.0;
  CHECK_THROWS_WITH(checked(law), Equals("SuctionBridge: suction is -1 Pa, must lie in [0, inf)"));
  law.damping.damping_constant = nan;
  CHECK_THROWS_WITH(checked(law), Equals("Dashpots: damping_constant is nan, must lie in [0, inf)"));
  LinearFriction<double> linear{{0.0}, {}, {{1.0}, 0.4}, {}};
  CHECK_THROWS_WITH(checked(linear), Equals("LinearModulus: modulus is 0 Pa, must lie in (0, inf)"));
  linear = {{5e8}, {}, {{1.0}, -0.5}, {}};
  CHECK_THROWS_WITH(checked(linear), Equals("ShearForce: friction is -0.5, must lie in [0, inf)"));
}

}  // namespace contactlaws::test
