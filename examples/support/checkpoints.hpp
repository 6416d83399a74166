// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/run/checkpoint_policy.hpp>

// scree::Checkpoints with its HDF5 code compiled apart, in checkpoints.cpp, because a compiler for devices does not get
// through it.
namespace support {

void write_checkpoint(std::filesystem::path const& file, scree::Snapshot const& snapshot);
scree::Snapshot read_checkpoint(std::filesystem::path const& file);

class Checkpoints : public scree::CheckpointPolicy {
 public:
  explicit Checkpoints(scree::CheckpointOptions options)
      : CheckpointPolicy(std::move(options), {write_checkpoint, read_checkpoint}) {}
};

/// "note: ..." on the standard error stream.
void print_note(std::string const& note);

}  // namespace support
