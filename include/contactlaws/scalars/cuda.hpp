// SPDX-License-Identifier: MIT
// A batch of contacts on a GPU. evaluate(law, batch, stream) is evaluate(law, batch) of batch.hpp with arrays in device
// memory: the same laws, columns and kernel text, one thread a contact. It allocates nothing and waits for nothing; an
// error of the launch is returned. A host that keeps bodies instead of contact arrays calls law.step() in a kernel of
// its own.
//
// Against the CPU's results without fused multiply-adds (g++ -ffp-contract=off), tests/gpu/test_gpu.cu requires:
//
//   nvcc -fmad=false   the same bits, where a law calls no pow, exp, sin or cos
//   otherwise          those of a CPU whose inputs and history differ by a few units in the last place
//
// nvcc needs -std=c++17 --expt-relaxed-constexpr, and with Eigen -diag-suppress 20012.
#pragma once

#if !defined(__CUDACC__)
#error "contactlaws/scalars/cuda.hpp needs a CUDA compiler; batch.hpp and scalars/xsimd.hpp are for the CPU"
#endif

#include <cstddef>
#include <limits>
#include <type_traits>

#include <cuda_runtime.h>

#include "contactlaws/batch.hpp"

namespace contactlaws {

namespace detail {

constexpr unsigned threads_per_block = 128;

/// Steps one contact a thread. In a loop over contacts the loads of one would wait for the stores of the one before: a
/// state may be stored where it was loaded, so the compiler must keep their order. GivenLaw: Law, or with Columns.
template <class Law, class GivenLaw>
__global__ void __launch_bounds__(threads_per_block)
    step_contacts(const __grid_constant__ GivenLaw law, const __grid_constant__ ContactBatch<Law> batch) {
  using T = typename Law::Scalar;
  const std::size_t contact = std::size_t(blockIdx.x) * threads_per_block + threadIdx.x;
  if (contact >= batch.count) return;
  const PackRange<T, true> range(contact, 1);
  const BatchGather<Law, T> gather{batch};
  const BatchScatter<Law> scatter{batch};
  if constexpr (std::is_same_v<GivenLaw, Law>) {
    step_pack<Law, T>(law, range, batch.state, batch.next, gather, scatter);
  } else {
    const auto parameter = [&range](const auto& column) { return range.load(column); };
    step_pack<Law, T>(law.template cast<T>(parameter), range, batch.state, batch.next, gather, scatter);
  }
}

template <class Law, class GivenLaw>
cudaError_t launch(const GivenLaw& law, const ContactBatch<Law>& batch, cudaStream_t stream) noexcept {
  if (batch.count == 0) return cudaSuccess;  // a grid without blocks would be an error
  const std::size_t blocks = (batch.count - 1) / threads_per_block + 1;
  if (blocks > std::size_t(std::numeric_limits<int>::max())) return cudaErrorInvalidConfiguration;
  cudaLaunchConfig_t config{};
  config.gridDim = dim3(unsigned(blocks));
  config.blockDim = dim3(threads_per_block);
  config.stream = stream;
  return cudaLaunchKernelEx(&config, step_contacts<Law, GivenLaw>, law, batch);
}

}  // namespace detail

/// Queues a step of every contact of the batch on the stream. The arrays must live until it is done; the law and the
/// batch themselves are copied. As of any launch, an error of work queued before may be returned too.
template <class Law>
cudaError_t evaluate(const Law& law, const ContactBatch<Law>& batch, cudaStream_t stream) noexcept {
  return detail::launch<Law>(law, batch, stream);
}

/// The same with parameters that may differ from contact to contact, as in `law.cast<Column<double>>()`: each a number
/// for all contacts or an array in device memory. Parameters in arrays are not checked.
template <class Law>
cudaError_t evaluate(const typename Law::template Rebind<Column<typename Law::Scalar>>& law,
                     const ContactBatch<Law>& batch, cudaStream_t stream) noexcept {
  return detail::launch<Law>(law, batch, stream);
}

}  // namespace contactlaws
