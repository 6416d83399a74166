// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../snapshots/snapshot.hpp"

#include <functional>
#include <string>
#include <vector>

namespace scree {

/// The particles that have passed an inlet or a drain.
struct Passed {
  std::string name;
  long particles = 0;
  double volume = 0;  ///< m^dim
};

namespace detail {

/// The inlets and drains of a solver of class `S` as it sees them while it runs. A program without them compiles
/// nothing of them.
template <class S>
class AnyOpenings {
 public:
  AnyOpenings() = default;
  AnyOpenings(AnyOpenings const&) = delete;
  AnyOpenings& operator=(AnyOpenings const&) = delete;
  virtual ~AnyOpenings() = default;
  /// Whether there is something to do after a step that ended at this time (s). `builds` counts the builds of neighbour
  /// lists.
  virtual bool due(double time, long builds) const = 0;
  virtual void serve(S& solver, double time, long builds) = 0;
  /// Gives particles beyond open ends their values, at the end of each step.
  virtual void keep(S& solver) = 0;
  /// Lines for the signature of snapshots.
  virtual std::string signature() const = 0;
  virtual void add_to(Snapshot& snapshot) const = 0;
  /// Returns what sets this to the state of a snapshot, which has the same signature. Throws std::runtime_error if a
  /// value is out of range.
  virtual std::function<void()> read(Snapshot const& snapshot) = 0;
  virtual std::vector<Passed> entered() const = 0;
  virtual std::vector<Passed> left() const = 0;
};

}  // namespace detail
}  // namespace scree
