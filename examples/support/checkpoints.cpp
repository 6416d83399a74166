// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "checkpoints.hpp"

#include "say.hpp"

#include <scree/io/checkpoint.hpp>

namespace support {

void write_checkpoint(std::filesystem::path const& file, scree::Snapshot const& snapshot) {
  scree::write_checkpoint(file, snapshot);
}

scree::Snapshot read_checkpoint(std::filesystem::path const& file) { return scree::read_checkpoint(file); }

void print_note(std::string const& note) { say(stderr, "note: {}\n", printable(note)); }

}  // namespace support
