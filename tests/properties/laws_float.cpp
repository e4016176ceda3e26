#include "law_list.hpp"

namespace contactlaws::test {
template <>
Laws<float> all_laws() {
  return erase_laws<float>();
}
}  // namespace contactlaws::test
