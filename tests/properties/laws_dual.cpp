#include "dual.hpp"
#include "law_list.hpp"

namespace contactlaws::test {
template <>
Laws<Dual> all_laws() {
  return erase_laws<Dual>();
}
}  // namespace contactlaws::test
