#include "law_list.hpp"

namespace contactlaws::test {
template <>
Laws<double> all_laws() {
  return erase_laws<double>();
}
}  // namespace contactlaws::test
