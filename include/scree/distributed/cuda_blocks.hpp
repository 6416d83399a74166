// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "check_cuda.hpp"

#include <Kokkos_Core.hpp>

#ifdef KOKKOS_ENABLE_CUDA

#include <cstddef>

namespace scree {

/// Memory of NVIDIA GPUs that other processes of the same host can map, for PeerMemory: CUDA's interprocess
/// communication. Between GPUs the bytes travel over NVLink or PCIe, without the host.
struct CudaBlocks {
  static constexpr char const* name = "processes that write into each other's memory";
  using Handle = cudaIpcMemHandle_t;

  class Block {
   public:
    /// Allocates bytes. Throws std::runtime_error if the GPU has too few of them or cannot share them.
    explicit Block(std::size_t size) {
      detail::check_cuda(cudaMalloc(&bytes_, size), "no memory for messages between GPUs");
      detail::check_cuda(cudaIpcGetMemHandle(&handle_, bytes_), "memory of this GPU cannot be shared");
    }
    Block(Block const&) = delete;
    Block& operator=(Block const&) = delete;
    ~Block() { (void)cudaFree(bytes_); }
    /// The first byte.
    std::byte* data() const { return static_cast<std::byte*>(bytes_); }
    /// Returns the handle with which another process maps the block.
    Handle handle() const { return handle_; }

   private:
    void* bytes_ = nullptr;
    Handle handle_ = {};
  };

  class Mapped {
   public:
    /// Maps the block of another process. Throws std::runtime_error if that fails.
    explicit Mapped(Handle const& handle) {
      detail::check_cuda(cudaIpcOpenMemHandle(&bytes_, handle, cudaIpcMemLazyEnablePeerAccess),
                         "memory of another GPU cannot be mapped");
    }
    Mapped(Mapped const&) = delete;
    Mapped& operator=(Mapped const&) = delete;
    ~Mapped() { (void)cudaIpcCloseMemHandle(bytes_); }
    /// The first byte, as this process sees it.
    std::byte* data() const { return static_cast<std::byte*>(bytes_); }

   private:
    void* bytes_ = nullptr;
  };

  /// Copies bytes between memory of GPUs, in the order of the instance. Throws std::runtime_error if CUDA refuses.
  static void copy(Kokkos::Cuda const& space, std::byte* to, std::byte const* from, std::size_t bytes) {
    detail::check_cuda(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToDevice, space.cuda_stream()),
                       "copy between GPUs");
  }
};

}  // namespace scree

#endif
