#include "contactlaws/core/cube_root.hpp"

#include "catch.hpp"
#include "contactlaws/scalars/autodiff.hpp"
#include "contactlaws/scalars/xsimd.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {

TEMPLATE_TEST_CASE("Cube root: 2 ULP over all normal numbers, the same bits in a pack", "", double, float) {
  using T = TestType;
  using Limits = std::numeric_limits<T>;
  using Pack = xsimd::batch<T>;
  Random random(3);
  Worst worst("cube_root" + precision_name<T>());
  for (int i = 0; i < cases(20000); ++i) {
    const T x = random.binary<T>(Limits::min_exponent - 1, Limits::max_exponent - 2);
    const T root = cube_root<T>(x);
    worst.see(ulps(root, Binary200(cbrt(Binary200(x)))), x);
    T lanes[Pack::size];
    cube_root<Pack>(Pack(x)).store_unaligned(lanes);
    CHECK(lanes[0] == root);
    CHECK(lanes[Pack::size - 1] == root);
  }
  CHECK(worst.error() <= 2.0);
  CHECK(cube_root<T>(T(0)) == T(0));
  CHECK(std::isnan(cube_root<T>(Limits::quiet_NaN())));
}

TEST_CASE("Cube root: its derivative, none of a constant zero") {
  using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;
  const Dual x(8.0, 1, 0);
  CHECK(cube_root<Dual>(x).value() == cube_root<double>(8.0));
  CHECK(cube_root<Dual>(x).derivatives()[0] == Approx(1.0 / 12).epsilon(1e-15));
  const Dual zero(0.0);
  CHECK(cube_root<Dual>(zero).derivatives()[0] == 0.0);
}

}  // namespace contactlaws::test
