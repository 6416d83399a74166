// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "check_cuda.hpp"

#include <Kokkos_Core.hpp>

// Order between the kernels of several processes, for PeerMemory.
namespace scree::detail {

/// A mark between the kernels of an instance, which those of another process can wait for.
///   Mark()          of this process
///   handle()        bytes that another process needs to find it
///   set(space)      sets it behind all kernels and copies of the instance, instead of where it was
///   Found(handle)   the mark of another process
///   pass(space)     later kernels of the instance wait for the place where the mark was set last; no wait if it never
///   was
/// Where loops end before they return, as on a host, there is nothing to wait for.
template <class Space>
struct Mark {
  struct Handle {};
  Handle handle() const { return {}; }
  void set(Space const&) const {}
  struct Found {
    explicit Found(Handle const&) {}
    void pass(Space const&) const {}
  };
};

#ifdef KOKKOS_ENABLE_CUDA
/// On NVIDIA GPUs of one host: an event of CUDA's interprocess communication.
template <>
class Mark<Kokkos::Cuda> {
 public:
  using Handle = cudaIpcEventHandle_t;

  Mark() {
    check_cuda(cudaEventCreateWithFlags(&event_, cudaEventDisableTiming | cudaEventInterprocess),
               "no event for messages");
    check_cuda(cudaIpcGetEventHandle(&handle_, event_), "events of this GPU cannot be shared");
  }
  Mark(Mark const&) = delete;
  Mark& operator=(Mark const&) = delete;
  ~Mark() { (void)cudaEventDestroy(event_); }
  Handle handle() const { return handle_; }
  void set(Kokkos::Cuda const& space) const { check_cuda(cudaEventRecord(event_, space.cuda_stream()), "event"); }

  class Found {
   public:
    explicit Found(Handle const& handle) {
      check_cuda(cudaIpcOpenEventHandle(&event_, handle), "events of another GPU cannot be found");
    }
    Found(Found const&) = delete;
    Found& operator=(Found const&) = delete;
    ~Found() { (void)cudaEventDestroy(event_); }
    void pass(Kokkos::Cuda const& space) const {
      check_cuda(cudaStreamWaitEvent(space.cuda_stream(), event_), "wait for another GPU");
    }

   private:
    cudaEvent_t event_ = nullptr;
  };

 private:
  cudaEvent_t event_ = nullptr;
  Handle handle_ = {};
};
#endif

}  // namespace scree::detail
