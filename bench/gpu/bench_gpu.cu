// SPDX-License-Identifier: MIT
// Batches on a GPU beside copies of as many bytes from device memory to device memory, in one process:
//
//   bench_gpu RESULTS.json      every law and size
//   bench_gpu --one             one law at one size a few times, for a profiler
//
// The contacts are those of contacts.hpp, some of them over and over. Each time is the median of 11 repetitions, and
// one of these is at least 0.3 ms of launches in a row, between two events. A batch moves in one launch and back in the
// next. Up to some 1e5 contacts the arrays stay in the second-level cache, those of the batch and those of the copy.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <utility>
#include <vector>

#include "../contact_arrays.hpp"
#include "contactlaws/scalars/cuda.hpp"
#include "device_arrays.hpp"

namespace {

using namespace bench;

constexpr int repetitions = 11;
constexpr std::size_t different = 1 << 17;  // contacts

__global__ void copy(const float4* from, float4* to, std::size_t count) {
  const std::size_t i = std::size_t(blockIdx.x) * blockDim.x + threadIdx.x;
  if (i < count) to[i] = from[i];
}

/// Seconds of one call of `queue(i, stream)`, which queues work number i.
template <class Queue>
double seconds(const Queue& queue) {
  cudaStream_t stream;
  cudaEvent_t start, stop;
  CONTACTLAWS_CUDA(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking));
  CONTACTLAWS_CUDA(cudaEventCreate(&start));
  CONTACTLAWS_CUDA(cudaEventCreate(&stop));
  const auto time = [&](int calls) {
    CONTACTLAWS_CUDA(cudaEventRecord(start, stream));
    for (int i = 0; i < calls; ++i) queue(i, stream);
    CONTACTLAWS_CUDA(cudaEventRecord(stop, stream));
    CONTACTLAWS_CUDA(cudaEventSynchronize(stop));
    float milliseconds = 0.0F;
    CONTACTLAWS_CUDA(cudaEventElapsedTime(&milliseconds, start, stop));
    return 1e-3 * double(milliseconds);
  };
  time(4);  // to warm up
  const double once = time(4) / 4.0;
  const int calls = 2 * std::clamp(int(1.5e-4 / once), 1, 100);  // there and back
  std::vector<double> times;
  for (int i = 0; i < repetitions; ++i) times.push_back(time(calls) / calls);
  std::nth_element(times.begin(), times.begin() + repetitions / 2, times.end());
  CONTACTLAWS_CUDA(cudaEventDestroy(start));
  CONTACTLAWS_CUDA(cudaEventDestroy(stop));
  CONTACTLAWS_CUDA(cudaStreamDestroy(stream));
  return times[repetitions / 2];
}

/// Bytes per second of the fastest copy that moves this many bytes, read and written together.
struct Copies {
  double kernel = 0.0, runtime = 0.0;

  explicit Copies(std::size_t bytes) {
    const std::size_t words = bytes / (2 * sizeof(float4));
    float4 *from, *to;
    CONTACTLAWS_CUDA(cudaMalloc(&from, words * sizeof(float4)));
    CONTACTLAWS_CUDA(cudaMalloc(&to, words * sizeof(float4)));
    CONTACTLAWS_CUDA(cudaMemset(from, 0x3c, words * sizeof(float4)));  // not zeros, which can be faster
    CONTACTLAWS_CUDA(cudaDeviceSynchronize());
    const double moved = double(2 * words * sizeof(float4));
    kernel = moved / seconds([&](int, cudaStream_t stream) {
               copy<<<unsigned((words + 255) / 256), 256, 0, stream>>>(from, to, words);
             });
    CONTACTLAWS_CUDA(cudaGetLastError());
    runtime = moved / seconds([&](int, cudaStream_t stream) {
                CONTACTLAWS_CUDA(cudaMemcpyAsync(to, from, words * sizeof(float4), cudaMemcpyDeviceToDevice, stream));
              });
    CONTACTLAWS_CUDA(cudaFree(from));
    CONTACTLAWS_CUDA(cudaFree(to));
  }
  double best() const { return std::max(kernel, runtime); }
};

