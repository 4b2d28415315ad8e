// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/tangential/partial_slip.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"
#include "samcontact/contact/tangential/projected_gradient.hpp"
#include "samcontact/contact/tangential/slip_iteration.hpp"

namespace samcontact::contact {
namespace {

/// If a larger fraction of slipping cells reverses, all cells stick first: partial releases from
/// full sliding do not settle.
constexpr double reversal_fraction = 0.05;
/// Minimum and maximum error reduction of the inner iteration.
constexpr double min_gain = 0.1, max_gain = 1e-3;
constexpr int max_inner_steps = 14;
/// Inner steps end when sticking cells exceed their bound by this multiple of the residual, except
/// in outer steps that gain little: a few cells that change sides would delay all others.
constexpr double stick_excess_limit = 3.0;
/// Steps of the first fallback; each further one has twice as many, so that the method finally
/// converges by the fallback alone.
constexpr int fallback_steps = 60, max_doublings = 5;
/// If forces are missed by a larger fraction of the bound, the correction is left to the linear
/// solve.
constexpr double largest_correction = 0.2;
/// Slipping cells resist motions that deviate from the normal of their shear by more than this.
constexpr double direction_tol = 1e-8;

class PartialSlipIteration : public SlipIteration {
 public:
  PartialSlipIteration(const ShearProblem& problem, ShearApplier& operators, ShearStart start)
      : SlipIteration(problem, operators, std::move(start),
                      problem.operators->displacement.self_influence()),
        modes_(static_cast<int>(problem.modes.size())),
        u_(2 * m_),
        share_(m_, 1.0),
        bound_scale_(*std::max_element(problem.bound.begin(), problem.bound.end())) {
    begin();
  }

 private:
  const Field& direction(int k) const { return problem_.modes[k].direction; }
  double missing(int k) const { return problem_.modes[k].missing(r_.shear); }
  /// Slipping cells and forces of the start.
  void begin() {
    const bool has_start = !r_.slipping.empty();
    if (!has_start) take_slipping();
    for (std::size_t i = 0; i < m_ && has_start; ++i) {
      if (is_slipping(i)) put_on_circle(i);
    }
    if (!has_start) watch_reversal();
    meet_forces();
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
    if (back > reversal_fraction * slipping) std::fill(r_.slipping.begin(), r_.slipping.end(), 0);
  }

  /// Directions restricted to the free cells, and their products.
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

