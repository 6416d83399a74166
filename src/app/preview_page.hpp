// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/snapshots/snapshot.hpp>

#include <string>
#include <utility>
#include <vector>

namespace scree::app {

/// The particles of a snapshot as the page of src/app/page draws them.
class StartParticles {
 public:
  /// One number for each particle of all bodies, one behind the other.
  struct Row {
    std::string name, unit = {};
    std::vector<double> values = {};
    double low = 0, high = 0;          ///< of the material, finite values alone
    double all_low = 0, all_high = 0;  ///< of all bodies
  };
  struct Body {
    std::string name;
    std::size_t count = 0;
  };

  explicit StartParticles(Snapshot const& snapshot);

  int dimension = 2;
  double time = 0;              ///< s
  std::vector<Body> bodies;     ///< that have particles, the material first
  std::vector<Row> axes;        ///< x and z, or x, y and z
  std::vector<Row> scalars;     ///< at most `most_scalars`: magnitudes of vectors, pressures, numbers
  std::vector<double> body_of;  ///< the place of the body of each particle in `bodies`

  static constexpr std::size_t most_scalars = 8;
};

/// Rows of a name and a text.
using ReportOfStart = std::vector<std::pair<std::string, std::string>>;

struct AboutPage {
  std::string title;
  double spacing = 0;  ///< m
};

/// The page as one text. Of more than 300 000 particles it has one in so many.
std::string page_of_start(AboutPage const& about, StartParticles const& particles, ReportOfStart const& report);

}  // namespace scree::app
