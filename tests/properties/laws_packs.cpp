#include "contactlaws/scalars/xsimd.hpp"
#include "law_list.hpp"

namespace contactlaws::test {
template <>
Laws<xsimd::batch<double>> all_laws() {
  return erase_laws<xsimd::batch<double>>();
}
template <>
Laws<xsimd::batch<float>> all_laws() {
  return erase_laws<xsimd::batch<float>>();
}
}  // namespace contactlaws::test
