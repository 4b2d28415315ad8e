// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface/body_displacement.hpp"

#include "samcontact/base/reduce.hpp"

namespace samcontact::operators {

BodyDisplacement::BodyDisplacement(const Grid& grid, SharedMedium medium)
    : grid_(grid), medium_(std::move(medium)), convolution_(grid) {}

const ParityKernel& BodyDisplacement::kernel(Traction kind, Axis axis) const {
  const std::lock_guard lock(mutex_);
  const auto found = kernels_.find({kind, axis});
  if (found != kernels_.end()) return found->second;
  const auto& [nx, ny] = convolution_.offsets();
  ParityKernel made{compliance_parity(kind, axis),
                    medium_->compliance(kind, axis, grid_, CellOffsets::lattice(nx, ny))};
  convolution_.transform(made);
  return kernels_.emplace(std::pair{kind, axis}, std::move(made)).first->second;
}

Field BodyDisplacement::operator()(const Tractions& tractions, double shear_sign, Axis axis) const {
  Field total(grid_.surface_size(), 0.0), part(grid_.surface_size());
  if (medium_->is_rigid()) return total;
  ComplexField work;
  for (const Traction kind : all_tractions) {
    const Field& field = tractions.of(kind);
    if (field.empty()) continue;
    convolution_.apply({&kernel(kind, axis), 1}, field.data(), part.data(), work);
    const double sign = sign_of(kind, shear_sign);
    for (std::size_t i = 0; i < total.size(); ++i) total[i] += sign * part[i];
  }
  return total;
}

double BodyDisplacement::work(const Tractions& force, const Tractions& cause,
                              double shear_sign) const {
  double sum = 0.0;
  for (const Traction kind : all_tractions) {
    const Field& on = force.of(kind);
    if (on.empty()) continue;
    const Field u = (*this)(cause, shear_sign, axis_along(kind));
    sum += sign_of(kind, shear_sign) * ordered_dot(on.data(), u.data(), on.size());
  }
  return sum * grid_.cell_area();
}

std::size_t BodyDisplacement::bytes() const {
  const std::lock_guard lock(mutex_);
  std::size_t bytes = 0;
  for (const auto& [key, kernel] : kernels_) bytes += sizeof(double) * kernel.quarter.size();
  return bytes;
}

}  // namespace samcontact::operators
