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
    : surface_(surface), law_(law), undeformed_(surface.padded(initial_gap)) {
  const std::size_t n = surface.size();
  const Field inside = surface.padded(Field(initial_gap.size(), 1.0));
  cells_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool is_body = inside[i] == 1.0 && std::isfinite(undeformed_[i]);
    cells_[i] = is_body                    ? Cell::body
                : surface.has_free_mean() && inside[i] != 1.0 ? Cell::frozen
                                                                : Cell::free;
    if (!is_body) undeformed_[i] = 0.0;
  }
  height_ = undeformed_;
  for (Field* field : {&x_, &p_, &attraction_, &residual_, &before_, &z_, &t_, &q_}) {
    field->assign(n, 0.0);
  }
}

void GapDescent::start_from(const Field& pressure) {
  has_approach_ = false;
  if (pressure.empty()) return std::fill(x_.begin(), x_.end(), 0.0);
  p_ = surface_.padded(pressure);
  surface_.displace(p_, x_, work_);
  ++applications_;
  // Surfaces in contact keep their gap at another approach, and the cells in contact remain closed.
  double lowest = INFINITY;
  Field gap = x_;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    if (is_body(i)) lowest = std::min(lowest, undeformed_[i] + x_[i]);
  }
  for (std::size_t i = 0; i < gap.size(); ++i) {
    if (is_body(i)) gap[i] = undeformed_[i] + x_[i] - lowest;
  }
  const Field pushed = repulsion(law_, pressure, surface_.over_grid(gap));
  const Field closed = surface_.padded(pushed);
  for (std::size_t i = 0; i < gap.size(); ++i) {
    if (!in_contact(closed[i])) continue;
    gap[i] = 0.0;
    has_approach_ = true;
  }
  if (!has_approach_) return;
  x_ = std::move(gap);
  approach_ = lowest;
}

double GapDescent::largest_approach() const {
  if (!surface_.has_free_mean()) return INFINITY;
  const std::size_t n = x_.size();
  return ordered_sum(n, [&](std::size_t i) { return undeformed_[i]; }) /
         ordered_sum(n, [&](std::size_t i) { return is_body(i) ? 1.0 : 0.0; });
}

double GapDescent::touching() const {
  if (has_approach_) return approach_;
  double lowest = INFINITY;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    if (is_body(i)) lowest = std::min(lowest, undeformed_[i] + x_[i]);
  }
  return lowest;
}

void GapDescent::return_to(const Place& place) {
  x_ = place.x;
  approach_ = place.approach;
  has_approach_ = true;
}

void GapDescent::approach_to(double approach) {
  const std::ptrdiff_t n = std::ssize(x_);
  const bool touches = has_approach_ && largest_of(n, [&](std::size_t i) {
                         return is_body(i) && x_[i] <= 0 ? 1.0 : 0.0;
                       }) > 0;
  // The gap of a contact is kept; separated surfaces, and a start, keep their displacement.
  const double lowering = has_approach_ ? approach - approach_ : 0.0;
  for_each_cell(n, [&](std::ptrdiff_t i) {
    if (!is_body(i)) return;
    height_[i] = undeformed_[i] - approach;
    if (!has_approach_) {
      x_[i] = std::max(x_[i] + height_[i], 0.0);
    } else if (!touches) {
      x_[i] = std::max(x_[i] - lowering, 0.0);
    }
  });
  approach_ = approach;
  has_approach_ = true;
  keep_mean();
  press();
}

void GapDescent::keep_mean() {
  if (!surface_.has_free_mean()) return;
  const std::size_t n = x_.size();
  const double now = ordered_sum(n, [&](std::size_t i) { return x_[i]; });
  const double given = ordered_sum(n, [&](std::size_t i) { return height_[i]; });
  if (now > 0) {
    for_each_cell(std::ssize(x_), [&](std::ptrdiff_t i) { x_[i] *= given / now; });
  } else {
    for_each_cell(std::ssize(x_), [&](std::ptrdiff_t i) { x_[i] = std::max(height_[i], 0.0); });
  }
}

void GapDescent::press() {
  for_each_cell(std::ssize(x_), [&](std::ptrdiff_t i) { z_[i] = x_[i] - height_[i]; });
  surface_.press(z_, p_, work_);
  ++applications_;
  exact_ = true;
}

void GapDescent::remove_mean(Field& field) const {
  if (!surface_.has_free_mean()) return;
  const std::size_t n = field.size();
  const double open = ordered_sum(n, [&](std::size_t i) { return is_open(i) ? 1.0 : 0.0; });
  if (open == 0) return;
  const double mean =
      ordered_sum(n, [&](std::size_t i) { return is_open(i) ? field[i] : 0.0; }) / open;
  for_each_cell(std::ssize(field), [&](std::ptrdiff_t i) {
    if (is_open(i)) field[i] -= mean;
  });
}

