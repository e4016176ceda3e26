// Rows of four doubles to packs and back.
#include "contactlaws/rows.hpp"

#include <vector>

#include "catch.hpp"
#include "contactlaws/scalars/xsimd.hpp"
#include "random.hpp"

namespace contactlaws::test {

/// Gathers rows in random order and stores them again.
template <class Pack>
void check_rows() {
  constexpr std::size_t lanes = ScalarTraits<Pack>::lanes, count = 37;
  Random random;
  std::vector<double> rows(4 * count);
  for (double& x : rows) x = random.uniform(-1.0, 1.0);
  for (int trial = 0; trial < 100; ++trial) {
    Ids<Pack> ids;
    for (std::size_t& id : ids) id = static_cast<std::size_t>(random.integer(0, count - 1));
    const std::array<Pack, 4> packs = gather_rows<Pack>(rows.data(), ids);
    std::array<double, lanes> column;
    for (std::size_t i = 0; i < 4; ++i) {
      ScalarTraits<Pack>::store(column.data(), packs[i]);
      for (std::size_t l = 0; l < lanes; ++l) REQUIRE(column[l] == rows[4 * ids[l] + i]);
    }
    std::array<double, 4 * lanes> stored{};
    store_rows<Pack>(stored.data(), packs);
    for (std::size_t l = 0; l < lanes; ++l)
      for (std::size_t i = 0; i < 4; ++i) REQUIRE(stored[4 * l + i] == rows[4 * ids[l] + i]);
  }
}

TEST_CASE("Rows: one number, and the widest pack") {
  check_rows<double>();
  check_rows<PackOf<double>::type>();
}

}  // namespace contactlaws::test
