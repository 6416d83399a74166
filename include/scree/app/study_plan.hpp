// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "value.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace scree::app {

/// The options that a study varies, and their values in each of its members.
struct StudyPlan {
  struct Varied {
    std::string section, name;
    Where where;
    std::vector<Value> values = {};  ///< one for each member

    /// "section.name".
    std::string key() const { return section + "." + name; }
  };
  std::vector<Varied> varied;

  static constexpr std::size_t most = 100'000;  ///< members

  /// The number of cases.
  std::size_t members() const { return varied.empty() ? 0 : varied.front().values.size(); }
  /// The values of a member, as a case file would have them.
  std::vector<Section> sections_of(std::size_t member) const;
};

/// Returns the study that a file (an empty path: none) and texts "section.key=[value, ...]" describe; a text replaces
/// the list of the file. The file is like a case file with a list of values for each option:
///
///     [geometry]
///     rotation_speed = [2, 5, 10]
///     fill_depth = [0.3, 0.42]
///
/// Members are all combinations, of which the last list changes fastest. With `combine = "rows"` in a section [study]
/// member n has the n-th value of each list; "all" is the default. Throws CaseError naming everything that is wrong.
StudyPlan read_study(std::filesystem::path const& file, std::span<std::string const> vary = {});

}  // namespace scree::app
