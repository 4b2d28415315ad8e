// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/attraction.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "samcontact/base/errors.hpp"
#include "samcontact/base/reduce.hpp"

namespace samcontact::contact {
namespace {

/// Relative to the maximum tensile force: a load this close to it counts as equal.
constexpr double rounding_fraction = 1e-12;

}  // namespace

Attraction::Attraction(const ContactLaw& law, const Grid& grid,
                       const operators::NormalDisplacement& displacement, const Field& gap)
    : Attraction(law.attracts() ? contact::attraction(law, gap) : Field{}, grid, displacement,
                 gap) {}

Attraction::Attraction(Field pull, const Grid& grid,
                       const operators::NormalDisplacement& displacement, const Field& gap)
    : given_(gap), pull_(std::move(pull)), cell_area_(grid.cell_area()) {
  if (pull_.empty()) return;
  moment_ = moments(grid, pull_);
  force_ = cell_area_ * ordered_sum(gap.size(), [&](std::size_t i) { return pull_[i]; });
  attracted_.resize(gap.size());
  ComplexField scratch;
  displacement.apply(pull_.data(), attracted_.data(), scratch);
  for (std::size_t i = 0; i < gap.size(); ++i) attracted_[i] = gap[i] - attracted_[i];
}

Drive Attraction::repelling(const Drive& drive) const {
  const Given& normal = drive.normal;
  if (pull_.empty() || !normal.is_force()) return drive;
  const double repulsion = normal.value + force_;
  require(
      repulsion >= -rounding_fraction * force_, "load",
      "at least " + to_short_text(-force_, 6) + " N, the maximum tensile force of the contact law",
      normal.value);
  Drive repelling = drive;
  repelling.normal.value = repulsion > rounding_fraction * force_ ? repulsion : 0.0;
  for (int k = 0; k < 2; ++k) {
    if (drive.tilt[k].is_force()) repelling.tilt[k].value += moment_[k];
  }
  return repelling;
}

Field Attraction::repulsion(Field pressure) const {
  if (pull_.empty()) return pressure;
  for (std::size_t i = 0; i < pressure.size(); ++i) pressure[i] += pull_[i];
  return pressure;
}

Solution Attraction::with_attraction(Solution solution, const Drive& drive) const {
  if (pull_.empty()) return solution;
  for (std::size_t i = 0; i < pull_.size(); ++i) solution.tractions.pressure[i] -= pull_[i];
  solution.load = drive.normal.is_force() ? drive.normal.value : solution.load - force_;
  for (int k = 0; k < 2; ++k) {
    const Given& tilt = drive.tilt[k];
    solution.moment[k] = tilt.is_force() ? tilt.value : solution.moment[k] - moment_[k];
  }
  return solution;
}

}  // namespace samcontact::contact
