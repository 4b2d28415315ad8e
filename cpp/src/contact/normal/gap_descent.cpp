// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/gap_descent.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
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
constexpr double opening = 1.0;
/// Reduction of a step that increases the energy, and the number of reductions.
constexpr double shorter = 0.25;
constexpr int most_shorter = 12;
/// Rounding error of a gap, relative to the heights of the undeformed surfaces.
constexpr double gap_rounding = 32 * std::numeric_limits<double>::epsilon();
/// Rounding error of the energy, relative to the energy or to the work of adhesion of the grid.
constexpr double rounding = 1e-13;

}  // namespace

GapDescent::GapDescent(const AdhesiveSurface& surface, const ContactLaw& law,
                       const Field& initial_gap)
    : surface_(surface),
      law_(law),
      gap_(surface, initial_gap),
      work_of_grid_(law.energy(law.reach()) * static_cast<double>(surface.size())) {
  const double highest = largest_of(
      gap_.size(), [&](std::size_t i) { return gap_.is_body(i) ? gap_.undeformed(i) : 0.0; });
  rounding_of_pressure_ = gap_rounding * highest / surface.self_influence();
  for (Field* field : {&p_, &residual_, &before_, &z_, &t_, &q_, &scratch_})
    field->assign(gap_.size(), 0.0);
}

void GapDescent::start_from(const Field& pressure) {
  is_cold_ = pressure.empty();
  gap_.start_from(pressure, law_, work_);
  applications_ += pressure.empty() ? 0 : 1;
}

void GapDescent::press() {
  gap_.displacement(z_);
  surface_.press(z_, p_, work_);
  if (mean_pressure_ != 0) {
    for_each_cell(std::ssize(p_), [&](std::ptrdiff_t i) { p_[i] += mean_pressure_; });
  }
  ++applications_;
  exact_ = true;
}

double GapDescent::mean_of_open(const Field& field) const {
  const std::size_t n = field.size();
  const double open = ordered_sum(n, [&](std::size_t i) { return gap_.is_open(i) ? 1.0 : 0.0; });
  if (open == 0) return 0.0;
  return ordered_sum(n, [&](std::size_t i) { return gap_.is_open(i) ? field[i] : 0.0; }) / open;
}

void GapDescent::remove_mean(Field& field) const {
  if (!surface_.has_free_mean()) return;
  const double mean = mean_of_open(field);
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
    multiplier_ = mean_of_open(residual_);
    for_each_cell(n, [&](std::ptrdiff_t i) {
      if (!gap_.is_frozen(i)) residual_[i] -= multiplier_;
    });
  }
  const double scale = std::max(law_.largest_attraction(), largest_of(n, [&](std::size_t i) {
                                  return gap_.is_body(i) ? std::fabs(p_[i] - multiplier_) : 0.0;
                                }));
  const double largest = largest_of(
      n, [&](std::size_t i) { return gap_.is_open(i) ? std::fabs(residual_[i]) : -residual_[i]; });
  error_ = largest > rounding_of_pressure_ ? largest / scale : 0.0;
}

double GapDescent::energy() {
  const Field& x = gap_.values();
  gap_.displacement(scratch_);
  return ordered_sum(p_.size(), [&](std::size_t i) {
    return 0.5 * scratch_[i] * (p_[i] + mean_pressure_) +
           (gap_.is_body(i) ? law_.energy(x[i]) : 0.0);
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
  if (uniform_softness_ > 0) {
    const double force = ordered_sum(n, [&](std::size_t i) { return q_[i]; });
    for_each_cell(n, [&](std::ptrdiff_t i) {
      if (gap_.is_open(i)) z_[i] += uniform_softness_ * force;
    });
  }
  remove_mean(z_);
  const double rz = ordered_dot(q_.data(), z_.data(), n);
  const double change = ordered_sum(n, [&](std::size_t i) { return z_[i] * (q_[i] - before_[i]); });
  const double beta = restart || rz_ <= 0 ? 0.0 : std::max(0.0, change / rz_);
  for_each_cell(n, [&](std::ptrdiff_t i) { t_[i] = gap_.is_open(i) ? z_[i] + beta * t_[i] : 0.0; });
  // If cells have opened or closed, the earlier direction has a mean, which would shift the
  // approach.
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

bool GapDescent::move(double step, double share) {
  Field& x = gap_.values();
  const std::ptrdiff_t n = std::ssize(p_);
  bool closed = false, opened = false;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    if (gap_.is_open(i)) {
      x[i] -= step * t_[i];
      if (gap_.is_body(i) && x[i] <= 0) {
        closed = closed || x[i] < 0;
        x[i] = 0.0;
      }
    } else if (gap_.is_body(i) && residual_[i] < 0) {
      x[i] = -share * residual_[i] * surface_.self_influence();
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

bool GapDescent::descend_once(bool is_first, double& energy_before) {
  const double full = step_length(is_first);
  const Field x = gap_.values(), p = p_;
  const bool exact = exact_;
  double share = 1.0;
  for (int n = 0;; ++n, share *= shorter) {
    const bool opened = move(share * full, share * opening);
    const double now = energy();
    const double scale = std::max({work_of_grid_, std::fabs(now), std::fabs(energy_before)});
    const double rise = (now - energy_before) / scale;
    if (rise <= rounding || n == most_shorter) {
      energy_rise_ = std::max(energy_rise_, rise);
      energy_before = now;
      return opened || n > 0;
    }
    // Cells that close or open may increase the energy: a shorter step decreases it.
    gap_.values() = x;
    p_ = p;
    exact_ = exact;
  }
}

bool GapDescent::descend(double given, double tol, int max_iterations) {
  if (surface_.has_free_approach()) {
    mean_pressure_ = given / (surface_.grid().cell_area() * static_cast<double>(gap_.size()));
    gap_.approach_to(gap_.touching());
    if (!gap_.touches()) return false;
    // The contact changes little during a descent: the stiffness of its start suffices.
    const std::ptrdiff_t n = std::ssize(p_);
    for_each_cell(n, [&](std::ptrdiff_t i) { z_[i] = gap_.is_open(i) ? 1.0 : 0.0; });
    surface_.press(z_, q_, work_);
    ++applications_;
    const double stiffness = ordered_dot(z_.data(), q_.data(), n);
    uniform_softness_ = stiffness > 0 ? 1.0 / stiffness : 0.0;
  } else {
    gap_.approach_to(given);
  }
  const bool is_cold = std::exchange(is_cold_, false);
  press();
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
    if (surface_.has_free_approach() && !gap_.touches()) return false;
    find_direction(restart);
    restart = descend_once(n == 0 && is_cold, before);
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

double GapDescent::approach() const {
  if (!surface_.has_free_approach()) return gap_.approach();
  Field displacement(gap_.size());
  gap_.displacement(displacement);
  const std::size_t n = displacement.size();
  const double mean =
      ordered_sum(n, [&](std::size_t i) { return displacement[i]; }) / static_cast<double>(n);
  return gap_.approach() + surface_.uniform_compliance() * mean_pressure_ - mean;
}

}  // namespace samcontact::contact