/// As many arrays as a batch reads and writes.
template <class T, int reads, int writes>
struct Streams {
  const T* from[reads];
  T* to[writes];
};
template <class T, int reads, int writes>
__global__ void pass(const __grid_constant__ Streams<T, reads, writes> streams, std::size_t count) {
  const std::size_t i = std::size_t(blockIdx.x) * blockDim.x + threadIdx.x;
  if (i >= count) return;
  T sum = T(0);
  for (int k = 0; k < reads; ++k) sum += streams.from[k][i];
  for (int k = 0; k < writes; ++k) streams.to[k][i] = sum;
}

/// Bytes per second of a kernel that only reads and writes arrays as a batch does: what memory leaves to a law.
template <class Law>
double bandwidth_of_streams(std::size_t count) {
  using T = typename Law::Scalar;
  constexpr int writes = int(Law::state_size) + 3;
  constexpr int reads = int(bytes_per_contact<Law>() / sizeof(T)) - writes;
  const std::size_t padded = (count + 31) / 32 * 32;
  T* all;
  CONTACTLAWS_CUDA(cudaMalloc(&all, padded * (reads + writes) * sizeof(T)));
  CONTACTLAWS_CUDA(cudaMemset(all, 0x3c, padded * (reads + writes) * sizeof(T)));
  CONTACTLAWS_CUDA(cudaDeviceSynchronize());
  Streams<T, reads, writes> streams;
  for (int k = 0; k < reads; ++k) streams.from[k] = all + padded * std::size_t(k);
  for (int k = 0; k < writes; ++k) streams.to[k] = all + padded * std::size_t(reads + k);
  const double time = seconds(
      [&](int, cudaStream_t stream) { pass<<<unsigned((count + 127) / 128), 128, 0, stream>>>(streams, count); });
  CONTACTLAWS_CUDA(cudaGetLastError());
  CONTACTLAWS_CUDA(cudaFree(all));
  return double(count * bytes_per_contact<Law>()) / time;
}

std::FILE* json = nullptr;
bool first_row = true;

template <class Law>
void measure(const char* name, const Law& law, const std::vector<Contact>& contacts, const char* mix) {
  using T = typename Law::Scalar;
  constexpr std::size_t bytes = bytes_per_contact<Law>();
  std::size_t free_bytes = 0, all_bytes = 0;
  CONTACTLAWS_CUDA(cudaMemGetInfo(&free_bytes, &all_bytes));
  constexpr std::size_t arrays_at_most = 24;  // of ContactArrays, those that its batches do not read too
  const std::size_t room = free_bytes / 10 * 9 / (arrays_at_most * sizeof(T) + bytes);
  std::vector<std::size_t> counts;
  for (const std::size_t count : {10'000, 100'000, 1'000'000, 10'000'000, 100'000'000})
    if (count <= room) counts.push_back(count);

  ContactArrays<Law> arrays(contacts);
  DeviceArrays<T> device(contacts.size(), counts.back());
  ContactBatch<Law> batches[] = {device.of(arrays.batch(true)), device.of(arrays.batch(false))};
  for (const std::size_t count : counts) {
    for (ContactBatch<Law>& batch : batches) batch.count = count;
    const double time =
        seconds([&](int i, cudaStream_t stream) { CONTACTLAWS_CUDA(evaluate(law, batches[i % 2], stream)); });
    const Copies copies(count * bytes);
    const double streams = bandwidth_of_streams<Law>(count);
    const double bandwidth = double(count * bytes) / time;
    const double share = bandwidth / copies.best();
    const char* scalar = sizeof(T) == 8 ? "double" : "float";
    std::printf(
        "%-12s %-6s %-7s %9zu %8.2f ps %3zu bytes %5.0f GB/s; copy %5.0f (kernel) %5.0f (runtime), streams %5.0f: "
        "%5.1f %%\n",
        name, scalar, mix, count, 1e12 * time / double(count), bytes, 1e-9 * bandwidth, 1e-9 * copies.kernel,
        1e-9 * copies.runtime, 1e-9 * streams, 100.0 * share);
    std::fflush(stdout);
    std::fprintf(
        json,
        "%s\n  {\"law\": \"%s\", \"scalar\": \"%s\", \"mix\": \"%s\", \"contacts\": %zu, \"launch_us\": %.3f, "
        "\"ps_per_contact\": %.3f, \"bytes_per_contact\": %zu, \"bandwidth_GBs\": %.1f, "
        "\"copy_kernel_GBs\": %.1f, \"copy_runtime_GBs\": %.1f, \"streams_GBs\": %.1f, \"share_of_copy\": %.4f}",
        first_row ? "" : ",", name, scalar, mix, count, 1e6 * time, 1e12 * time / double(count), bytes,
        1e-9 * bandwidth, 1e-9 * copies.kernel, 1e-9 * copies.runtime, 1e-9 * streams, share);
    std::fflush(json);
    first_row = false;
  }
  // A batch that steps nothing would be fast too.
  std::vector<T> force(contacts.size(), T(0));
  CONTACTLAWS_CUDA(cudaMemcpy(force.data(), batches[0].force[2], force.size() * sizeof(T), cudaMemcpyDeviceToHost));
  const auto useless = std::count_if(force.begin(), force.end(), [](T x) { return x == T(0) || x != x; });
  if (useless > std::ptrdiff_t(force.size() / 5)) {
    std::printf("FAILED: %s computes no forces\n", name);
    std::exit(1);
  }
}

