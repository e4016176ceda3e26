// A pack of contacts takes, in each lane, exactly the path of that contact alone.
#include "catch.hpp"
#include "contactlaws/scalars/xsimd.hpp"
#include "properties/packs.hpp"

namespace contactlaws::test {

TEMPLATE_TEST_CASE("a pack does lane by lane what one contact does", "", double, float) {
  using Lane = TestType;
// A compiler that may fuse a multiplication and an addition need not do so in both texts.
#if defined(__FMA__)
  constexpr bool fused = true;
#else
  constexpr bool fused = false;
#endif
  const auto laws = all_laws<Lane>();
  for (const auto& packed : all_laws<xsimd::batch<Lane>>()) {
    INFO(packed->name);
    const ErasedLaw<Lane>& law = law_named(packed->name, laws);
    // The functions that a pack computes by formulas of its own; the rest is + - * / sqrt, the same in every text.
    const bool equal_bits = !fused && has_equal_packs(law);
    Random random = random_for("packs", law.name);
    for (int repeat = 0; repeat < cases(20); ++repeat) {
      std::vector<Path> paths;
      for (std::size_t i = 0; i < xsimd::batch<Lane>::size; ++i) paths.push_back(random_path(random, 10));
      for (auto& path : paths) path.wet = paths[0].wet;
      const PackErrors errors = error_in_packs(law, *packed, paths);
      CHECK(errors.force <= (equal_bits ? 0.0 : 100.0));
      CHECK(errors.active == 0);
      if (equal_bits) CHECK(errors.changed == 0);
    }
  }
}

}  // namespace contactlaws::test
