// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "types.hpp"

namespace scree::detail {

/// Returns a value that consists of whole, aligned words of 16 or 8 bytes. With CUDA, each word is read with one
/// instruction. A GPU thread reads 16 bytes as fast as 4; otherwise, compilers would read only the numbers that are
/// used, with more instructions. A loop must not write a value that it reads with this function.
template <class T>
SCREE_LOOP_FN T read_words(T const* from) {
#ifdef __CUDA_ARCH__
  using Word = std::conditional_t<sizeof(T) % 16 == 0, float4, float2>;
  static_assert(sizeof(T) % sizeof(Word) == 0 && alignof(T) >= sizeof(Word));
  struct Words {
    Word all[sizeof(T) / sizeof(Word)];
  } words;
  for (std::size_t k = 0; k < sizeof(T) / sizeof(Word); ++k)
    words.all[k] = __ldg(reinterpret_cast<Word const*>(from) + k);
  return __builtin_bit_cast(T, words);
#else
  return *from;
#endif
}

}  // namespace scree::detail
