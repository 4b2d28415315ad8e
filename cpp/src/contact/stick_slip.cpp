// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/stick_slip.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/projected_gradient.hpp"

namespace samcontact::contact {
namespace {

/// A shear of this share of its bound is on it.
constexpr double on_circle = 1 - 1e-9;
/// More slipping cells turning back than this share are a reversal: all cells stick first, since
/// partial releases from a contact that slips everywhere do not settle.
constexpr double reversal_share = 0.05;
/// What the inner iteration is asked to gain at least and at most.
constexpr double least_gain = 0.1, most_gain = 1e-3;
constexpr int most_inner_steps = 14;
/// Inner steps end when sticking cells exceed their bound by this many times the residual.
constexpr double patience = 3.0;
/// Outer steps that do not take this share off the error, before projected gradients help.
constexpr double progress = 0.7;
constexpr int steps_in_vain = 7, fallback_steps = 60;
/// Forces missed by more than this share of the bound are left to the linear solve.
constexpr double largest_correction = 0.2;
/// Directions in which the cells that are free make up this share of a motion decide it.
constexpr double decisive = 1e-10;

class StickSlip {
 public:
  StickSlip(const ShearProblem& problem, ShearApplier& operators, ShearStart start)
      : problem_(problem),
        operators_(operators),
        m_(problem.size()),
        modes_(static_cast<int>(problem.modes.size())),
        u_(2 * m_),
        normal_(2 * m_, 0.0),
        lambda_(m_, 0.0),
        share_(m_, 1.0),
        bound_scale_(*std::max_element(problem.bound.begin(), problem.bound.end())),
        self_influence_(problem.operators->displacement.self_influence()) {
    r_.shear = std::move(start.shear);
    r_.shear.resize(2 * m_, 0.0);
    r_.slip.assign(2 * m_, 0.0);
    r_.motion = std::move(start.motion);
    r_.motion.resize(modes_, 0.0);
    cut_to_bound(problem.bound, r_.shear);
    begin(std::move(start.slipping));
  }

  ShearResult run(double tol, int most_steps) {
    double best = INFINITY;
    for (int in_vain = 0;; ++r_.steps) {
      check_interrupt();
      evaluate();
      r_.converged = r_.error <= tol;
      if (r_.converged || r_.steps >= most_steps) break;
      in_vain = r_.error < progress * best ? 0 : in_vain + 1;
      best = in_vain == 0 ? r_.error : best;
      if (in_vain > steps_in_vain) {
        fall_back(tol);
        in_vain = 0;
        best = INFINITY;
        continue;
      }
      choose_sets();
      step(tol);
    }
    finish();
    return std::move(r_);
  }

 private:
  double length(std::size_t i) const { return std::hypot(r_.shear[i], r_.shear[m_ + i]); }
  const Field& direction(int k) const { return problem_.modes[k].direction; }
  double missing(int k) const { return problem_.modes[k].target - dot(direction(k), r_.shear); }
  bool is_slipping(std::size_t i) const { return r_.slipping[i] != 0; }

  /// Slipping cells, and forces, of the start.
  void begin(std::vector<unsigned char> slipping) {
    const bool told = !slipping.empty();
    r_.slipping = std::move(slipping);
    r_.slipping.resize(m_, 0);
    for (std::size_t i = 0; i < m_; ++i) {
      if (!told) r_.slipping[i] = length(i) >= problem_.bound[i] * on_circle;
      if (told && is_slipping(i)) put_on_circle(i);
    }
    if (!told) watch_reversal();
    meet_forces();
  }

  void put_on_circle(std::size_t i) {
    const double size = length(i);
    if (size <= 0 || std::isinf(problem_.bound[i])) {
      r_.slipping[i] = 0;
      return;
    }
    r_.shear[i] *= problem_.bound[i] / size;
    r_.shear[m_ + i] *= problem_.bound[i] / size;
  }

