// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/core/types.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace scree::test {

/// The mean of cells of a height `dz`, the first of which begins at 0, between two heights.
template <class Mixture>
Mixture mean_between(std::vector<Mixture> const& cells, double dz, double low, double high) {
  Mixture sum = Mixture::Zero();
  double width = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    double const part = std::min(high, double(c + 1) * dz) - std::max(low, double(c) * dz);
    if (part > 0) sum += part * cells[c], width += part;
  }
  return sum / width;
}

/// N species in a column of height 1 without diffusion, by finite volumes of first order with the flux of Rusanov
/// (1961):
///   dC_k/dt = d/dz (C_k sum_l S_kl C_l)   with z upwards, S_kl = -S_lk, and no flux through both ends.
template <int N>
class SpeciesColumn {
 public:
  using Mixture = Vec<N, double>;
  using Speeds = Mat<N, double>;  ///< S_kl

  /// The start is a function of the height.
  SpeciesColumn(int cells, Speeds const& speeds, std::function<Mixture(double)> const& start)
      : dz_(1.0 / cells), S_(speeds), fastest_(speeds.cwiseAbs().maxCoeff()) {
    for (int c = 0; c < cells; ++c) C_.push_back(start((c + 0.5) * dz_));
  }
  void run(double until) {
    std::vector<Mixture> flux(C_.size() + 1, Mixture::Zero());  // upwards, through the lower face of each cell
    while (time_ < until * (1 - 1e-12)) {
      double const dt = std::min(0.4 * dz_ / fastest_, until - time_);
      for (std::size_t c = 1; c < C_.size(); ++c) flux[c] = through(C_[c - 1], C_[c]);
      for (std::size_t c = 0; c < C_.size(); ++c) C_[c] -= dt / dz_ * (flux[c + 1] - flux[c]);
      time_ += dt;
    }
  }
  /// The mean between two heights.
  Mixture mean(double low, double high) const { return mean_between(C_, dz_, low, high); }

 private:
  Mixture convected(Mixture const& C) const { return -C.cwiseProduct(S_ * C); }
  Mixture through(Mixture const& below, Mixture const& above) const {
    return (convected(below) + convected(above)) / 2 - fastest_ / 2 * (above - below);
  }

  double dz_;
  Speeds S_;
  double fastest_, time_ = 0;
  std::vector<Mixture> C_;
};

/// The steady state of N species in a column of height 1 with given means: D(C) dC_k/ds = C_k sum_l S_kl(C) C_l over
/// the distance s from the top, by Runge-Kutta steps of fourth order.
template <int N>
class SpeciesEquilibrium {
 public:
  using Mixture = Vec<N, double>;

  using Speeds = std::function<Mat<N, double>(Mixture const&)>;

  SpeciesEquilibrium(int steps, Speeds speeds, std::function<double(Mixture const&)> diffusivity, Mixture const& means)
      : ds_(1.0 / steps), S_(std::move(speeds)), D_(std::move(diffusivity)), C_(std::size_t(steps) + 1) {
    C_[0] = means;
    for (int k = 0; k < 500; ++k) {
      integrate();
      Mixture const start = C_[0].cwiseProduct(means.cwiseQuotient(mean(0, 1)));
      C_[0] = start / start.sum();
    }
    integrate();
  }
  /// The mean between two heights that are multiples of a step, by Simpson's rule over pairs of steps.
  Mixture mean(double low, double high) const {
    auto const first = std::lround((1 - high) / ds_), last = std::lround((1 - low) / ds_);
    Mixture sum = Mixture::Zero();
    for (long k = first; k < last; k += 2) sum += C_[k] + 4 * C_[k + 1] + C_[k + 2];
    return sum / (3 * double(last - first));
  }

 private:
  Mixture slope(Mixture const& C) const { return C.cwiseProduct(S_(C) * C) / D_(C); }
  void integrate() {
    for (std::size_t k = 0; k + 1 < C_.size(); ++k) {
      Mixture const a = slope(C_[k]), b = slope(C_[k] + ds_ / 2 * a), c = slope(C_[k] + ds_ / 2 * b),
                    d = slope(C_[k] + ds_ * c);
      C_[k + 1] = C_[k] + ds_ / 6 * (a + 2 * b + 2 * c + d);
    }
  }

  double ds_;
  Speeds S_;
  std::function<double(Mixture const&)> D_;
  std::vector<Mixture> C_;
};

}  // namespace scree::test
