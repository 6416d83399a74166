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

/// The options that a study varies, and their values in each member.
struct StudyPlan {
  struct Varied {
    std::string section, name;
    Where where;
    std::vector<Value> values = {};  ///< one for each member

    /// Returns the key of the option, "section.name".
    std::string key() const { return section + "." + name; }
  };
  std::vector<Varied> varied;

  static constexpr std::size_t most = 100'000;  ///< the largest number of members

  /// Returns the number of members.
  std::size_t members() const { return varied.empty() ? 0 : varied.front().values.size(); }
  /// Returns the values of a member as the sections of a case file.
  std::vector<Section> sections_of(std::size_t member) const;
};

/// Returns the study that a file (an empty path: none) and texts "section.key=[value, ...]" describe. A text replaces
/// the list in the file. The file is like a case file, but with a list of values for each option:
///
///     [geometry]
///     rotation_speed = [2, 5, 10]
///     fill_depth = [0.3, 0.42]
///
/// The members are all combinations; the value from the last list changes fastest. With `combine = "rows"` in a section
/// [study], member n has the n-th value of each list; the default is "all". Throws CaseError with all problems.
StudyPlan read_study(std::filesystem::path const& file, std::span<std::string const> vary = {});

}  // namespace scree::app
