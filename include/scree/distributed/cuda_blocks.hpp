// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <Kokkos_Core.hpp>

#ifdef KOKKOS_ENABLE_CUDA

#include <cstddef>
#include <stdexcept>
#include <string>

namespace scree {

/// Memory of NVIDIA GPUs that other processes of the same host can map, for PeerMemory: CUDA's interprocess
/// communication. Between GPUs the bytes travel over NVLink or PCIe, without the host.
struct CudaBlocks {
  using Handle = cudaIpcMemHandle_t;

  /// Throws std::runtime_error where CUDA refuses it.
  static void check(cudaError_t result, char const* what) {
    if (result == cudaSuccess) return;
    (void)cudaGetLastError();  // an error that is not fatal stays there until somebody takes it
    throw std::runtime_error(std::string("scree: ") + what + ": " + cudaGetErrorString(result));
  }

  class Block {
   public:
    explicit Block(std::size_t size) {
      check(cudaMalloc(&bytes_, size), "no memory for messages between GPUs");
      check(cudaIpcGetMemHandle(&handle_, bytes_), "memory of this GPU cannot be shared");
    }
    Block(Block const&) = delete;
    Block& operator=(Block const&) = delete;
    ~Block() { (void)cudaFree(bytes_); }
    std::byte* data() const { return static_cast<std::byte*>(bytes_); }
    Handle handle() const { return handle_; }

   private:
    void* bytes_ = nullptr;
    Handle handle_ = {};
  };

  class Mapped {
   public:
    explicit Mapped(Handle const& handle) {
      check(cudaIpcOpenMemHandle(&bytes_, handle, cudaIpcMemLazyEnablePeerAccess),
            "memory of another GPU cannot be mapped");
    }
    Mapped(Mapped const&) = delete;
    Mapped& operator=(Mapped const&) = delete;
    ~Mapped() { (void)cudaIpcCloseMemHandle(bytes_); }
    std::byte* data() const { return static_cast<std::byte*>(bytes_); }

   private:
    void* bytes_ = nullptr;
  };

  static void copy(Kokkos::Cuda const& space, std::byte* to, std::byte const* from, std::size_t bytes) {
    check(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToDevice, space.cuda_stream()), "copy between GPUs");
  }
};

}  // namespace scree

#endif
