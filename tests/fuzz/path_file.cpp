// PATH.csv of examples/contact_path: steps whose numbers are finite and whose normals have unit length, or a message.
#include "examples/contact_path/path_file.hpp"
#include "input_file.hpp"

namespace {

template <class T>
void read(const std::string& file) {
  for (const auto& step : contact_path::read_path<T>(file)) {
    const auto& k = step.kinematics;
    // norm and quotient round a few times each
    const bool unit = std::abs(contactlaws::norm<T>(k.normal) - T(1)) < 8 * std::numeric_limits<T>::epsilon();
    const bool finite = std::isfinite(k.overlap) && k.velocity.allFinite() && std::isfinite(k.normal_spin);
    if (!unit || !finite || !(k.dt >= T(0)) || step.moisture_gap.value_or(T(0)) < T(0)) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) { return 0; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::expect_read_or_refused<common::InputError>(data, size, read<double>);
  fuzz::expect_read_or_refused<common::InputError>(data, size, read<float>);
  return 0;
}
