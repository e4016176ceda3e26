// SPDX-License-Identifier: MIT
// A batch of the host, mirrored in device memory, for the tests and benchmarks of scalars/cuda.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <map>

#include <cuda_runtime.h>

#include "contactlaws/batch.hpp"

namespace bench {

/// Stops the program where a call of CUDA fails.
inline void require_done(cudaError_t error, const char* call, int line) {
  if (error == cudaSuccess) return;
  std::fprintf(stderr, "line %d: %s: %s\n", line, call, cudaGetErrorString(error));
  std::exit(1);
}
#define CONTACTLAWS_CUDA(call) bench::require_done(call, #call, __LINE__)

/// Device arrays of `count` numbers, one for each array of the host that is asked for. It holds the host's `given`
/// numbers over and over: a few contacts of the host fill the device.
template <class T>
class DeviceArrays {
 public:
  DeviceArrays(std::size_t given, std::size_t count) : given_(given), count_(count) {}
  DeviceArrays(const DeviceArrays&) = delete;
  DeviceArrays& operator=(const DeviceArrays&) = delete;
  ~DeviceArrays() {
    for (const auto& pair : arrays_) cudaFree(pair.second);
  }

  /// The device's array of a host's array; the same one each time.
  T* of(const T* host) {
    if (host == nullptr) return nullptr;
    T*& array = arrays_[host];
    if (array == nullptr) {
      CONTACTLAWS_CUDA(cudaMalloc(&array, std::max<std::size_t>(count_, 1) * sizeof(T)));
      upload(host);
    }
    return array;
  }
  contactlaws::Column<T> of(const contactlaws::Column<T>& column) {
    if (column.array() == nullptr) return column;
    return static_cast<const T*>(of(column.array()));
  }
  /// The batch with the device's arrays.
  template <class Law>
  contactlaws::ContactBatch<Law> of(contactlaws::ContactBatch<Law> batch) {
    const auto mirror = [this](auto& columns) {
      for (auto& column : columns) column = of(column);
    };
    batch.count = count_;
    for (const auto& property : decltype(batch.pair)::parameters())
      batch.pair.*property.member = of(batch.pair.*property.member);
    mirror(batch.normal);
    batch.overlap = of(batch.overlap);
    mirror(batch.velocity);
    batch.dt = of(batch.dt);
    batch.normal_spin = of(batch.normal_spin);
    mirror(batch.relative_spin);
    mirror(batch.state);
    mirror(batch.next);
    mirror(batch.force);
    mirror(batch.couple);
    return batch;
  }

  /// Copies an array of the host to the device's, and back to the first `given` numbers.
  void upload(const T* host) {
    T* const array = arrays_.at(host);
    std::size_t filled = std::min(given_, count_);
    CONTACTLAWS_CUDA(cudaMemcpy(array, host, filled * sizeof(T), cudaMemcpyHostToDevice));
    while (filled > 0 && filled < count_) {
      const std::size_t more = std::min(filled, count_ - filled);
      CONTACTLAWS_CUDA(cudaMemcpy(array + filled, array, more * sizeof(T), cudaMemcpyDeviceToDevice));
      filled += more;
    }
    CONTACTLAWS_CUDA(cudaDeviceSynchronize());  // streams that do not block would not wait for these copies
  }
  void download(T* host) const {
    CONTACTLAWS_CUDA(cudaDeviceSynchronize());
    CONTACTLAWS_CUDA(cudaMemcpy(host, arrays_.at(host), given_ * sizeof(T), cudaMemcpyDeviceToHost));
  }

 private:
  std::size_t given_, count_;
  std::map<const T*, T*> arrays_;
};

}  // namespace bench
