// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "memory.hpp"

#include <cstdlib>
#include <new>

#ifdef __GLIBC__
#include <malloc.h>
#endif

// Counts what containers of the host allocate, which is not what Kokkos allocates, where the C library tells sizes.
namespace scree::bench {

Peak containers;

}  // namespace scree::bench

// nvcc takes these operators for functions of the device, too.
#if defined(__GLIBC__) && !defined(__CUDA_ARCH__)
void* operator new(std::size_t bytes) {
  void* const memory = std::malloc(bytes);
  if (memory == nullptr) throw std::bad_alloc();
  scree::bench::containers.add(static_cast<std::int64_t>(malloc_usable_size(memory)));
  return memory;
}
void operator delete(void* memory) noexcept {
  if (memory != nullptr) scree::bench::containers.add(-static_cast<std::int64_t>(malloc_usable_size(memory)));
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }
#endif
