// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace shear_box::reference {

struct TimeStepping {
  double euler_limit;  // longest forward Euler step that keeps C in [0, 1]
  double longest;      // longest step that resolves changes in time

  double step(int stages) const { return std::min(longest, (stages - 1) * euler_limit); }
};

/// Optimal strong-stability-preserving Runge-Kutta method of second order with s stages (Gottlieb, Ketcheson & Shu
/// 2009): s forward Euler steps of dt/(s - 1), then the average of the start (weight 1/s) and their result. A convex
/// combination of Euler steps keeps C in [0, 1] whenever those do: s - 1 Euler limits in time at the cost of s stages.
///
/// Op: void op.euler(double const* C, double* result, double t, double dt)   result = C + dt dC/dt(C, t)
template <class Op>
class SspRungeKutta {
 public:
  SspRungeKutta(Op& op, TimeStepping stepping, std::size_t cells)
      : op_(op), stages_(2), step_(stepping.step(2)), stage_(cells), next_(cells) {
    for (int stages = 3; stages <= 10; ++stages)  // the fewest stages per unit of time
      if (stages * step_ < stages_ * stepping.step(stages)) {
        stages_ = stages;
        step_ = stepping.step(stages);
      }
  }

  void advance(std::vector<double>& C, double from, double to) {
    auto const steps = static_cast<long>(std::ceil((to - from) / step_ - 1e-9));
    for (long n = 0; n < steps; ++n)
      step(C, from + (to - from) * static_cast<double>(n) / static_cast<double>(steps),
           (to - from) / static_cast<double>(steps));
  }

 private:
  void step(std::vector<double>& C, double t, double dt) {
    double const stage_dt = dt / (stages_ - 1);
    op_.euler(C.data(), stage_.data(), t, stage_dt);
    for (int s = 1; s < stages_; ++s) {
      op_.euler(stage_.data(), next_.data(), t + s * stage_dt, stage_dt);
      std::swap(stage_, next_);
    }
    double const old_weight = 1.0 / stages_;
    for (std::size_t i = 0; i < C.size(); ++i) C[i] = stage_[i] + old_weight * (C[i] - stage_[i]);
  }

  Op& op_;
  int stages_;
  double step_;
  std::vector<double> stage_, next_;
};

}  // namespace shear_box::reference
