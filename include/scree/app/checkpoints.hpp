// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../run/checkpoint_policy.hpp"

namespace scree::app {

/// scree::Checkpoints with its HDF5 code in the library scree::app, so that simulations compile faster.
class Checkpoints : public CheckpointPolicy {
 public:
  /// Throws as CheckpointPolicy does.
  explicit Checkpoints(CheckpointOptions options);
};

}  // namespace scree::app
