// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/adhesive_gap.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"

namespace samcontact::contact {
namespace {

/// Gap, in ranges of the attraction, beyond which a cell under tension is clearly open.
constexpr double clearly_open = 0.01;
/// Pressure, as a share of the largest attraction, above which a cell is clearly pressed.
constexpr double clearly_pressed = 1e-3;
/// Error of the pressure of a start, relative to the largest repulsion.
constexpr double error_of_start = 1e-3;
/// Share of the attraction of touching surfaces that is missing where surfaces do not touch.
constexpr double missing = 0.05;

}  // namespace

AdhesiveGap::AdhesiveGap(const AdhesiveSurface& surface, const Field& initial_gap)
    : surface_(surface),
      cells_(surface.size()),
      x_(surface.size(), 0.0),
      undeformed_(surface.padded(initial_gap)) {
  const Field inside = surface.padded(Field(initial_gap.size(), 1.0));
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const bool is_inside = inside[i] == 1.0, is_body = is_inside && std::isfinite(undeformed_[i]);
    const Cell without = surface.has_free_mean() && !is_inside ? Cell::frozen : Cell::free;
    cells_[i] = is_body ? Cell::body : without;
    if (!is_body) undeformed_[i] = 0.0;
  }
  height_ = undeformed_;
}

void AdhesiveGap::start_from(const Field& pressure, const ContactLaw& law, ComplexField& work) {
  has_approach_ = false;
  if (pressure.empty()) return std::fill(x_.begin(), x_.end(), 0.0);
  surface_.displace(surface_.padded(pressure), x_, work);
  const double lowest = touching();
  Field gap = x_;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    if (is_body(i)) gap[i] = undeformed_[i] + x_[i] - lowest;
  }
  if (is_separated(law, surface_.padded(pressure), gap)) return;
  Field closed = surface_.padded(repulsion(law, pressure, surface_.over_grid(gap)));
  const double error =
      error_of_start * std::max(law.largest_attraction(),
                                largest_of(closed.size(), [&](auto i) { return closed[i]; }));
  for (double& r : closed) r = r > error ? r : 0.0;
  const double cells = ordered_sum(
      gap.size(), [&](std::size_t i) { return is_body(i) && in_contact(closed[i]) ? 1.0 : 0.0; });
  if (cells == 0) return;
  // Surfaces in contact keep their gap at another approach, and the cells in contact remain closed.
  approach_ =
      ordered_sum(gap.size(),
                  [&](std::size_t i) {
                    return is_body(i) && in_contact(closed[i]) ? undeformed_[i] + x_[i] : 0.0;
                  }) /
      cells;
  has_approach_ = true;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    if (!is_body(i)) continue;
    x_[i] = in_contact(closed[i]) ? 0.0 : std::max(undeformed_[i] + x_[i] - approach_, 0.0);
  }
}

bool AdhesiveGap::is_separated(const ContactLaw& law, const Field& pressure,
                               const Field& gap) const {
  const double open = clearly_open * law.largest_attraction() / law.steepest_fall();
  const double pressed = clearly_pressed * law.largest_attraction();
  double expected = 0.0, excess = 0.0;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    if (!is_body(i)) continue;
    if (pressure[i] > pressed) return false;
    if (gap[i] <= open) continue;
    const double pull = law.attraction(gap[i]);
    expected += pull;
    excess += pressure[i] + pull;
  }
  return excess > missing * expected;
}

double AdhesiveGap::touching() const {
  if (has_approach_) return approach_;
  double lowest = INFINITY;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    if (is_body(i)) lowest = std::min(lowest, undeformed_[i] + x_[i]);
  }
  return lowest;
}

double AdhesiveGap::largest_approach() const {
  if (!surface_.has_free_mean()) return INFINITY;
  const std::size_t n = x_.size();
  return ordered_sum(n, [&](std::size_t i) { return undeformed_[i]; }) /
         ordered_sum(n, [&](std::size_t i) { return is_body(i) ? 1.0 : 0.0; });
}

bool AdhesiveGap::touches() const {
  return largest_of(x_.size(),
                    [&](std::size_t i) { return is_body(i) && x_[i] <= 0 ? 1.0 : 0.0; }) > 0;
}

void AdhesiveGap::approach_to(double approach) {
  const std::ptrdiff_t n = std::ssize(x_);
  const bool touching = has_approach_ && touches();
  // The gap of a contact is kept; separated surfaces, and a start, keep their displacement.
  const double lowering = has_approach_ ? approach - approach_ : 0.0;
  for_each_cell(n, [&](std::ptrdiff_t i) {
    if (!is_body(i)) return;
    height_[i] = undeformed_[i] - approach;
    if (!has_approach_) {
      x_[i] = std::max(x_[i] + height_[i], 0.0);
    } else if (!touching) {
      x_[i] = std::max(x_[i] - lowering, 0.0);
    }
  });
  approach_ = approach;
  has_approach_ = true;
  keep_mean();
}

void AdhesiveGap::return_to(const Field& values, double approach) {
  x_ = values;
  approach_ = approach;
  has_approach_ = true;
}

void AdhesiveGap::keep_mean() {
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

void AdhesiveGap::displacement(Field& found) const {
  for_each_cell(std::ssize(x_), [&](std::ptrdiff_t i) { found[i] = x_[i] - height_[i]; });
}

Field AdhesiveGap::over_grid() const {
  Field gap = x_;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    if (!is_body(i)) gap[i] = INFINITY;
  }
  return surface_.over_grid(gap);
}

}  // namespace samcontact::contact
