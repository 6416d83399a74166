// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/setting.hpp"
#include "triangles.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <stdexcept>

namespace scree {

/// The placement of a mesh, which maps x to rotation (scale x) + translation. Files of CAD programs are often in
/// millimetres: use `{.scale = 1e-3}`.
struct Placement {
  double scale = 1;                                      ///< m per unit of the file, above 0
  Mat<3, double> rotation = Mat<3, double>::Identity();  ///< without reflection
  Vec<3, double> translation = Vec<3, double>::Zero();   ///< m

  /// Throws std::invalid_argument if the scale is not positive, the matrix is not a rotation, or a number is not
  /// finite.
  void check() const {
    check_setting(scale > 0 && std::isfinite(scale), "scale of a mesh", scale, "above 0");
    check_setting(translation.allFinite(), "translation of a mesh", translation.sum(), "finite");
    double const off = (rotation * rotation.transpose() - Mat<3, double>::Identity()).norm();
    check_setting(off < 1e-9 && rotation.determinant() > 0, "rotation of a mesh: R transposed(R) - 1", off,
                  "0, and the determinant of R 1");
  }
};

/// Returns the matrix of a rotation by an angle (rad) about an axis of any length above zero, by the right-hand rule.
/// Throws std::invalid_argument if the axis has no length or is not finite.
inline Mat<3, double> rotation_about(Vec<3, double> const& axis, double angle) {
  check_setting(axis.norm() > 0 && axis.allFinite(), "length of the axis of a rotation", axis.norm(), "above 0");
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// Returns triangles to which a placement was applied. Throws as Placement::check() does.
inline Triangles placed(Triangles triangles, Placement const& placement) {
  placement.check();
  for (auto& x : triangles.vertices)
    x = Vec<3, double>(placement.rotation * Vec<3, double>(placement.scale * x) + placement.translation);
  return triangles;
}

}  // namespace scree
