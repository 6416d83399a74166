// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

/// An empty directory for one test, removed with its contents at the end.
struct Folder {
  std::filesystem::path path;

  Folder() {
    static int number = 0;
    path = std::filesystem::temp_directory_path() / fmt::format("scree-test-{}-{}", ::getpid(), number++);
    std::filesystem::create_directories(path);
  }
  Folder(Folder const&) = delete;
  Folder& operator=(Folder const&) = delete;
  ~Folder() { std::filesystem::remove_all(path); }

  std::filesystem::path operator/(std::filesystem::path const& name) const { return path / name; }
  std::filesystem::path write(char const* name, std::string const& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
    return path / name;
  }
};

inline std::string content_of(std::filesystem::path const& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}