  void watch_reversal() {
    const auto slipping = std::count(r_.slipping.begin(), r_.slipping.end(), 1);
    if (slipping == 0) return;
    operators_.displacement(r_.shear, u_);
    u_is_known_ = true;
    Field w = problem_.free_slip;
    add_scaled(-1.0, u_, w);
    for (int k = 0; k < modes_; ++k) {
      const double motion = missing(k) / dot(direction(k), direction(k)) / problem_.stiffness;
      add_motion(problem_, k, motion, w);
    }
    std::ptrdiff_t back = 0;
    for (std::size_t i = 0; i < m_; ++i) {
      back += is_slipping(i) && r_.shear[i] * w[i] + r_.shear[m_ + i] * w[m_ + i] < 0;
    }
    if (back > reversal_share * slipping) std::fill(r_.slipping.begin(), r_.slipping.end(), 0);
  }

  /// Of directions on the cells that are free, and their products.
  struct Projected {
    std::vector<Field> directions;
    Eigen::MatrixXd products;
  };
  template <class Keep>
  Projected projected(const Keep& keep) const {
    Projected set;
    set.products.resize(modes_, modes_);
    for (int k = 0; k < modes_; ++k) {
      set.directions.push_back(direction(k));
      keep(set.directions.back());
      for (int l = 0; l <= k; ++l) {
        set.products(k, l) = set.products(l, k) = dot(set.directions[k], set.directions[l]);
      }
    }
    return set;
  }
  bool decides(const Projected& set, double share) const {
    for (int k = 0; k < modes_; ++k) {
      if (!(set.products(k, k) > share * dot(direction(k), direction(k)))) return false;
    }
    return true;
  }

  /// Brings the forces to their values with a rigid change of the shear on sticking cells, which
  /// slip where it takes them beyond their bound.
  void meet_forces() {
    for (int n = 0; n < 4 && modes_ > 0; ++n) {
      Eigen::VectorXd miss(modes_);
      for (int k = 0; k < modes_; ++k) miss[k] = missing(k);
      if (miss.isZero(0.0)) return;
      const Projected set = projected([&](Field& v) {
        for (std::size_t i = 0; i < m_; ++i) {
          if (is_slipping(i)) v[i] = v[m_ + i] = 0.0;
        }
      });
      if (!decides(set, 1e-6)) return;
      const Eigen::VectorXd change = set.products.ldlt().solve(miss);
      Field add(2 * m_, 0.0);
      for (int k = 0; k < modes_; ++k) add_scaled(change[k], set.directions[k], add);
      if (longest(add) > largest_correction * bound_scale_) return;
      add_scaled(1.0, add, r_.shear);
      u_is_known_ = false;
      slip_beyond_bound();
    }
  }

  void slip_beyond_bound() {
    for (std::size_t i = 0; i < m_; ++i) {
      if (!is_slipping(i) && !(length(i) > problem_.bound[i])) continue;
      r_.slipping[i] = 1;
      put_on_circle(i);
    }
  }

  /// Leaves slipping cells their tangent.
  void project_free(Field& v) const {
    for (std::size_t i = 0; i < m_; ++i) {
      if (!is_slipping(i)) continue;
      const double along = normal_[i] * v[m_ + i] - normal_[m_ + i] * v[i];
      v[i] = -along * normal_[m_ + i];
      v[m_ + i] = along * normal_[i];
    }
  }

  void take_normals() {
    for (std::size_t i = 0; i < m_; ++i) {
      const double over = length(i) > 0 ? 1 / length(i) : 0.0;
      normal_[i] = r_.shear[i] * over;
      normal_[m_ + i] = r_.shear[m_ + i] * over;
    }
  }

