// LAW.toml of examples/contact_path, read and built: a law with its parameters in range, or a message.
#include "examples/contact_path/build_law.hpp"

#include "examples/contact_path/law_file.hpp"
#include "input_file.hpp"

extern "C" int LLVMFuzzerInitialize(int*, char***) { return 0; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::expect_read_or_refused<contact_path::InputError>(data, size, [](const std::string& file) {
    const contact_path::LawDescription law = contact_path::read_law(file);
    const auto slots = contact_path::build_law<double>(law);
    std::visit([](const auto& slot) { contactlaws::checked(slot); }, slots.bridge);
  });
  return 0;
}
