// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "check_cuda.hpp"

#include <Kokkos_Core.hpp>

#ifdef KOKKOS_ENABLE_CUDA

#include <cstddef>

namespace scree {

/// Memory of NVIDIA GPUs that other processes on the same host can map by CUDA's interprocess communication, for
/// PeerMemory. Bytes travel between GPUs over NVLink or PCIe, without passing through host memory.
struct CudaBlocks {
  static constexpr char const* name = "processes that write into each other's memory";
  using Handle = cudaIpcMemHandle_t;

  class Block {
   public:
    /// Allocates a block of bytes. Throws std::runtime_error if the GPU has too little memory or cannot share memory.
    explicit Block(std::size_t size) {
      detail::check_cuda(cudaMalloc(&bytes_, size), "no memory for messages between GPUs");
      detail::check_cuda(cudaIpcGetMemHandle(&handle_, bytes_), "memory of this GPU cannot be shared");
    }
    Block(Block const&) = delete;
    Block& operator=(Block const&) = delete;
    ~Block() { (void)cudaFree(bytes_); }
    /// Returns the address of the first byte.
    std::byte* data() const { return static_cast<std::byte*>(bytes_); }
    /// Returns the handle with which another process maps the block.
    Handle handle() const { return handle_; }

   private:
    void* bytes_ = nullptr;
    Handle handle_ = {};
  };

  class Mapped {
   public:
    /// Maps a block of another process. Throws std::runtime_error if the mapping fails.
    explicit Mapped(Handle const& handle) {
      detail::check_cuda(cudaIpcOpenMemHandle(&bytes_, handle, cudaIpcMemLazyEnablePeerAccess),
                         "memory of another GPU cannot be mapped");
    }
    Mapped(Mapped const&) = delete;
    Mapped& operator=(Mapped const&) = delete;
    ~Mapped() { (void)cudaIpcCloseMemHandle(bytes_); }
    /// Returns the address of the first byte in this process.
    std::byte* data() const { return static_cast<std::byte*>(bytes_); }

   private:
    void* bytes_ = nullptr;
  };

  /// Begins to copy bytes between GPUs on the stream of an execution space instance. Throws std::runtime_error if CUDA
  /// reports an error.
  static void copy(Kokkos::Cuda const& space, std::byte* to, std::byte const* from, std::size_t bytes) {
    detail::check_cuda(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToDevice, space.cuda_stream()),
                       "copy between GPUs");
  }
};

}  // namespace scree

#endif
