// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/available_memory.hpp"
#include "../../core/compiled.hpp"
#include "bytes_of.hpp"

#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace scree::detail {

SCREE_BODY std::string bytes_of(std::filesystem::path const& file) {
  auto const fail = [&](std::string const& why) {
    throw std::runtime_error(file.string() + ": cannot read it: " + why);
  };
  if (std::filesystem::is_directory(file)) fail("it is a folder");
  errno = 0;
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) fail(errno == 0 ? "unknown reason" : std::generic_category().message(errno));
  auto const size = static_cast<double>(stream.tellg());
  if (!(size >= 0 && size <= available_memory() / 4)) fail("it has " + short_text(size * 1e-9) + " GB");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  stream.seekg(0);
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream) fail("reading stopped before its end");
  return bytes;
}

}  // namespace scree::detail
