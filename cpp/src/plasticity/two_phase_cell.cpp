// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/plasticity/two_phase_cell.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace samcontact::plasticity {
namespace {

// Vectors of six components have shear components times sqrt 2, so that products are those of
// tensors.
using Vector = Eigen::Matrix<double, 6, 1>;
using Matrix = Eigen::Matrix<double, 6, 6>;
using Jump = Eigen::Matrix<double, 6, 3>;

/// Relative residual at convergence, and limits of the number of steps and of halvings of the
/// interval in which a step ends.
constexpr double residual_tol = 1e-10;
constexpr int max_steps = 40, max_halvings = 12;
/// Ratio of residuals up to which a whole step is accepted.
constexpr double sufficient = 0.8;
/// Least 1 - p in the slope along a step.
constexpr double min_weight = 1e-4;
/// Least hardening in the derivatives, relative to the shear modulus: two perfectly plastic phases
/// have singular derivatives. It changes the steps of the iteration, not its result.
constexpr double min_slope = 1e-3;

Vector to_vector(const Tensor& t) {
  Vector v;
  for (int c = 0; c < 6; ++c) v[c] = c < 3 ? t[c] : std::numbers::sqrt2 * t[c];
  return v;
}

Tensor to_tensor(const Vector& v) {
  Tensor t;
  for (int c = 0; c < 6; ++c) t[c] = c < 3 ? v[c] : v[c] / std::numbers::sqrt2;
  return t;
}

/// bulk on the mean part plus shear on the deviator.
Matrix isotropic(double bulk, double shear) {
  Matrix m = shear * Matrix::Identity();
  m.topLeftCorner<3, 3>().array() += (bulk - shear) / 3;
  return m;
}

/// Strain sym(a n) of a jump a.
Jump jumps(const std::array<double, 3>& n) {
  constexpr double h = 1 / std::numbers::sqrt2;
  Jump b;
  b << n[0], 0, 0, 0, n[1], 0, 0, 0, n[2], 0, h * n[2], h * n[1], h * n[2], 0, h * n[0], h * n[1],
      h * n[0], 0;
  return b;
}

/// Radial return of a phase at a strain, with its derivative.
struct Response {
  Vector stress, plastic = Vector::Zero();
  Matrix tangent;
  double equivalent = 0.0, overshoot = 0.0;

  Response(const Phase& phase, const Vector& strain) {
    const double K = phase.bulk, G = phase.shear;
    const Vector elastic = strain - to_vector(phase.inelastic);
    tangent = isotropic(3 * K, 2 * G);
    stress = tangent * elastic;
    if (phase.hardening == nullptr) return;
    Vector s = stress;
    s.head<3>().array() -= stress.head<3>().mean();
    const double size = s.norm(), q = std::sqrt(1.5) * size;
    const double yield = phase.strength * phase.hardening->yield_stress(phase.equivalent);
    overshoot = std::max(0.0, q / yield - 1.0);
    if (q <= yield) return;
    const double d = equivalent_increment(q / phase.strength, phase.equivalent, G / phase.strength,
                                          *phase.hardening);
    const double slope =
        std::max(phase.strength * phase.hardening->at(phase.equivalent + d).slope, min_slope * G);
    const Vector direction = s / size;
    const double left = 1 - 3 * G * d / q;
    equivalent = d;
    plastic = std::sqrt(1.5) * d * direction;
    stress -= 2 * G * plastic;
    tangent = isotropic(3 * K, 2 * G * left);
    tangent -= 2 * G * (3 * G / (3 * G + slope) - (1 - left)) * direction * direction.transpose();
  }
};

class Laminate {
 public:
  Laminate(const std::array<Phase, 2>& phases, double share, const std::array<double, 3>& normal,
           const std::array<double, 2>& p, const Tensor& kept)
      : phases_(phases),
        share_(share),
        jumps_(jumps(normal)),
        mean_weight_(isotropic(1 - p[0], 1 - p[1])),
        slope_weight_(
            isotropic(1 / std::max(1 - p[0], min_weight), 1 / std::max(1 - p[1], min_weight))),
        strain_weight_(isotropic(3 * phases[0].bulk * p[0], 2 * phases[0].shear * p[1])),
        kept_(to_vector(kept)) {}

