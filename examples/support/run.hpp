// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace support {

class OutputDirectory;

/// What main() needs to begin.
template <class T>
struct Run {
  T options{};
  std::filesystem::path output = {};
  bool quiet = false;
  std::string case_text = {};  ///< the effective case file, for the provenance of other files
  std::shared_ptr<OutputDirectory const> directory = {};  ///< keeps other runs out of `output`
};

}  // namespace support
