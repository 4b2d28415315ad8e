// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/attraction.hpp"

#include <cmath>
#include <cstddef>

#include "samcontact/base/errors.hpp"
#include "samcontact/base/reduce.hpp"

namespace samcontact::contact {
namespace {

/// Relative to the maximum tensile force: a load this close to it counts as equal.
constexpr double rounding_fraction = 1e-12;

}  // namespace

Attraction::Attraction(const ContactLaw& law, const Grid& grid,
                       const operators::NormalDisplacement& displacement, const Field& gap)
    : given_(gap), cell_area_(grid.cell_area()) {
  if (!law.attracts()) return;
  pull_ = contact::attraction(law, gap);
  force_ = cell_area_ * ordered_sum(gap.size(), [&](std::size_t i) { return pull_[i]; });
  attracted_.resize(gap.size());
  ComplexField scratch;
  displacement.apply(pull_.data(), attracted_.data(), scratch);
  for (std::size_t i = 0; i < gap.size(); ++i) attracted_[i] = gap[i] - attracted_[i];
}

Given Attraction::normal(const Given& normal) const {
  if (pull_.empty() || !normal.is_force()) return normal;
  const double repulsion = normal.value + force_;
  require(
      repulsion >= -rounding_fraction * force_, "load",
      "at least " + to_short_text(-force_, 6) + " N, the maximum tensile force of the contact law",
      normal.value);
  return Given::force(repulsion > rounding_fraction * force_ ? repulsion : 0.0);
}

Field Attraction::repulsion(Field pressure) const {
  if (pull_.empty()) return pressure;
  for (std::size_t i = 0; i < pressure.size(); ++i) pressure[i] += pull_[i];
  return pressure;
}

Solution Attraction::with_attraction(Solution solution, const Given& normal) const {
  if (pull_.empty()) return solution;
  for (std::size_t i = 0; i < pull_.size(); ++i) solution.tractions.pressure[i] -= pull_[i];
  solution.load = normal.is_force() ? normal.value : solution.load - force_;
  return solution;
}

}  // namespace samcontact::contact