  /// Corrects the forces by a uniform or rotational change of the shear on sticking cells, which
  /// slip if it takes them beyond their bound.
  void meet_forces() {
    for (int n = 0; n < 4 && modes_ > 0; ++n) {
      Eigen::VectorXd miss(modes_);
      for (int k = 0; k < modes_; ++k) miss[k] = missing(k);
      if (miss.isZero(0.0)) return;
      const Projected set = projected([&](Field& v) {
        for_each_cell(m_, [&](std::size_t i) {
          if (is_slipping(i)) v[i] = v[m_ + i] = 0.0;
        });
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

  /// Displacement, motions, slip and error of the present shear.
  void evaluate() override {
    if (!u_is_known_) operators_.displacement(r_.shear, u_);
    u_is_known_ = false;
    r_.slip = problem_.free_slip;
    add_scaled(-1.0, u_, r_.slip);
    take_normals();
    if (modes_ > 0) {
      const Projected set = projected([&](Field& v) {
        apply_slip_part(problem_, v);
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

  void choose_sets() override { change_sides(1 / self_influence_); }

  void precondition(const Field& r, Field& z) {
    z = r;
    scale(z);
    operators_.precondition(z, z);
    scale(z);
    project_free(z);
  }
  void scale(Field& v) const {
    for_each_cell(m_, [&](std::size_t i) {
      v[i] *= share_[i];
      v[m_ + i] *= share_[i];
    });
  }

  void step(double tol) override;
  bool slide_uniformly(double tol);
  bool is_enough(const Field& residual, const Field& change, double first, double gain, double tol,
                 int inner) const;
  void fall_back(double tol) override;

  const int modes_;
  Field u_;
  bool u_is_known_ = false;  // whether u_ belongs to the present shear
  Field share_;              // of each cell
  double bound_scale_;
};

/// If no cell resists a uniform shear, that of sticking cells would grow without bound: all cells
/// slip instead, in the direction of their mean slip and of the forces. False if some cell resists.
bool PartialSlipIteration::slide_uniformly(double tol) {
  const double total_bound = ordered_sum(m_, [&](std::size_t i) { return problem_.bound[i]; });
  if (!problem_.floats || !std::isfinite(total_bound)) return false;
  const auto mean = [&](std::size_t k) {
    return ordered_sum(m_, [&](std::size_t i) { return r_.slip[k * m_ + i]; }) /
           static_cast<double>(m_);
  };
  std::array<double, 2> slide_direction{mean(0), mean(1)}, force{};
  int pulled = 0;
  for (const ShearProblem::Mode& mode : problem_.modes) {
    if (mode.axis == 2) continue;
    ++pulled;
    const double x = mode.direction[0], y = mode.direction[m_], size = length_of(x, y);
    const double along = (slide_direction[0] * x + slide_direction[1] * y) / size;
    slide_direction[0] -= along * x / size;
    slide_direction[1] -= along * y / size;
    force[0] = mode.target / total_bound * x / (size * size);
    force[1] = mode.target / total_bound * y / (size * size);
  }
  if (pulled > 1) return false;  // both directions of the shear are given
  const double length = std::hypot(slide_direction[0], slide_direction[1]);
  if (!(length * problem_.stiffness > tol * shear_scale(problem_, r_.shear, r_.slip))) return false;
  for (double& w : slide_direction) w /= length;
  for (std::size_t i = 0; i < m_; ++i) {
    const double along = slide_direction[0] * normal_[i] + slide_direction[1] * normal_[m_ + i];
    if (is_slipping(i) &&
        (std::fabs(along) > direction_tol || lambda_[i] > direction_tol * self_influence_)) {
      return false;
    }
  }
  const double rest = std::sqrt(std::max(0.0, 1 - force[0] * force[0] - force[1] * force[1]));
  for (std::size_t i = 0; i < 2 * m_; ++i) {
    const std::size_t k = i / m_;
    r_.shear[i] = problem_.bound[i % m_] * (force[k] + rest * slide_direction[k]);
  }
  std::fill(r_.slipping.begin(), r_.slipping.end(), 1);
  return true;
}

void PartialSlipIteration::step(double tol) {
  if (slide_uniformly(tol)) return;
  for_each_cell(
      m_, [&](std::size_t i) { share_[i] = 1 / std::sqrt(1 + lambda_[i] / self_influence_); });
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
               gain = r_.steps > 0 ? std::min(min_gain, std::max(r_.error, max_gain)) : min_gain;
  double zr_old = 0.0;
  for (int inner = 0; inner < max_inner_steps; ++inner) {
    check_interrupt();
    precondition(residual, z);
    without_forces(z);
    const double zr = dot(residual, z);
    if (!(zr > 0)) break;
    const double beta = inner > 0 ? std::max(0.0, (zr - dot(z, old)) / zr_old) : 0.0;
    for_each_cell(2 * m_, [&](std::size_t i) { v[i] = z[i] + beta * v[i]; });
    apply(v, q);
    const double curvature = dot(v, q);
    if (!(curvature > 0)) break;
    zr_old = zr;
    for_each_cell(2 * m_, [&](std::size_t i) { old[i] = residual[i]; });
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

bool PartialSlipIteration::is_enough(const Field& residual, const Field& change, double first,
                                     double gain, double tol, int inner) const {
  const double left = longest(residual);
  const double scale = shear_scale(problem_, r_.shear, r_.slip);
  const double relative = left * problem_.stiffness / scale;
  const double beyond = largest_of(m_, [&](std::size_t i) {
    if (is_slipping(i)) return 0.0;
    const double x = r_.shear[i] + change[i], y = r_.shear[m_ + i] + change[m_ + i];
    return length_of(x, y) - problem_.bound[i];
  });
  return relative < 0.3 * tol || (left < gain * first && beyond <= 0) ||
         (!gains_little_ && beyond / scale > stick_excess_limit * relative && inner >= 2);
}

void PartialSlipIteration::fall_back(double tol) {
  projected_gradient(problem_, operators_, tol,
                     fallback_steps << std::min(r_.fallbacks - 1, max_doublings), r_);
  for (std::size_t i = 0; i < m_; ++i) {
    r_.slipping[i] = pull(i, 1 / self_influence_) > problem_.bound[i];
    if (is_slipping(i)) put_on_circle(i);
  }
  meet_forces();
}

}  // namespace

ShearResult solve_partial_slip(const ShearProblem& problem, ShearApplier& operators,
                               ShearStart start, double tol, int max_steps) {
  ShearResult result =
      PartialSlipIteration(problem, operators, std::move(start)).run(tol, max_steps);
  result.energy_gap = energy_gap(problem, result.shear, result.slip);
  return result;
}

}  // namespace samcontact::contact
