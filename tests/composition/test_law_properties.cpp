#include <tuple>

namespace contactlaws::test {
using Scalars = std::tuple<double, float>;
}
#include "scalar_properties.hpp"
