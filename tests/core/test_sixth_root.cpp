#include "contactlaws/core/sixth_root.hpp"

#include "catch.hpp"
#include "contactlaws/scalars/autodiff.hpp"
#include "contactlaws/scalars/xsimd.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {

TEMPLATE_TEST_CASE("Sixth and third root: 2 and 3 ULP over all normal numbers, the same bits in a pack", "", double,
                   float) {
  using T = TestType;
  using Limits = std::numeric_limits<T>;
  using Pack = xsimd::batch<T>;
  Random random(3);
  Worst sixth("sixth root" + precision_name<T>()), third("third root" + precision_name<T>());
  int differing = 0;
  for (int i = 0; i < cases(20000); ++i) {
    const T x = random.binary<T>(Limits::min_exponent - 1, Limits::max_exponent - 2);
    const SixthRoot<T> root = sixth_root<T>(x);
    const Binary200 exact = cbrt(Binary200(x));
    sixth.see(ulps(root.sixth, Binary200(sqrt(exact))), x);
    third.see(ulps(root.third, exact), x);
    T lanes[2][Pack::size];
    const SixthRoot<Pack> pack = sixth_root<Pack>(Pack(x));
    pack.sixth.store_unaligned(lanes[0]);
    pack.third.store_unaligned(lanes[1]);
    for (std::size_t lane = 0; lane < Pack::size; ++lane)
      differing += (lanes[0][lane] != root.sixth) + (lanes[1][lane] != root.third);
    // Powers of 64 come out of the root exactly.
    if (x < T(1)) differing += sixth_root<T>(x * T(64)).sixth != root.sixth * T(2);
  }
  CHECK(sixth.error() <= 2.0);
  CHECK(third.error() <= 3.0);
  CHECK(differing == 0);
  CHECK(sixth_root<T>(T(0)).sixth == T(0));
  CHECK(sixth_root<T>(T(0)).third == T(0));
  CHECK(std::isnan(sixth_root<T>(Limits::quiet_NaN()).sixth));
}

TEST_CASE("Sixth root: its derivative, none of a constant zero") {
  using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;
  const SixthRoot<Dual> root = sixth_root<Dual>(Dual(64.0, 1, 0));
  CHECK(root.sixth.value() == sixth_root<double>(64.0).sixth);
  CHECK(root.third.value() == sixth_root<double>(64.0).third);
  CHECK(root.sixth.derivatives()[0] == Approx(2.0 / 6 / 64).epsilon(1e-15));
  CHECK(root.third.derivatives()[0] == Approx(4.0 / 3 / 64).epsilon(1e-15));
  CHECK(sixth_root<Dual>(Dual(0.0)).third.derivatives()[0] == 0.0);
}

}  // namespace contactlaws::test
