// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"

#include <cmath>
#include <cstddef>

// The packing around one particle, on the host and on a device. The kernel is Wendland's C2 with h = 1.5 spacings,
// whatever kernel the formulation has.
namespace scree::detail {

/// The packing around one particle of the material.
struct Crowding {
  double density = 0;         ///< sum V W; 1 on a lattice
  double by_number = 0;       ///< sum V W with the volume spacing^dim in place of V
  double walls = 0;           ///< sum V W over walls, relative to the part of 1 that the material leaves empty
  bool judges_walls = false;  ///< whether walls fill all sides without material
  bool faces_walls = false;   ///< whether walls are on the side that the material leaves empty, however sparse they are
  double volume = 1;          ///< V over spacing^dim
  bool is_full = false;       ///< whether particles are on all sides
  double nearest = Kokkos::Experimental::infinity_v<double>;  ///< distance of the nearest neighbour, m
  std::size_t neighbour = 0;

  static constexpr double most_density = 1.6;
  static constexpr double least_of_walls = 0.6;
  /// Whether walls on the empty side of the particle have less than 0.6 of the volume that fills this side.
  SCREE_FN bool faces_too_little() const { return faces_walls && walls < least_of_walls; }
  /// Whether a start is refused because of this particle: its nearest neighbour is less than a tenth of a spacing away,
  /// or its density is above a bound, by default 1.6.
  SCREE_FN bool is_wrong(double spacing, double bound = most_density) const {
    return nearest < 0.1 * spacing || density > bound;
  }
};

/// The arrangement of neighbours around a particle, without regard to their volumes.
class Surroundings {
 public:
  /// Adds a neighbour at the vector (x, y, z) and the distance r, m, with a weight that decreases with the distance.
  SCREE_FN void add(double x, double y, double z, double r, double weight) {
    x_ += weight * x, y_ += weight * y, z_ += weight * z, length_ += weight * r;
    xx_ += x * x, yy_ += y * y, zz_ += z * z, xy_ += x * y, xz_ += x * z, yz_ += y * z;
    count_ += 1;
  }
  /// Adds the neighbours of another object, multiplied by `times`.
  SCREE_FN void add(Surroundings const& others, double times) {
    x_ += times * others.x_, y_ += times * others.y_, z_ += times * others.z_, length_ += times * others.length_;
    xx_ += times * others.xx_, yy_ += times * others.yy_, zz_ += times * others.zz_;
    xy_ += times * others.xy_, xz_ += times * others.xz_, yz_ += times * others.yz_;
    count_ += times * others.count_;
  }
  /// Whether neighbours are on all sides: the weighted mean of their distance vectors is shorter than 0.1 times the
  /// weighted mean of their distances, and along every direction the mean of the squared distances is above half of its
  /// value in a filled support (m). In a row at a surface the first ratio is 0.3 or more, and in the next row it is
  /// below 0.1; in the middle one of three rows with free surfaces, the second ratio is below one half.
  SCREE_FN bool on_all_sides(int dimensions, double support) const {
    if (!(x_ * x_ + y_ * y_ + z_ * z_ < 0.1 * 0.1 * length_ * length_)) return false;
    double const bar = 0.5 * (count_ + 1) * support * support / (dimensions + 2);
    double const a = xx_ - bar, b = yy_ - bar, c = zz_ - bar, minor = a * b - xy_ * xy_;
    if (!(a > 0 && minor > 0)) return false;
    return dimensions == 2 || c * minor + 2 * xy_ * xz_ * yz_ - a * yz_ * yz_ - b * xz_ * xz_ > 0;
  }

  /// Whether the weighted mean of the neighbours is within 48 degrees of the direction opposite to that of others; no
  /// angle in a lattice has this value.
  SCREE_FN bool is_opposite(Surroundings const& others) const {
    double const along = x_ * others.x_ + y_ * others.y_ + z_ * others.z_;
    double const squared = x_ * x_ + y_ * y_ + z_ * z_;
    double const of_others = others.x_ * others.x_ + others.y_ * others.y_ + others.z_ * others.z_;
    return along < 0 && along * along > 0.45 * squared * of_others;
  }

