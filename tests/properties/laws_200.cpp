#include "contactlaws/scalars/multiprecision.hpp"
#include "law_list.hpp"

namespace contactlaws::test {
template <>
Laws<Binary200> all_laws() {
  return erase_laws<Binary200>();
}
}  // namespace contactlaws::test
