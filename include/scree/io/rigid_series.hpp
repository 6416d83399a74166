// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/groups.hpp"
#include "../rigid/state.hpp"
#include "csv_series.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace scree {

/// The states of rigid bodies over time, in one table per body: time, position, velocity, attitude (an angle or a
/// quaternion), angular velocity, and the forces and moments of grains, contacts and springs.
///
///     RigidSeries states("stones", groups);   // stones/NAME.csv for each group
///     ... states.append(solver);              // in an observer
///
/// Throws as CsvSeries does.
template <int Dim>
class RigidSeries {
 public:
  /// Creates the tables. `bodies` are the groups from which the particles of the rigid bodies are made. After a
  /// restart, `goes_on_from` is the time (s) of the restart; earlier rows are kept.
  RigidSeries(std::filesystem::path const& folder, Groups<Dim> const& bodies, std::optional<double> goes_on_from = {}) {
    std::filesystem::create_directories(folder);
    for (std::string const& name : bodies.names()) {
      auto const file = folder / (name + ".csv");
      if (goes_on_from)
        tables_.push_back(CsvSeries::continued(file, *goes_on_from, file, columns()));
      else
        tables_.emplace_back(file, columns());
    }
  }

  /// Appends the current states. The forces belong to the last evaluation of the rates.
  template <class S>
  void append(S const& solver) {
    auto const& states = solver.template body<RigidStates>();
    std::vector<std::vector<double>> rows(tables_.size(), {solver.time()});
    for_each_field([&](auto field, char const*, auto const&) {
      auto const values = states.to_host(field);
      for (std::size_t k = 0; k < rows.size(); ++k)
        rows[k].insert(rows[k].end(), values[k].data(), values[k].data() + values[k].size());
    });
    for (std::size_t k = 0; k < rows.size(); ++k) tables_[k].row(rows[k]);
  }

  /// Returns the columns of the table of one body: time and the components of each field of its state.
  static std::vector<CsvColumn> columns() {
    std::vector<CsvColumn> all = {{"time", "s"}};
    for_each_field([&](auto field, char const* name, std::vector<std::string> const& parts) {
      std::string const unit(field.unit);
      for (auto const& part : parts) {
        std::string const between = part.empty() ? "" : " ";
        all.emplace_back(name + between + part, unit == "1" && Dim == 2 ? "rad" : unit == "1" ? "" : unit);
      }
    });
    return all;
  }

 private:
  template <class Visit>
  static void for_each_field(Visit const& visit) {
    using namespace fields;
    using Names = std::vector<std::string>;
    Names const axes = Dim == 2 ? Names{"x", "z"} : Names{"x", "y", "z"}, turns = Dim == 2 ? Names{""} : axes;
    visit(rigid_centre, "position", axes);
    visit(rigid_velocity, "velocity", axes);
    visit(rigid_attitude, "attitude", Dim == 2 ? turns : Names{"0", "1", "2", "3"});
    visit(angular_velocity, "angular velocity", turns);
    visit(rigid_force, "force of grains", axes);
    visit(rigid_moment, "moment of grains", turns);
    visit(rigid_contact_force, "force of contacts", axes);
    visit(rigid_contact_moment, "moment of contacts", turns);
    visit(rigid_spring_force, "force of springs", axes);
    visit(rigid_spring_moment, "moment of springs", turns);
  }

  std::vector<CsvSeries> tables_;
};

}  // namespace scree