template <class Law>
void measure_mixes(const char* name, const Law& law) {
  for (const auto& [mix_name, mix] :
       {std::pair{"resting", Mix{0.0, 0.0, 1.0}}, std::pair{"mixed", Mix{0.05, 0.05, 1.0}}}) {
    const std::vector<Contact> contacts = make_contacts(different, mix);
    measure(name, law, contacts, mix_name);
    measure(name, law.template cast<float>(), contacts, mix_name);
  }
}

void start_json(const char* file) {
  cudaDeviceProp device{};
  int driver = 0, runtime = 0;
  CONTACTLAWS_CUDA(cudaGetDeviceProperties(&device, 0));
  CONTACTLAWS_CUDA(cudaDriverGetVersion(&driver));
  CONTACTLAWS_CUDA(cudaRuntimeGetVersion(&runtime));
  const std::time_t now = std::time(nullptr);
  char date[32];
  std::strftime(date, sizeof(date), "%Y-%m-%d", std::gmtime(&now));
  std::printf("%s, %d multiprocessors, CUDA driver %d, runtime %d, %s\n", device.name, device.multiProcessorCount,
              driver, runtime, date);
  json = std::fopen(file, "w");
  if (json == nullptr) {
    std::perror(file);
    std::exit(1);
  }
  std::fprintf(json,
               "{\"device\": \"%s\", \"multiprocessors\": %d, \"l2_bytes\": %d, \"memory_bytes\": %zu, "
               "\"driver_api\": %d, \"runtime\": %d, \"date\": \"%s\", \"repetitions\": %d, \"rows\": [",
               device.name, device.multiProcessorCount, device.l2CacheSize, device.totalGlobalMem, driver, runtime,
               date, repetitions);
}

}  // namespace

int main(int argc, char** argv) {
  int devices = 0;
  if (cudaGetDeviceCount(&devices) != cudaSuccess || devices == 0) {
    std::puts("skipped: no GPU");
    return 77;
  }
  if (argc > 1 && std::strcmp(argv[1], "--one") == 0) {
    using Law = DryHill<double>;
    ContactArrays<Law> arrays(make_contacts(different, {0.05, 0.05, 1.0}));
    DeviceArrays<double> device(different, 10'000'000);
    const ContactBatch<Law> batch = device.of(arrays.batch(true));
    for (int i = 0; i < 4; ++i) CONTACTLAWS_CUDA(evaluate(granite<Law>(), batch, nullptr));
    CONTACTLAWS_CUDA(cudaDeviceSynchronize());
    return 0;
  }
  start_json(argc > 1 ? argv[1] : "gpu.json");
  measure_mixes("DryHill", granite<DryHill<double>>());
  measure_mixes("Hill", granite<Hill<double>>());
  measure_mixes("RoughBallast", granite<RoughBallast<double>>());
  std::fprintf(json, "\n]}\n");
  std::fclose(json);
}
