// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../run/checkpoint_policy.hpp"
#include "checkpoint.hpp"

namespace scree {

/// Checkpoints in sealed HDF5 files, written whenever CheckpointPolicy requires it:
///
///     Checkpoints checkpoints({.file = "checkpoint.h5", .interval = 600});
///     if (resume) solver.restore(checkpoints.read("checkpoint.h5"));
///     run_with(solver, end, observers, checkpoints);
///     return checkpoints.exit_code();
///
/// A damaged file is rejected with a message.
class Checkpoints : public CheckpointPolicy {
 public:
  /// Throws std::invalid_argument for options that CheckpointPolicy rejects.
  explicit Checkpoints(CheckpointOptions options)
      : CheckpointPolicy(std::move(options), {write_checkpoint, read_checkpoint}) {}
};

}  // namespace scree