  /// Mean strain, then the jump of the displacement gradient across the interface.
  using Unknowns = Eigen::Matrix<double, 9, 1>;

  struct State {
    Response first, second;
    Vector stress;
    Unknowns residual;
  };
  State at(const Unknowns& x) const {
    const Vector strain = x.head<6>(), jump = jumps_ * x.tail<3>();
    State state{Response(phases_[0], strain - share_ * jump),
                Response(phases_[1], strain + (1 - share_) * jump),
                {},
                {}};
    state.stress = (1 - share_) * state.first.stress + share_ * state.second.stress;
    state.residual.head<6>() = mean_weight_ * state.stress + strain_weight_ * strain - kept_;
    state.residual.tail<3>() = jumps_.transpose() * (state.second.stress - state.first.stress);
    return state;
  }
  Unknowns step(const State& state) const {
    const Matrix& a = state.first.tangent;
    const Matrix& b = state.second.tangent;
    const double f = share_;
    Eigen::Matrix<double, 9, 9> slope;
    slope.topLeftCorner<6, 6>() = mean_weight_ * ((1 - f) * a + f * b) + strain_weight_;
    slope.topRightCorner<6, 3>() = f * (1 - f) * mean_weight_ * (b - a) * jumps_;
    slope.bottomLeftCorner<3, 6>() = jumps_.transpose() * (b - a);
    slope.bottomRightCorner<3, 3>() = jumps_.transpose() * ((1 - f) * b + f * a) * jumps_;
    return slope.partialPivLu().solve(state.residual);
  }
  /// Slope of the potential of the residual along a step, which decreases it: the potential is
  /// convex.
  double slope(const State& state, const Unknowns& step) const {
    const double f = share_;
    return step.head<6>().dot(slope_weight_ * state.residual.head<6>()) +
           f * (1 - f) * step.tail<3>().dot(state.residual.tail<3>());
  }
  double scale() const { return std::max(kept_.norm(), smallest); }

 private:
  static constexpr double smallest = 1e-300;
  const std::array<Phase, 2>& phases_;
  double share_;
  Jump jumps_;
  Matrix mean_weight_, slope_weight_, strain_weight_;
  Vector kept_;
};

}  // namespace

TwoPhaseStep two_phase_step(const std::array<Phase, 2>& phases, double share,
                            const std::array<double, 3>& normal, const std::array<double, 2>& p,
                            const Tensor& kept, const Tensor& start) {
  const Laminate laminate(phases, share, normal, p, kept);
  Laminate::Unknowns x = Laminate::Unknowns::Zero();
  x.head<6>() = to_vector(start);
  Laminate::State state = laminate.at(x);
  for (int n = 0; n < max_steps; ++n) {
    const double before = state.residual.norm();
    if (before <= residual_tol * laminate.scale()) break;
    const Laminate::Unknowns step = laminate.step(state);
    state = laminate.at(x - step);
    double part = 1.0;
    if (!(state.residual.norm() < sufficient * before) && laminate.slope(state, step) < 0) {
      // The step passes the minimum of the potential along it.
      double low = 0.0, high = 1.0;
      for (int halvings = 0; halvings < max_halvings; ++halvings) {
        part = 0.5 * (low + high);
        state = laminate.at(x - part * step);
        (laminate.slope(state, step) < 0 ? high : low) = part;
      }
    }
    x -= part * step;
  }
  TwoPhaseStep result;
  result.stress = to_tensor(state.stress);
  result.strain = to_tensor(x.head<6>());
  result.plastic = {to_tensor(state.first.plastic), to_tensor(state.second.plastic)};
  result.equivalent = {state.first.equivalent, state.second.equivalent};
  result.overshoot = std::max(state.first.overshoot, state.second.overshoot);
  return result;
}

}  // namespace samcontact::plasticity
