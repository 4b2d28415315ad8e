// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/gap_descent.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"

namespace samcontact::contact {
namespace {

/// Share of the elastic curvature below which the whole curvature counts as not positive. The
/// elastic curvature alone is an upper bound where the attraction falls, so that its step decreases
/// the energy. With a larger share, soft directions near an instability converge slowly.
constexpr double least_curvature = 0.02;
/// Change of a gap in one step, in ranges of the attraction, up to which the slope of the
/// attraction is of use.
constexpr double ranges_per_step = 3.0;
/// Share of the displacement under its residual by which a cell opens.
constexpr double opening = 0.5;

}  // namespace

GapDescent::GapDescent(const AdhesiveSurface& surface, const ContactLaw& law,
                       const Field& initial_gap)
    : surface_(surface), law_(law), gap_(surface, initial_gap) {
  for (Field* field : {&p_, &residual_, &before_, &z_, &t_, &q_, &scratch_}) field->assign(gap_.size(), 0.0);
}

void GapDescent::start_from(const Field& pressure) {
  gap_.start_from(pressure, law_, work_);
  applications_ += pressure.empty() ? 0 : 1;
}

void GapDescent::press() {
  gap_.displacement(z_);
  surface_.press(z_, p_, work_);
  ++applications_;
  exact_ = true;
}

void GapDescent::remove_mean(Field& field) const {
  if (!surface_.has_free_mean()) return;
  const std::size_t n = field.size();
  const double open = ordered_sum(n, [&](std::size_t i) { return gap_.is_open(i) ? 1.0 : 0.0; });
  if (open == 0) return;
  const double mean =
      ordered_sum(n, [&](std::size_t i) { return gap_.is_open(i) ? field[i] : 0.0; }) / open;
  for_each_cell(std::ssize(field), [&](std::ptrdiff_t i) {
    if (gap_.is_open(i)) field[i] -= mean;
  });
}

void GapDescent::find_residual() {
  const Field& x = gap_.values();
  const std::ptrdiff_t n = std::ssize(p_);
  for_each_cell(n, [&](std::ptrdiff_t i) {
    const double pull = gap_.is_body(i) ? law_.attraction(x[i]) : 0.0;
    residual_[i] = gap_.is_frozen(i) ? 0.0 : p_[i] + pull;
  });
  multiplier_ = 0.0;
  if (surface_.has_free_mean()) {
    const double open = ordered_sum(n, [&](std::size_t i) { return gap_.is_open(i) ? 1.0 : 0.0; });
    const double sum =
        ordered_sum(n, [&](std::size_t i) { return gap_.is_open(i) ? residual_[i] : 0.0; });
    multiplier_ = open > 0 ? sum / open : 0.0;
    for_each_cell(n, [&](std::ptrdiff_t i) {
      if (!gap_.is_frozen(i)) residual_[i] -= multiplier_;
    });
  }
  const double scale =
      std::max(law_.largest_attraction(), largest_of(n, [&](std::size_t i) {
                 return gap_.is_body(i) ? std::fabs(p_[i] - multiplier_) : 0.0;
               }));
  error_ = largest_of(n, [&](std::size_t i) {
             return gap_.is_open(i) ? std::fabs(residual_[i]) : -residual_[i];
           }) /
           scale;
}

double GapDescent::energy() {
  const Field& x = gap_.values();
  gap_.displacement(scratch_);
  return ordered_sum(p_.size(), [&](std::size_t i) {
    return 0.5 * scratch_[i] * p_[i] + (gap_.is_body(i) ? law_.energy(x[i]) : 0.0);
  });
}

void GapDescent::find_direction(bool restart) {
  const std::ptrdiff_t n = std::ssize(p_);
  for_each_cell(n, [&](std::ptrdiff_t i) { q_[i] = gap_.is_open(i) ? residual_[i] : 0.0; });
  surface_.precondition(q_, z_, work_);
  ++applications_;
  for_each_cell(n, [&](std::ptrdiff_t i) {
    if (!gap_.is_open(i)) z_[i] = 0.0;
  });
  remove_mean(z_);
  const double rz = ordered_dot(q_.data(), z_.data(), n);
  const double change =
      ordered_sum(n, [&](std::size_t i) { return z_[i] * (q_[i] - before_[i]); });
  const double beta = restart || rz_ <= 0 ? 0.0 : std::max(0.0, change / rz_);
  for_each_cell(n,
                [&](std::ptrdiff_t i) { t_[i] = gap_.is_open(i) ? z_[i] + beta * t_[i] : 0.0; });
  // A set that has changed leaves the earlier direction with a mean, with which the approach would
  // drift.
  remove_mean(t_);
  if (ordered_dot(q_.data(), t_.data(), n) <= 0) t_ = z_;
  std::swap(before_, q_);
  rz_ = rz;
}

double GapDescent::step_length(bool is_first) {
  const Field& x = gap_.values();
  const std::ptrdiff_t n = std::ssize(p_);
  surface_.press(t_, q_, work_);
  ++applications_;
  const double along = ordered_dot(before_.data(), t_.data(), n);
  const double elastic = ordered_dot(t_.data(), q_.data(), n);
  const double fall = ordered_sum(n, [&](std::size_t i) {
    return gap_.is_body(i) && t_[i] != 0 ? law_.fall(x[i]) * t_[i] * t_[i] : 0.0;
  });
  const double curvature = elastic - fall;
  const double bounded = along / elastic;
  if (curvature <= least_curvature * elastic) return bounded;
  const double step = along / curvature;
  if (is_first) return step;
  const double limit = ranges_per_step * law_.largest_attraction() / law_.steepest_fall();
  const double farthest =
      largest_of(n, [&](std::size_t i) { return gap_.is_body(i) ? std::fabs(t_[i]) : 0.0; });
  return step * farthest > limit ? std::min(step, bounded) : step;
}

bool GapDescent::move(bool is_first) {
  Field& x = gap_.values();
  const std::ptrdiff_t n = std::ssize(p_);
  const double step = step_length(is_first);
  bool closed = false, opened = false;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    if (gap_.is_open(i)) {
      x[i] -= step * t_[i];
      if (gap_.is_body(i) && x[i] <= 0) {
        closed = closed || x[i] < 0;
        x[i] = 0.0;
      }
    } else if (gap_.is_body(i) && residual_[i] < 0) {
      x[i] = -opening * residual_[i] * surface_.self_influence();
      opened = true;
    }
  }
  if (closed || opened) {
    gap_.keep_mean();
    press();
  } else {
    for_each_cell(n, [&](std::ptrdiff_t i) { p_[i] -= step * q_[i]; });
    exact_ = false;
  }
  return opened;
}

bool GapDescent::descend(double approach, double tol, int max_iterations) {
  gap_.approach_to(approach);
  press();
  const double work = law_.energy(law_.reach()) * static_cast<double>(p_.size());
  double before = energy();
  bool restart = true;
  for (int n = 0;; ++n, ++iterations_) {
    check_interrupt();
    find_residual();
    if (error_ <= tol && !exact_) {
      press();
      find_residual();
    }
    if (error_ <= tol) return true;
    if (n >= max_iterations || !std::isfinite(error_)) return false;
    find_direction(restart);
    restart = move(n == 0);
    const double now = energy();
    energy_rise_ = std::max(energy_rise_, (now - before) / work);
    before = now;
  }
}

Field GapDescent::pressure() const {
  Field found = surface_.over_grid(p_);
  for (double& p : found) p -= multiplier_;
  return found;
}

double GapDescent::load() const {
  const Field p = pressure();
  return surface_.grid().cell_area() * ordered_sum(p.size(), [&](std::size_t i) { return p[i]; });
}

}  // namespace samcontact::contact
