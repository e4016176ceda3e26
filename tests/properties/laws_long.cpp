#include "law_list.hpp"

namespace contactlaws::test {
template <>
Laws<long double> all_laws() {
  return erase_laws<long double>();
}
}  // namespace contactlaws::test
