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

/// The product of such a matrix.
Vector isotropic(double bulk, double shear, const Vector& v) {
  Vector product = shear * v;
  product.head<3>().array() += (bulk - shear) / 3 * (v[0] + v[1] + v[2]);
  return product;
}

/// Strain sym(a n) of a jump a.
Jump jumps(const std::array<double, 3>& n) {
  constexpr double h = 1 / std::numbers::sqrt2;
  Jump b;
  b << n[0], 0, 0, 0, n[1], 0, 0, 0, n[2], 0, h * n[2], h * n[1], h * n[2], 0, h * n[0], h * n[1],
      h * n[0], 0;
  return b;
}

/// Tensors that are isotropic about an axis multiply four parts of a symmetric tensor separately:
/// that along the axis together with the trace across it, the shear along the axis, and the
/// deviator across it.
struct Parts {
  double along, trace;
  Eigen::Vector3d shear;
  Vector rest;

  Parts(const Vector& t, const Eigen::Vector3d& n, const Jump& jumps)
      : Parts(t, n, jumps, jumps.transpose() * t) {}

  Vector sum(const Eigen::Vector3d& n, const Jump& jumps) const {
    return rest + jumps * (2 * shear + along * n) + across(n, jumps) * (0.5 * trace);
  }

 private:
  Parts(const Vector& t, const Eigen::Vector3d& n, const Jump& jumps,
        const Eigen::Vector3d& on_plane)
      : along(on_plane.dot(n)),
        trace(t[0] + t[1] + t[2] - along),
        shear(on_plane - along * n),
        rest(t - jumps * (2 * shear + along * n) - across(n, jumps) * (0.5 * trace)) {}

  static Vector across(const Eigen::Vector3d& n, const Jump& jumps) {
    Vector one = -(jumps * n);
    one.head<3>().array() += 1;
    return one;
  }
};

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
        p_(p),
        normal_(normal[0], normal[1], normal[2]),
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
  /// Unknowns of elastic phases: a single step, in closed form, from any others.
  Unknowns elastic(const Unknowns& start) const {
    const Unknowns residual = elastic_residual(start);
    const double f = share_, both = f * (1 - f), K = phases_[0].bulk, G = phases_[0].shear,
                 dK = phases_[1].bulk - K, dG = phases_[1].shear - G;
    // The jump follows from the strain by the acoustic tensor of moduli with exchanged shares.
    const double k = K + (1 - f) * dK, g = G + (1 - f) * dG;
    const auto jump_of = [&](const Eigen::Vector3d& traction) -> Eigen::Vector3d {
      const double along = traction.dot(normal_);
      return (traction - along * normal_) / g + along / (k + 4 * g / 3) * normal_;
    };
    const double bulk = 3 * (K + f * dK), shear = 2 * (G + f * dG), less = dK - 2 * dG / 3;
    const auto weighted = [&](const Vector& stress) {
      return isotropic(1 - p_[0], 1 - p_[1], stress);
    };
    const Eigen::Vector3d jump = jump_of(residual.tail<3>());
    const Vector known =
        residual.head<6>() - both * weighted(isotropic(3 * dK, 2 * dG, Vector(jumps_ * jump)));
    Parts parts(known, normal_, jumps_);
    const double q = 1 - p_[1], own = 2 * G * p_[1];
    parts.rest /= q * shear + own;
    parts.shear /= q * (shear - 2 * both * dG * dG / g) + own;
    // Column of the matrix of the other two parts, for a strain along the normal and a trace
    // across it.
    const auto column = [&](double along, double trace) -> Eigen::Vector2d {
      const double sum = along + trace,
                   opened = -both * (2 * dG * along + less * sum) / (k + 4 * g / 3);
      const double lame = (bulk - shear) / 3;
      const double s = shear * along + lame * sum + (2 * dG + less) * opened,
                   t = shear * trace + 2 * lame * sum + 2 * less * opened;
      const double mean = ((p_[1] - p_[0]) * (s + t) + (3 * K * p_[0] - own) * sum) / 3;
      return {q * s + own * along + mean, q * t + own * trace + 2 * mean};
    };
    const Eigen::Vector2d a = column(1, 0), b = column(0, 1);
    const double determinant = a[0] * b[1] - a[1] * b[0], along = parts.along;
    parts.along = (along * b[1] - parts.trace * b[0]) / determinant;
    parts.trace = (parts.trace * a[0] - along * a[1]) / determinant;
    const Vector strain = parts.sum(normal_, jumps_);
    Unknowns step;
    step.head<6>() = strain;
    step.tail<3>() = jump - jump_of(jumps_.transpose() * isotropic(3 * dK, 2 * dG, strain));
    return start - step;
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
  /// Residual of elastic phases.
  Unknowns elastic_residual(const Unknowns& x) const {
    const Vector strain = x.head<6>(), jump = jumps_ * x.tail<3>();
    const auto stress = [&](const Phase& phase, const Vector& own) {
      return isotropic(3 * phase.bulk, 2 * phase.shear, own - to_vector(phase.inelastic));
    };
    const Vector first = stress(phases_[0], strain - share_ * jump),
                 second = stress(phases_[1], strain + (1 - share_) * jump);
    Unknowns residual;
    residual.head<6>() =
        isotropic(1 - p_[0], 1 - p_[1], (1 - share_) * first + share_ * second) +
        isotropic(3 * phases_[0].bulk * p_[0], 2 * phases_[0].shear * p_[1], strain) - kept_;
    residual.tail<3>() = jumps_.transpose() * (second - first);
    return residual;
  }

  const std::array<Phase, 2>& phases_;
  double share_;
  std::array<double, 2> p_;
  Eigen::Vector3d normal_;
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
  // Most cells are elastic; the others begin with the strain of the estimate.
  const Laminate::Unknowns elastic = laminate.elastic(x);
  Laminate::State state = laminate.at(elastic);
  if (state.first.equivalent == 0 && state.second.equivalent == 0) {
    x = elastic;
  } else {
    state = laminate.at(x);
  }
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
