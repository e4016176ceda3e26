#include "contactlaws/core/scalar.hpp"

#include "catch.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double tiny = std::numeric_limits<double>::denorm_min();

}  // namespace

TEST_CASE("Scalar: select, smaller, larger, positive part") {
  CHECK(select<double>(true, 1.0, 2.0) == 1.0);
  CHECK(select<double>(false, 1.0, 2.0) == 2.0);
  CHECK(minimum(3.0, -1.0) == -1.0);
  CHECK(maximum(3.0, -1.0) == 3.0);
  CHECK(positive_part(2.0) == 2.0);
  CHECK(positive_part(tiny) == tiny);
  CHECK(positive_part(-tiny) == 0.0);
  CHECK(positive_part(-0.0) == 0.0);
  CHECK(std::isnan(positive_part(nan)));  // a NaN is passed on, not taken for an open contact
}

TEST_CASE("Scalar: pi to the last digit of every type") {
  CHECK(pi<float>() == 3.14159265358979324f);
  CHECK(pi<double>() == 3.14159265358979324);
  CHECK(pi<long double>() == 3.14159265358979323846264338327950288L);
  const Binary200 digits("3.14159265358979323846264338327950288419716939937510582097494459230782");
  CHECK(abs(pi<Binary200>() - digits) < 2e-60);  // an ULP at 200 bits is 2.5e-60
}

TEST_CASE("Scalar: a number of another precision is rounded, once") {
  CHECK(scalar_cast<float>(0.1) == 0.1f);
  CHECK(scalar_cast<double>(0.1f) == static_cast<double>(0.1f));
  CHECK(scalar_cast<Binary200>(0.1) == Binary200(0.1));
  CHECK(scalar_cast<double>(Binary200(0.1)) == 0.1);
}

TEST_CASE("Scalar: the scalar product sums from x to z") {
  // 1e16 + 1 rounds to 1e16, so that the order can be told.
  CHECK(dot<double>({1e16, 1, -1e16}, {1, 1, 1}) == 0.0);
  CHECK(dot<double>({1e16, -1e16, 1}, {1, 1, 1}) == 1.0);
  CHECK(dot<double>({2, 3, 5}, {7, 11, 13}) == 14 + 33 + 65);
}

TEST_CASE("Scalar: a norm at any magnitude") {
  CHECK(norm<double>({2, -3, 6}) == 7.0);
  CHECK(norm<double>({0, 0, 0}) == 0.0);
  for (const double scale : {tiny, 0x1p-1000, 0x1p-540, 0x1p-500, 0x1p500, 0x1p600, 0x1p1020}) {
    CHECK(norm<double>({2 * scale, -3 * scale, 6 * scale}) == 7 * scale);
    CHECK(norm<double>({0, 0, -scale}) == scale);
  }
  CHECK(std::isnan(norm<double>({nan, 0, 0})));
}

TEST_CASE("Scalar: squares that lost digits are known") {
  CHECK(square_is_exact(1.0));
  CHECK_FALSE(square_is_exact(0.0));
  CHECK_FALSE(square_is_exact(1e-300));
  CHECK(square_is_exact(1e-290));
  CHECK_FALSE(square_is_exact(inf));
  CHECK_FALSE(square_is_exact(nan));
  CHECK_FALSE(square_is_exact(1e-36f));
  CHECK(square_is_exact(1e-30f));
}

TEMPLATE_TEST_CASE("Scalar: accuracy of norm and of the root of a product", "", double, float) {
  using T = TestType;
  Random random;
  Worst length("norm" + precision_name<T>()), root("root of a product" + precision_name<T>());
  const int most = std::numeric_limits<T>::max_exponent - 2;
  for (int i = 0; i < cases(50000); ++i) {
    const int scale = smallest_exponent<T> + 60 +
                      static_cast<int>(random.engine() % static_cast<unsigned>(most - smallest_exponent<T> - 60));
    const auto component = [&] { return random.binary<T>(scale - 60, scale); };
    const Vec3<T> v(component(), component(), component());
    const Vec3<Binary200> exact(Binary200(v.x()), Binary200(v.y()), Binary200(v.z()));
    length.see(ulps(norm<T>(v), norm<Binary200>(exact)), v.x(), v.y(), v.z());

    const T radius = random.binary<T>(-60, 10), overlap = random.binary<T>(smallest_exponent<T>, 10);
    root.see(ulps(sqrt_of_product<T>(radius, overlap), Binary200(sqrt(Binary200(radius) * Binary200(overlap)))), radius,
             overlap);
  }
  CHECK(length.error() <=
        3.0);                  // half of three roundings of squares, a root; where scaled a quotient and a product more
  CHECK(root.error() <= 2.0);  // below the normal numbers, two roots and a product
  CHECK(sqrt_of_product<T>(T(4), T(0)) == T(0));
}

}  // namespace contactlaws::test
