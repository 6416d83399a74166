// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "turning_drum.hpp"

#include <scree/boundaries/conserving.hpp>
#include <scree/solver/wall_loads.hpp>

#include <concepts>
#include <utility>
#include <vector>

// The energy that a turning drum puts into its bed, and its losses. The sums over pairs are written here again, from
// the equations; only the state, the values that walls show and the rate of the stress come from the solver.
namespace scree::test::drum {

/// The stress before the filter.
struct UnfilteredStress : Symmetric3<"unfiltered stress", "Pa"> {};
inline constexpr UnfilteredStress unfiltered_stress{};

struct KeepUnfiltered {
  using reads = Fields<Stress>;
  using writes = Fields<UnfilteredStress>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[unfiltered_stress] = i[fields::stress];
  }
};
struct WatchedFilter {
  int period = 30;
  using history = LinearFilter::history;
  auto passes() const {
    return std::tuple_cat(std::tuple(point_pass<Material>("keep", KeepUnfiltered{})), LinearFilter{}.passes());
  }
};

using Tensor = Mat<3, double>;

/// Energies per m of depth, J/m.
struct Energy {
  double kinetic = 0, potential = 0, elastic = 0;
  double all() const { return kinetic + potential + elastic; }
};

/// Powers, W/m: the input by the walls, and the losses. Positive: taken from the bed.
struct Powers {
  double by_torque = 0;  ///< rate of turning times the moment of the group of the wall
  double by_walls = 0;   ///< sum over the walls of -F . u_w, of the sums here
  double plastic = 0;    ///< stress times plastic strain rate of the return mapping
  double viscous = 0;    ///< artificial viscosity within the material
  double at_walls = 0;   ///< slip: input by the walls that does not reach the bed
  double volume = 0;     ///< volume consistency
  double filter = 0;     ///< filter of the stress
  double of_step = 0;    ///< second order in the step
  double change = 0;     ///< of kinetic, potential and elastic energy

  double dissipated() const { return plastic + viscous + at_walls + volume + filter + of_step; }
  Powers& add(Powers const& o, double weight) {
    by_torque += weight * o.by_torque, by_walls += weight * o.by_walls, plastic += weight * o.plastic;
    viscous += weight * o.viscous, at_walls += weight * o.at_walls, volume += weight * o.volume;
    filter += weight * o.filter, of_step += weight * o.of_step, change += weight * o.change;
    return *this;
  }
};

class Ledger {
 public:
  Ledger(Elastic const& elastic, double viscosity_speed, Groups<2> wall)
      : elastic_(elastic), speed_(viscosity_speed), wall_(std::move(wall)) {}

  template <class S>
  Energy energy_of(S const& solver) const {
    using namespace fields;
    auto const x = solver.material().to_host(position), u = solver.material().to_host(velocity);
    auto const sigma = solver.material().to_host(stress);
    auto const V = solver.material().to_host(volume);
    Energy sum;
    for (std::size_t i = 0; i < x.size(); ++i) {
      double const m = bed_density * V[i];
      sum.kinetic += m / 2 * u[i].squaredNorm();
      sum.potential += m * g * x[i][1];
      sum.elastic += V[i] * stored(unpacked(sigma[i]));
    }
    return sum;
  }

