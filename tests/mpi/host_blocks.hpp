// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <fcntl.h>

#include <cstddef>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace scree::test {

/// Memory of a host that other processes can map, so that PeerMemory is tested without a GPU.
struct HostBlocks {
  struct Handle {
    char path[64];
    std::size_t size;
  };
  class Block {
   public:
    explicit Block(std::size_t size) : size_(size), file_(memfd_create("scree", 0)) {
      if (file_ < 0 || ftruncate(file_, off_t(size)) != 0) throw std::runtime_error("no shared memory");
      bytes_ = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file_, 0);
      if (bytes_ == MAP_FAILED) throw std::runtime_error("no shared memory");
    }
    Block(Block const&) = delete;
    Block& operator=(Block const&) = delete;
    ~Block() {
      munmap(bytes_, size_);
      close(file_);
    }
    std::byte* data() const { return static_cast<std::byte*>(bytes_); }
    Handle handle() const {
      Handle handle{{}, size_};
      std::snprintf(handle.path, sizeof handle.path, "/proc/%d/fd/%d", int(getpid()), file_);
      return handle;
    }

   private:
    std::size_t size_;
    int file_;
    void* bytes_ = nullptr;
  };
  class Mapped {
   public:
    explicit Mapped(Handle const& handle) : size_(handle.size) {
      int const file = open(handle.path, O_RDWR);
      if (file < 0) throw std::runtime_error("cannot open memory of another process");
      bytes_ = mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
      close(file);
      if (bytes_ == MAP_FAILED) throw std::runtime_error("cannot map memory of another process");
    }
    Mapped(Mapped const&) = delete;
    Mapped& operator=(Mapped const&) = delete;
    ~Mapped() { munmap(bytes_, size_); }
    std::byte* data() const { return static_cast<std::byte*>(bytes_); }

   private:
    std::size_t size_;
    void* bytes_ = nullptr;
  };
  template <class Space>
  static void copy(Space const&, std::byte* to, std::byte const* from, std::size_t bytes) {
    std::memcpy(to, from, bytes);
  }
};

}  // namespace scree::test
