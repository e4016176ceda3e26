// Powers of a fraction against 200 bits: of one number and of packs.
#include "catch.hpp"
#include "contactlaws/core/power.hpp"
#include "contactlaws/scalars/xsimd.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

using Exact = Binary200;

/// (a/b)^y as asked for, where its value is a normal number.
template <class T>
struct Case {
  T a, b, y;
  Exact exact;
  double size;  ///< |y log x|

  explicit Case(Random& random) {
    b = random.binary<T>(-20, 20);
    const bool close = random.chance(0.2);
    do {
      const double x = close ? 1.0 - random.log_uniform(1e-6, 0.5) : random.log_uniform(lowest(), 1.0);
      a = minimum<T>(static_cast<T>(static_cast<double>(b) * x), b);
      y = random.chance(0.1) ? static_cast<T>(random.uniform(0.0, 3.0)) : static_cast<T>(random.uniform(0.3, 2.0));
      exact = pow(Exact(Exact(a) / Exact(b)), Exact(y));
    } while (exact < Exact(std::numeric_limits<T>::min()));
    size = std::abs(static_cast<double>(y) * std::log(static_cast<double>(a) / static_cast<double>(b)));
  }
  static double lowest() { return std::numeric_limits<T>::digits == 24 ? 1e-15 : 1e-150; }
};

template <class T>
double in_eps(const T& computed, const Exact& exact) {
  return static_cast<double>(abs(Exact(computed) / exact - 1)) / std::numeric_limits<T>::epsilon();
}

template <class T>
T first_lane(const xsimd::batch<T>& pack) {
  return pack.get(0);
}

}  // namespace

TEMPLATE_TEST_CASE("power: what the headers promise of their errors", "", double, float) {
  using T = TestType;
  using Pack = xsimd::batch<T>;
  Random random;
  Worst one("power, in ULP" + precision_name<T>()), pack("power, packs, of their bound" + precision_name<T>());
  for (int i = 0; i < cases(20000); ++i) {
    const Case<T> c(random);
    one.see(ulps(power_of_quotient<T>(c.a, c.b, c.y), c.exact), c.a, c.b, c.y);
    const double bound = 3.0 + 4.0 * c.size;
    const Pack of_pack = power_of_quotient<Pack>(Pack(c.a), Pack(c.b), Pack(c.y));
    pack.see(in_eps(first_lane(of_pack), c.exact) / bound, c.a, c.b, c.y);
  }
  CHECK(one.error() <= 2.0);
  CHECK(pack.error() <= 1.0);
}

TEMPLATE_TEST_CASE("power: what needs no rounding is exact, in packs too", "", double, float) {
  using T = TestType;
  using Pack = xsimd::batch<T>;
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const T a = random.binary<T>(-20, 20);
    const T y = static_cast<T>(random.uniform(0.0, 3.0));
    CHECK(power_of_quotient<T>(a, a, y) == T(1));
    CHECK(first_lane(power_of_quotient<Pack>(Pack(a), Pack(a), Pack(y))) == T(1));
    CHECK(first_lane(power_of_quotient<Pack>(Pack(a), Pack(a * T(8)), Pack(T(0)))) == T(1));
    CHECK(first_lane(power_of_quotient<Pack>(Pack(a), Pack(a * T(8)), Pack(T(1)))) == T(0.125));
  }
}

TEMPLATE_TEST_CASE("power: a pack's power too small for a normal number is the smallest one", "", double, float) {
  using T = TestType;
  using Pack = xsimd::batch<T>;
  const T least = std::numeric_limits<T>::min();
  for (const T a : {least, std::numeric_limits<T>::denorm_min(), T(least * T(3))})
    CHECK(first_lane(power_of_quotient<Pack>(Pack(a), Pack(T(1)), Pack(T(2)))) == least);
}

}  // namespace contactlaws::test
