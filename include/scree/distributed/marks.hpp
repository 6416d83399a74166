// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/space.hpp"
#include "check_cuda.hpp"

#include <Kokkos_Core.hpp>

// Synchronisation of kernels in several processes, for PeerMemory.
namespace scree::detail {

/// A mark in the queue of an execution space instance, for which kernels of another process can wait. A FencedMark
/// needs no support from the device: the host waits in set(). All marks have these members:
///   Mark()          creates a mark of this process
///   handle()        returns the bytes that another process needs to find the mark
///   set(space)      moves the mark to the end of the queue of the instance, after all its kernels and copies
///   Found(handle)   the mark of another process
///   pass(space)     makes later kernels of the instance wait for the work before the mark; no wait if the mark was
///                   never set
///   words(space)    returns text for people, to append to the name of a transport
struct FencedMark {
  struct Handle {};
  Handle handle() const { return {}; }
  template <class Space>
  void set(Space const& space) const {
    space.fence("scree::mark");
  }
  struct Found {
    explicit Found(Handle const&) {}
    template <class Space>
    void pass(Space const&) const {}
  };
  template <class Space>
  static char const* words(Space const&) {
    return on_host<Space> ? "" : ", the host waits for each message";
  }
};

#ifdef KOKKOS_ENABLE_CUDA
/// A mark for NVIDIA GPUs on one host: an event of CUDA's interprocess communication.
class EventMark {
 public:
  using Handle = cudaIpcEventHandle_t;

  EventMark() {
    check_cuda(cudaEventCreateWithFlags(&event_, cudaEventDisableTiming | cudaEventInterprocess),
               "no event for messages");
    check_cuda(cudaIpcGetEventHandle(&handle_, event_), "events of this GPU cannot be shared");
  }
  EventMark(EventMark const&) = delete;
  EventMark& operator=(EventMark const&) = delete;
  ~EventMark() { (void)cudaEventDestroy(event_); }
  Handle handle() const { return handle_; }
  void set(Kokkos::Cuda const& space) const { check_cuda(cudaEventRecord(event_, space.cuda_stream()), "event"); }

  static char const* words(Kokkos::Cuda const&) { return ""; }

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
