// LAW.toml of examples/contact_path, read and built: a law whose state has a name for each value, or a message.
#include "contact_path/law_file.hpp"
#include "contact_path/any_law.hpp"
#include "input_file.hpp"

extern "C" int LLVMFuzzerInitialize(int*, char***) { return 0; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::expect_read_or_refused<common::InputError>(data, size, [](const std::string& file) {
    const contact_path::LawSpec spec = contact_path::read_law(file);
    const auto law = contact_path::build_law<double>(spec, contact_path::build_pair<double>(spec));
    if (law->state_values().size() != law->first_state().size()) std::abort();
  });
  return 0;
}
