// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/writes_files.hpp"
#include "output_directory.hpp"
#include "preview.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace scree::app {

namespace detail {
/// Throws CaseError with the message that the material has no particles at this spacing (m).
[[noreturn]] void refuse_empty(double spacing);
}  // namespace detail

/// One run of a case program.
template <class T>
struct Run {
  T options{};
  std::filesystem::path output = {};  ///< the directory of its results
  bool quiet = false;
  bool profile = false;        ///< print the cost of the steps, see print_profile() in profile.hpp
  std::string case_text = {};  ///< the effective case file, for the provenance of other files
  std::shared_ptr<OutputDirectory const> directory = {};  ///< prevents other runs from using `output`
  std::function<void()> meet = {};                        ///< waits for the other ranks of the case, if there are any
  std::shared_ptr<Preview const> preview = {};            ///< set if the run is to show its initial state and stop

  /// Prepares the directory for the results of a solver, see OutputDirectory::begin(), after checking that the solver
  /// can take its next step (Solver::check_start()). Earlier results remain unchanged until all ranks of a case have
  /// reached this point, after they have read the data that they need from these results. Throws what the step would
  /// throw, and CaseError for a case without particles and without inlets. With --preview, writes the page of the
  /// initial state and throws an exception that ends the program.
  template <class S>
  void begin(S& solver) const {
    auto const check = [&] {
      if (solver.particles_at_start() + solver.turnover().added == 0 && solver.entered().empty())
        detail::refuse_empty(solver.settings().spacing);
      solver.check_start();
      if (meet) meet();
    };
    if constexpr (CanBeShown<S>)
      if (preview) preview->show(solver, check);
    check();
    if (directory && writes_files()) directory->begin(case_text);
  }
};

}  // namespace scree::app
