#include <tuple>

#include "contactlaws/scalars/multiprecision.hpp"
#include "random.hpp"

namespace contactlaws::test {
// Sanitizers would look at Boost's arithmetic, and be long about it.
using Scalars = std::conditional_t<sanitized, std::tuple<long double>, std::tuple<long double, Binary200>>;
}  // namespace contactlaws::test
#include "scalar_properties.hpp"