  /// Displacement, motions, slip and error of the present shear.
  void evaluate() {
    if (!u_is_known_) operators_.displacement(r_.shear, u_);
    u_is_known_ = false;
    r_.slip = problem_.free_slip;
    add_scaled(-1.0, u_, r_.slip);
    take_normals();
    if (modes_ > 0) {
      const Projected set = projected([&](Field& v) {
        keep_in_touch(problem_, v);
        project_free(v);
      });
      if (decides(set, decisive)) {
        Eigen::VectorXd residual(modes_);
        for (int k = 0; k < modes_; ++k) residual[k] = -dot(set.directions[k], r_.slip);
        const Eigen::VectorXd motion = set.products.ldlt().solve(residual);
        for (int k = 0; k < modes_; ++k) r_.motion[k] = motion[k];
      }
      for (int k = 0; k < modes_; ++k) add_motion(problem_, k, r_.motion[k], r_.slip);
    }
    r_.error = natural_residual(problem_, r_.shear, r_.slip);
  }

  double outward(std::size_t i) const {
    return normal_[i] * r_.slip[i] + normal_[m_ + i] * r_.slip[m_ + i];
  }

  /// Slipping cells stick where they would slip against their shear, sticking cells on their bound
  /// slip where they would leave it.
  void choose_sets() {
    for (std::size_t i = 0; i < m_; ++i) {
      const double bound = problem_.bound[i];
      if (is_slipping(i)) {
        r_.slipping[i] = outward(i) >= 0;
      } else if (length(i) >= bound * on_circle) {
        const double x = r_.shear[i] + r_.slip[i] / self_influence_,
                     y = r_.shear[m_ + i] + r_.slip[m_ + i] / self_influence_;
        r_.slipping[i] = std::hypot(x, y) > bound * (1 + 1e-12);
      }
      // The turn of the direction costs stiffness: the second derivative along the circle.
      lambda_[i] = is_slipping(i) ? std::max(outward(i), 0.0) / bound : 0.0;
      share_[i] = 1 / std::sqrt(1 + lambda_[i] / self_influence_);
    }
  }

  /// P (C + lambda) v, nearly: a step gains no more than the cheap operator is good for.
  void apply(const Field& v, Field& out) {
    operators_.near(v, out);
    for (std::size_t i = 0; i < m_; ++i) {
      out[i] += lambda_[i] * v[i];
      out[m_ + i] += lambda_[i] * v[m_ + i];
    }
    project_free(out);
  }

  void precondition(const Field& r, Field& z) {
    z = r;
    scale(z);
    operators_.precondition(z, z);
    scale(z);
    project_free(z);
  }
  void scale(Field& v) const {
    for (std::size_t i = 0; i < m_; ++i) {
      v[i] *= share_[i];
      v[m_ + i] *= share_[i];
    }
  }

  /// One linear solve, and the shear that it leads to.
  void step(double tol);
  bool is_enough(const Field& residual, const Field& change, double first, double gain, double tol,
                 int inner) const;
  void fall_back(double tol);
  void finish();