  /// One step of symplectic Euler and its powers.
  template <class S>
  Powers step(S& solver) const {
    using namespace fields;
    using X = Vec<2, double>;
    auto const& bed = solver.material();
    auto const x = bed.to_host(position), u = bed.to_host(velocity);
    auto const sigma_0 = bed.to_host(stress);
    auto const V = bed.to_host(volume);
    auto const y = solver.wall().to_host(position), u_wall = solver.wall().to_host(velocity);
    auto const V_wall = solver.wall().to_host(volume);
    double const before = energy_of(solver).all();
    Powers P;
    P.by_torque = power_of_torque(solver);
    double const dt = solver.step(1);
    P.change = (energy_of(solver).all() - before) / dt;
    bool const filtered = solver.steps() % solver.settings().physics.filter_period() == 0;
    if (filtered) P.filter = filter_loss(solver) / dt;
    auto const sigma = filtered ? bed.to_host(unfiltered_stress) : bed.to_host(stress);
    auto const sigma_rate = bed.to_host(stress_rate);
    auto const a = bed.to_host(acceleration);
    auto const seen = solver.wall().to_host(dummy_velocity);
    auto const sigma_wall = solver.wall().to_host(stress);
    using Walls = std::remove_cvref_t<decltype(solver.settings().physics.walls)>;
    // The part of a wall particle in the velocity gradient, over its volume. Walls of a drum are rough.
    auto const strain_by = [&] {
      if constexpr (std::same_as<Walls, ConservingWalls>)
        return [u_wall, G = solver.wall().to_host(slip_gradient)](std::size_t w, X const& u_i, double kernel,
                                                                  X const& gradient) {
          return Mat<2, double>((u_wall[w] - u_i) * gradient.transpose() + kernel * G[w]);
        };
      else
        return [seen](std::size_t w, X const& u_i, double, X const& gradient) {
          return Mat<2, double>((seen[w] - u_i) * gradient.transpose());
        };
    }();

    double const h = solver.resolution().smoothing_length, rho = bed_density;
    KernelFunction<WendlandC2, 2, double> const W(h);
    double into_bed = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      Mat<2, double> L = Mat<2, double>::Zero(), L_wall = L;
      X viscous = X::Zero(), by_wall = X::Zero();  // N/m
      double const m = rho * V[i];
      auto const Pi = [&](X const& r, X const& slip) {
        return speed_ * h / rho * std::min(0.0, slip.dot(r)) / (r.squaredNorm() + 0.01 * h * h);
      };
      for (std::size_t j = 0; j < x.size(); ++j) {
        X const r = x[i] - x[j];
        if (j == i || r.squaredNorm() >= sq(W.radius())) continue;
        X const gradient = W.slope_over_distance(r.norm()) * r;
        L += V[j] * (u[j] - u[i]) * gradient.transpose();
        viscous += m * rho * V[j] * Pi(r, u[i] - u[j]) * gradient;
      }
      for (std::size_t w = 0; w < y.size(); ++w) {
        X const r = x[i] - y[w];
        if (r.squaredNorm() >= sq(W.radius())) continue;
        X const gradient = W.slope_over_distance(r.norm()) * r;
        X const traction = product(Vec<4, double>(sigma[i] + sigma_wall[w]), gradient);
        X const force = V[i] * V_wall[w] * traction + m * rho * V_wall[w] * Pi(r, u[i] - seen[w]) * gradient;
        L_wall += V_wall[w] * strain_by(w, u[i], W.value(r.norm()), gradient);
        by_wall += force;
        P.by_walls += force.dot(u_wall[w]);
      }
      Tensor const s0 = unpacked(sigma_0[i]), s1 = unpacked(sigma[i]), change = s1 - s0, r = unpacked(sigma_rate[i]);
      Tensor const D = strain_of(L + L_wall), spin = spin_of(L + L_wall);
      Tensor const turned = spin * s0 - s0 * spin, hooke = turned + elastic_stress(D);
      auto const work = [&](Tensor const& part) { return V[i] * s1.cwiseProduct(compliant(part)).sum(); };
      P.plastic += work(s0 + dt * r - s1) / dt;
      P.volume -= work(r - hooke);
      P.viscous -= u[i].dot(viscous);
      into_bed += u[i].dot(by_wall) + V[i] * s1.cwiseProduct(strain_of(L_wall)).sum();
      P.of_step += V[i] / (2 * dt) * change.cwiseProduct(compliant(change)).sum() - work(turned);
      P.of_step -= m * dt * (a[i].squaredNorm() / 2 + g * a[i][1]);
    }
    P.at_walls = P.by_walls - into_bed;
    return P;
  }

  /// Energy that the filter removed in the last step, J/m.
  template <class S>
  double filter_loss(S const& solver) const {
    using namespace fields;
    auto const before = solver.material().to_host(unfiltered_stress), after = solver.material().to_host(stress);
    auto const V = solver.material().to_host(volume);
    double sum = 0;
    for (std::size_t i = 0; i < V.size(); ++i) sum += V[i] * (stored(unpacked(before[i])) - stored(unpacked(after[i])));
    return sum;
  }

  /// Power of the moment of the group about the axis, for the present state.
  template <class S>
  double power_of_torque(S& solver) const {
    return -solver.settings().motion.rate * wall_load(solver, wall_, "drum").moment;
  }

 private:
  /// s:s/(4 G) + p^2/(2 K), J/m^3.
  double stored(Tensor const& sigma) const { return sigma.cwiseProduct(compliant(sigma)).sum() / 2; }
  Tensor compliant(Tensor const& sigma) const {
    return deviator_of(sigma) / (2 * elastic_.shear_modulus()) +
           Tensor::Identity() * (sigma.trace() / (9 * elastic_.bulk_modulus()));
  }
  Tensor elastic_stress(Tensor const& strain) const {
    double const K = elastic_.bulk_modulus(), G = elastic_.shear_modulus();
    return 2 * G * strain + (K - 2 * G / 3) * strain.trace() * Tensor::Identity();
  }
  static Tensor strain_of(Mat<2, double> const& L) { return in_space((L + L.transpose()) / 2); }
  static Tensor spin_of(Mat<2, double> const& L) { return in_space((L - L.transpose()) / 2); }
  static Tensor in_space(Mat<2, double> const& plane) {
    Tensor all = Tensor::Zero();
    all.topLeftCorner<2, 2>() = plane;
    return all;
  }

  Elastic elastic_;
  double speed_;
  Groups<2> wall_;
};

}  // namespace scree::test::drum
