// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

/// The text that `use(stream)` writes to a stream.
template <class Use>
std::string printed(Use use) {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* const stream = ::open_memstream(&text, &size);
  use(stream);
  std::fclose(stream);
  std::string const result(text, size);
  std::free(text);
  return result;
}
