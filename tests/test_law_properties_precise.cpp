#include <tuple>

#include "contactlaws/adapt/multiprecision.hpp"

namespace contactlaws::test {
using Scalars = std::tuple<long double, Binary200>;
}
#include "scalar_properties.hpp"
