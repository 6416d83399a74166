// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#ifdef __linux__

#include "../core/space.hpp"
#include "check_cuda.hpp"

#include <Kokkos_Core.hpp>

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fcntl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace scree {
namespace detail {

/// An open file, closed by the destructor.
class OpenFile {
 public:
  /// Takes ownership of a file descriptor. Throws std::runtime_error(message) if `number` is negative, because the file
  /// could not be opened.
  OpenFile(int number, char const* message) : number_(number) {
    if (number < 0) throw std::runtime_error(message);
  }
  OpenFile(OpenFile const&) = delete;
  OpenFile& operator=(OpenFile const&) = delete;
  ~OpenFile() { close(number_); }
  int number() const { return number_; }
  /// Returns two numbers (device and inode) that together identify the file on this system.
  std::array<std::uint64_t, 2> identity() const {
    struct stat about = {};
    if (fstat(number_, &about) != 0) throw std::runtime_error("scree: shared memory without an identity");
    return {std::uint64_t(about.st_dev), std::uint64_t(about.st_ino)};
  }

 private:
  int number_;
};

/// A file mapped into the memory of this process, page-locked if Kokkos uses CUDA. Construction throws
/// std::runtime_error if the system refuses the mapping.
class SharedPages {
 public:
  SharedPages(OpenFile const& file, std::size_t size)
      : size_(size), bytes_(mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file.number(), 0)) {
    if (bytes_ == MAP_FAILED) throw std::runtime_error("scree: memory that processes share cannot be mapped");
#ifdef KOKKOS_ENABLE_CUDA
    try {
      check_cuda(cudaHostRegister(bytes_, size, cudaHostRegisterPortable), "shared memory cannot be page-locked");
    } catch (...) {
      munmap(bytes_, size_);
      throw;
    }
#endif
  }
  SharedPages(SharedPages const&) = delete;
  SharedPages& operator=(SharedPages const&) = delete;
  ~SharedPages() {
#ifdef KOKKOS_ENABLE_CUDA
    (void)cudaHostUnregister(bytes_);
#endif
    munmap(bytes_, size_);
  }
  /// The first byte.
  std::byte* data() const { return static_cast<std::byte*>(bytes_); }

 private:
  std::size_t size_;
  void* bytes_;
};

}  // namespace detail

/// Memory shared by processes on a Linux host, for PeerMemory. GPUs copy to and from this memory at the speed of their
/// bus.
struct HostBlocks {
  static constexpr char const* name = "processes that share memory of the host";
  /// The anonymous file of a block, as other processes of the same user open it. In another container the path may name
  /// another file.
  struct Handle {
    char path[64];
    std::size_t size;
    std::array<std::uint64_t, 2> identity;
  };

  class Block {
   public:
    /// Allocates a block of bytes that other processes can map. Throws std::runtime_error if the system has too little
    /// memory.
    explicit Block(std::size_t size)
        : size_(size),
          file_(memfd_create("scree", MFD_CLOEXEC), "scree: no memory that processes share"),
          pages_(grown(file_, size), size) {}
    /// The first byte.
    std::byte* data() const { return pages_.data(); }
    /// Returns the handle with which another process maps the block.
    Handle handle() const {
      Handle handle{{}, size_, file_.identity()};
      std::snprintf(handle.path, sizeof handle.path, "/proc/%d/fd/%d", int(getpid()), file_.number());
      return handle;
    }

   private:
    static detail::OpenFile const& grown(detail::OpenFile const& file, std::size_t size) {
      if (ftruncate(file.number(), static_cast<off_t>(size)) != 0)
        throw std::runtime_error("scree: too little memory that processes share");
      return file;
    }
    std::size_t size_;
    detail::OpenFile file_;
    detail::SharedPages pages_;
  };

  class Mapped {
   public:
    /// Maps a block of another process. Throws std::runtime_error if the block cannot be opened or is in another
    /// container.
    explicit Mapped(Handle const& handle)
        : pages_(found(detail::OpenFile(open(handle.path, O_RDWR | O_CLOEXEC),
                                        "scree: memory of another process cannot be opened"),
                       handle),
                 handle.size) {}
    /// Returns the address of the first byte in this process.
    std::byte* data() const { return pages_.data(); }

   private:
    static detail::OpenFile const& found(detail::OpenFile const& file, Handle const& handle) {
      if (file.identity() != handle.identity)
        throw std::runtime_error("scree: memory of another process is in another container");
      return file;
    }
    detail::SharedPages pages_;
  };

#ifdef KOKKOS_ENABLE_CUDA
  template <class Space>
  static constexpr bool serves = on_host<Space> || std::is_same_v<Space, Kokkos::Cuda>;
#else
  template <class Space>
  static constexpr bool serves = on_host<Space>;
#endif
  /// Copies bytes between host memory and the memory of an execution space, in order with the work of the instance.
  template <class Space>
  static void copy([[maybe_unused]] Space const& space, std::byte* to, std::byte const* from, std::size_t bytes) {
    static_assert(serves<Space>, "memory of the host is shared between CPUs, or with NVIDIA GPUs");
    if constexpr (on_host<Space>) {
      std::memcpy(to, from, bytes);
    } else {
#ifdef KOKKOS_ENABLE_CUDA
      detail::check_cuda(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDefault, space.cuda_stream()),
                         "copy through shared memory");
#endif
    }
  }
};

}  // namespace scree

#endif
