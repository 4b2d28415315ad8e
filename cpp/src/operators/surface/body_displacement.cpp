// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface/body_displacement.hpp"

#include <vector>

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

Field BodyDisplacement::operator()(const Tractions& tractions, double shear_sign,
                                   std::span<const Axis> axes) const {
  const std::size_t cells = grid_.surface_size();
  Field displacement(axes.size() * cells, 0.0);
  if (medium_->is_rigid()) return displacement;
  Field acting;  // [traction][i][j]
  acting.reserve(all_tractions.size() * cells);
  std::vector<MatrixKernelRef> kernels;
  int inputs = 0;
  for (const Traction kind : all_tractions) {
    const Field& field = tractions.of(kind);
    if (field.empty()) continue;
    const double sign = sign_of(kind, shear_sign);
    for (const double value : field) acting.push_back(sign * value);
    for (int out = 0; const Axis axis : axes) {
      kernels.push_back({out++, inputs, &kernel(kind, axis)});
    }
    ++inputs;
  }
  if (inputs == 0) return displacement;
  ComplexField work;
  convolution_.apply(kernels, inputs, acting.data(), static_cast<int>(axes.size()),
                     displacement.data(), work);
  return displacement;
}

double BodyDisplacement::work(const Tractions& force, const Tractions& cause,
                              double shear_sign) const {
  std::vector<Traction> forces;
  std::vector<Axis> axes;
  for (const Traction kind : all_tractions) {
    if (force.of(kind).empty()) continue;
    forces.push_back(kind);
    axes.push_back(axis_along(kind));
  }
  const Field u = (*this)(cause, shear_sign, axes);
  double sum = 0.0;
  const double* along = u.data();
  for (const Traction kind : forces) {
    const Field& on = force.of(kind);
    sum += sign_of(kind, shear_sign) * ordered_dot(on.data(), along, on.size());
    along += on.size();
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