 private:
  double x_ = 0, y_ = 0, z_ = 0, length_ = 0;
  double xx_ = 0, yy_ = 0, zz_ = 0, xy_ = 0, xz_ = 0, yz_ = 0;
  double count_ = 0;
};

/// The kernel of the packing for a spacing (m).
struct PackingKernel {
  int dimensions;
  double h, at_zero, of_spacing;  // m, m^-dim, the contribution of a particle of volume spacing^dim to itself

  PackingKernel(double spacing, int dim) : dimensions(dim), h(1.5 * spacing) {
    constexpr double pi = 3.14159265358979;
    at_zero = dim == 2 ? 7 / (4 * pi * h * h) : 21 / (16 * pi * h * h * h);
    of_spacing = at_zero * std::pow(spacing, dim);
  }
  SCREE_FN double support() const { return 2 * h; }
  /// Whether a squared distance (m^2) is within the support.
  SCREE_FN bool reaches(double squared) const { return squared < 4 * h * h; }
  /// Returns the value at a distance (m) within the support, relative to that at zero.
  SCREE_FN double shape(double r) const {
    double const left = 1 - r / (2 * h);
    return (left * left) * (left * left) * (1 + 2 * r / h);
  }
  /// Returns r^dim.
  SCREE_FN double volume(double r) const { return dimensions == 2 ? r * r : r * r * r; }
};

/// A sum over neighbours that gives the packing around one particle.
class CrowdingSum {
 public:
  /// Starts the sum with the particle itself and its volume (m^dim).
  SCREE_FN CrowdingSum(PackingKernel const& kernel, double volume) : kernel_(kernel) {
    found_.density = volume * kernel.at_zero, found_.by_number = kernel.of_spacing;
    found_.volume = found_.density / kernel.of_spacing;
  }
  /// Adds a neighbour at the vector (x, y, z), m, whose squared distance the kernel reaches.
  SCREE_FN void add(double x, double y, double z, double squared, double volume, bool is_wall, std::size_t number) {
    double const r = Kokkos::sqrt(squared), shape = kernel_.shape(r);
    double const filled = volume * kernel_.at_zero * shape, by_number = kernel_.of_spacing * shape;
    found_.density += filled, found_.by_number += by_number;
    if (is_wall) {
      filled_by_walls_ += filled, numbers_of_walls_ += by_number;
      walls_.add(x, y, z, r, shape);
    } else {
      material_.add(x, y, z, r, shape);
    }
    if (squared < least_) least_ = squared, found_.neighbour = number;
  }
  /// Whether the density is already so high that a start is refused.
  SCREE_FN bool is_too_dense() const { return found_.density > Crowding::most_density; }
  SCREE_FN Crowding result() const {
    Crowding found = found_;
    found.nearest = Kokkos::sqrt(least_);
    Surroundings all = material_;
    all.add(walls_, 1);
    found.is_full = all.on_all_sides(kernel_.dimensions, kernel_.support());
    // Wall particles are weighted so that they fill the space that the material leaves, whatever their spacing is.
    double const left = 1 - (found.by_number - numbers_of_walls_);
    if (!(numbers_of_walls_ > 0 && left > 0.15)) return found;
    found.walls = filled_by_walls_ / left;
    Surroundings filled = material_;
    filled.add(walls_, left / numbers_of_walls_);
    found.judges_walls = filled.on_all_sides(kernel_.dimensions, kernel_.support());
    found.faces_walls = walls_.is_opposite(material_);
    return found;
  }

 private:
  PackingKernel const& kernel_;
  Crowding found_;
  Surroundings material_, walls_;
  double filled_by_walls_ = 0, numbers_of_walls_ = 0, least_ = Kokkos::Experimental::infinity_v<double>;
};

}  // namespace scree::detail