void GapDescent::find_residual() {
  const std::ptrdiff_t n = std::ssize(x_);
  for_each_cell(n, [&](std::ptrdiff_t i) {
    attraction_[i] = is_body(i) ? law_.attraction(x_[i]) : 0.0;
    residual_[i] = cells_[i] == Cell::frozen ? 0.0 : p_[i] + attraction_[i];
  });
  multiplier_ = 0.0;
  if (surface_.has_free_mean()) {
    const double open = ordered_sum(n, [&](std::size_t i) { return is_open(i) ? 1.0 : 0.0; });
    const double sum =
        ordered_sum(n, [&](std::size_t i) { return is_open(i) ? residual_[i] : 0.0; });
    multiplier_ = open > 0 ? sum / open : 0.0;
    for_each_cell(n, [&](std::ptrdiff_t i) {
      if (cells_[i] != Cell::frozen) residual_[i] -= multiplier_;
    });
  }
  const double scale =
      std::max(law_.largest_attraction(), largest_of(n, [&](std::size_t i) {
                 return is_body(i) ? std::fabs(p_[i] - multiplier_) : 0.0;
               }));
  error_ = largest_of(n, [&](std::size_t i) {
             return is_open(i) ? std::fabs(residual_[i]) : -residual_[i];
           }) /
           scale;
}

double GapDescent::energy() const {
  return ordered_sum(x_.size(), [&](std::size_t i) {
    return 0.5 * (x_[i] - height_[i]) * p_[i] + (is_body(i) ? law_.energy(x_[i]) : 0.0);
  });
}

void GapDescent::find_direction(bool restart) {
  const std::ptrdiff_t n = std::ssize(x_);
  for_each_cell(n, [&](std::ptrdiff_t i) { q_[i] = is_open(i) ? residual_[i] : 0.0; });
  surface_.precondition(q_, z_, work_);
  ++applications_;
  for_each_cell(n, [&](std::ptrdiff_t i) {
    if (!is_open(i)) z_[i] = 0.0;
  });
  remove_mean(z_);
  const double rz = ordered_dot(q_.data(), z_.data(), n);
  const double change =
      ordered_sum(n, [&](std::size_t i) { return z_[i] * (q_[i] - before_[i]); });
  const double beta = restart || rz_ <= 0 ? 0.0 : std::max(0.0, change / rz_);
  for_each_cell(n,
                [&](std::ptrdiff_t i) { t_[i] = is_open(i) ? z_[i] + beta * t_[i] : 0.0; });
  // A set that has changed leaves the earlier direction with a mean, with which the approach would
  // drift.
  remove_mean(t_);
  if (ordered_dot(q_.data(), t_.data(), n) <= 0) t_ = z_;
  std::swap(before_, q_);
  rz_ = rz;
}

double GapDescent::step_length(bool is_first) {
  const std::ptrdiff_t n = std::ssize(x_);
  surface_.press(t_, q_, work_);
  ++applications_;
  const double along = ordered_dot(before_.data(), t_.data(), n);
  const double elastic = ordered_dot(t_.data(), q_.data(), n);
  const double fall = ordered_sum(n, [&](std::size_t i) {
    return is_body(i) && t_[i] != 0 ? law_.fall(x_[i]) * t_[i] * t_[i] : 0.0;
  });
  const double curvature = elastic - fall;
  const double bounded = along / elastic;
  if (curvature <= least_curvature * elastic) return bounded;
  const double step = along / curvature;
  if (is_first) return step;
  const double limit = ranges_per_step * law_.largest_attraction() / law_.steepest_fall();
  const double farthest =
      largest_of(n, [&](std::size_t i) { return is_body(i) ? std::fabs(t_[i]) : 0.0; });
  return step * farthest > limit ? std::min(step, bounded) : step;
}

bool GapDescent::move(bool is_first) {
  const std::ptrdiff_t n = std::ssize(x_);
  const double step = step_length(is_first);
  bool closed = false, opened = false;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    if (is_open(i)) {
      x_[i] -= step * t_[i];
      if (is_body(i) && x_[i] <= 0) {
        closed = closed || x_[i] < 0;
        x_[i] = 0.0;
      }
    } else if (is_body(i) && residual_[i] < 0) {
      x_[i] = -opening * residual_[i] * surface_.self_influence();
      opened = true;
    }
  }
  if (closed || opened) {
    keep_mean();
    press();
  } else {
    for_each_cell(n, [&](std::ptrdiff_t i) { p_[i] -= step * q_[i]; });
    exact_ = false;
  }
  return opened;
}

bool GapDescent::descend(double approach, double tol, int max_iterations) {
  approach_to(approach);
  const double work = law_.energy(law_.reach()) * static_cast<double>(x_.size());
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

Field GapDescent::gap() const {
  Field found = surface_.over_grid(x_);
  const Field body = [&] {
    Field is(x_.size());
    for (std::size_t i = 0; i < is.size(); ++i) is[i] = is_body(i) ? 1.0 : 0.0;
    return surface_.over_grid(is);
  }();
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (body[i] == 0.0) found[i] = INFINITY;
  }
  return found;
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
