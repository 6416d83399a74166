// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/checkpoints.hpp>

#include <scree/io/checkpoint.hpp>

namespace scree::app {

Checkpoints::Checkpoints(CheckpointOptions options)
    : CheckpointPolicy(std::move(options), {write_checkpoint, read_checkpoint}) {}

}  // namespace scree::app
