// RECORDING.csv of bench/trade: contacts that move, the longest first, or a message.
#include "bench/trade/recording_file.hpp"
#include "input_file.hpp"

extern "C" int LLVMFuzzerInitialize(int*, char***) { return 0; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::expect_read_or_refused<common::InputError>(data, size, [](const std::string& file) {
    const trade::Trajectories trajectories = trade::read_recording(file);
    std::size_t before = 0, most = trajectories.in_double.size();
    for (const std::size_t end : trajectories.offset) {
      if (end < before || end - before > most) std::abort();
      most = end - before;
      before = end;
    }
    if (before != trajectories.in_double.size() || trajectories.exact.size() != trajectories.in_double.size())
      std::abort();
  });
  return 0;
}