  const ShearProblem& problem_;
  ShearApplier& operators_;
  const std::size_t m_;
  const int modes_;
  ShearResult r_;
  Field u_, normal_;
  bool u_is_known_ = false;  // that of the present shear
  Field lambda_, share_;     // of each cell
  double bound_scale_, self_influence_;
};

void StickSlip::step(double tol) {
  const Projected set = projected([&](Field& v) { project_free(v); });
  Eigen::MatrixXd products = set.products;
  for (int k = 0; k < modes_; ++k) {
    products(k, k) += 1e-14 * dot(direction(k), direction(k));
  }
  const auto solver = products.ldlt();
  const auto without_forces = [&](Field& v) {
    if (modes_ == 0) return;
    Eigen::VectorXd along(modes_);
    for (int k = 0; k < modes_; ++k) along[k] = dot(set.directions[k], v);
    const Eigen::VectorXd share = solver.solve(along);
    for (int k = 0; k < modes_; ++k) add_scaled(-share[k], set.directions[k], v);
  };

  Field change(2 * m_, 0.0), residual = r_.slip, z(2 * m_), q(2 * m_), v(2 * m_, 0.0), old(2 * m_);
  project_free(residual);
  Eigen::VectorXd miss(modes_);
  bool missed = false;
  for (int k = 0; k < modes_; ++k) {
    miss[k] = missing(k);
    const double little = 1e-2 * std::min(r_.error, 1.0) * std::fabs(problem_.modes[k].target);
    missed = missed || std::fabs(miss[k]) > little;
  }
  if (missed) {
    const Eigen::VectorXd share = solver.solve(miss);
    for (int k = 0; k < modes_; ++k) add_scaled(share[k], set.directions[k], change);
    apply(change, q);
    add_scaled(-1.0, q, residual);
  }
  without_forces(residual);
  const double first = longest(residual),
               gain =
                   r_.steps > 0 ? std::min(least_gain, std::max(r_.error, most_gain)) : least_gain;
  double zr_old = 0.0;
  for (int inner = 0; inner < most_inner_steps; ++inner) {
    check_interrupt();
    precondition(residual, z);
    without_forces(z);
    const double zr = dot(residual, z);
    if (!(zr > 0)) break;
    const double beta = inner > 0 ? std::max(0.0, (zr - dot(z, old)) / zr_old) : 0.0;
    for (std::size_t i = 0; i < 2 * m_; ++i) v[i] = z[i] + beta * v[i];
    apply(v, q);
    const double curvature = dot(v, q);
    if (!(curvature > 0)) break;
    zr_old = zr;
    old = residual;
    add_scaled(zr / curvature, v, change);
    add_scaled(-zr / curvature, q, residual);
    without_forces(residual);
    ++r_.iterations;
    if (is_enough(residual, change, first, gain, tol, inner)) break;
  }
  add_scaled(1.0, change, r_.shear);
  slip_beyond_bound();
  meet_forces();
}

bool StickSlip::is_enough(const Field& residual, const Field& change, double first, double gain,
                          double tol, int inner) const {
  const double left = longest(residual);
  const double scale = shear_scale(problem_, r_.shear, r_.slip);
  const double relative = left * problem_.stiffness / scale;
  const double beyond = largest_of(m_, [&](std::size_t i) {
    if (is_slipping(i)) return 0.0;
    const double x = r_.shear[i] + change[i], y = r_.shear[m_ + i] + change[m_ + i];
    return std::hypot(x, y) - problem_.bound[i];
  });
  return relative < 0.3 * tol || (left < gain * first && beyond <= 0) ||
         (beyond / scale > patience * relative && inner >= 2);
}

void StickSlip::fall_back(double tol) {
  ++r_.fallbacks;
  projected_gradient(problem_, operators_, tol, fallback_steps, r_);
  for (std::size_t i = 0; i < m_; ++i) {
    const double x = r_.shear[i] + r_.slip[i] / self_influence_,
                 y = r_.shear[m_ + i] + r_.slip[m_ + i] / self_influence_;
    r_.slipping[i] = std::hypot(x, y) > problem_.bound[i];
    if (is_slipping(i)) put_on_circle(i);
  }
  meet_forces();
}

/// Which cells slip is judged by the slip: one on its bound may be a rounding inside, and none
/// slips against its shear.
void StickSlip::finish() {
  const double inside = 1 - std::max(1e-6, 10 * r_.error), rho = problem_.stiffness;
  for (std::size_t i = 0; i < m_; ++i) {
    const double bound = problem_.bound[i];
    r_.slipping[i] = std::hypot(r_.shear[i] + rho * r_.slip[i],
                                r_.shear[m_ + i] + rho * r_.slip[m_ + i]) > bound * on_circle &&
                     length(i) > bound * inside && outward(i) >= 0;
  }
  r_.energy_gap = energy_gap(problem_, r_.shear, r_.slip);
}

}  // namespace

ShearResult solve_stick_slip(const ShearProblem& problem, ShearApplier& operators, ShearStart start,
                             double tol, int most_steps) {
  return StickSlip(problem, operators, std::move(start)).run(tol, most_steps);
}

}  // namespace samcontact::contact
