// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/run/checkpoint_policy.ipp>
#include <scree/run/component.ipp>
#include <scree/run/snapshot_notes.ipp>
#include <scree/snapshots/snapshot.ipp>
#include <scree/snapshots/snapshot_columns.ipp>
#include <scree/snapshots/snapshot_of.ipp>
