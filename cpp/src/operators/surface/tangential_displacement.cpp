// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface/tangential_displacement.hpp"

#include <cmath>
#include <utility>

#include "samcontact/base/reduce.hpp"

namespace samcontact::operators {
namespace {

/// Coupling coefficients below this fraction of those of shear are rounding errors of bodies whose
/// coupling cancels.
constexpr double negligible = 1e-13;

double size_of(const Field& table) {
  return largest_of(table.size(), [&](std::size_t i) { return std::fabs(table[i]); });
}

}  // namespace

TangentialInfluence::TangentialInfluence(SharedMedium body1, SharedMedium body2, double layer)
    : body1_(std::move(body1)), body2_(std::move(body2)), layer_(layer) {}

Field TangentialInfluence::table(Traction traction, Axis axis, const Grid& grid,
                                 const CellOffsets& offsets) const {
  // On body 1 shear is reversed, and its tangential displacement counts with a minus.
  const double sign = sign_of(traction, shear_sign(0)) * (axis == Axis::z ? 1.0 : shear_sign(0));
  Field sum = body2_->compliance(traction, axis, grid, offsets);
  const bool same = *body1_ == *body2_;
  const Field other = same ? sum : body1_->compliance(traction, axis, grid, offsets);
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += sign * other[n];
  const bool along = (traction == Traction::shear_x && axis == Axis::x) ||
                     (traction == Traction::shear_y && axis == Axis::y);
  // A thin layer deforms only below the loaded cell.
  for (std::size_t n = 0; n < sum.size() && along && layer_ > 0; ++n) {
    if (offsets.x[n % offsets.x.size()] == 0 && offsets.y[n / offsets.x.size()] == 0) {
      sum[n] += layer_;
    }
  }
  return sum;
}

std::vector<MatrixKernel> tangential_kernels(const Grid& grid, const TangentialInfluence& influence,
                                             const KernelOffsets& offsets) {
  const auto lattice = CellOffsets::lattice(offsets.nx, offsets.ny);
  const auto kernel = [&](Traction traction, Axis axis) {
    return ParityKernel{compliance_parity(traction, axis),
                        influence.table(traction, axis, grid, lattice)};
  };
  std::vector<MatrixKernel> kernels;
  kernels.push_back({0, 0, kernel(Traction::shear_x, Axis::x)});
  kernels.push_back({0, 1, kernel(Traction::shear_y, Axis::x)});
  kernels.push_back({1, 0, kernels[1].kernel});
  kernels.push_back({1, 1, kernel(Traction::shear_y, Axis::y)});
  return kernels;
}

TangentialDisplacement::TangentialDisplacement(const Grid& grid,
                                               const TangentialInfluence& influence)
    : convolution_(grid),
      kernels_(tangential_kernels(grid, influence, convolution_.offsets())),
      self_influence_(kernels_[0].kernel.quarter[0]),
      neighbour_influence_(kernels_[0].kernel.quarter[grid.nx > 1 ? 1 : 0]) {
  for (MatrixKernel& entry : kernels_) convolution_.transform(entry.kernel);
}

void TangentialDisplacement::apply(const double* shear, double* displacement,
                                   ComplexField& work) const {
  convolution_.apply(kernels_, 2, shear, 2, displacement, work);
}

NormalTangentialCoupling::NormalTangentialCoupling(const Grid& grid,
                                                   const TangentialInfluence& influence)
    : convolution_(grid) {
  const auto lattice = CellOffsets::lattice(convolution_.offsets().nx, convolution_.offsets().ny);
  const double scale = size_of(influence.table(Traction::shear_x, Axis::x, grid, lattice));
  for (const auto& [component, shear, axis] :
       {std::tuple{0, Traction::shear_x, Axis::x}, {1, Traction::shear_y, Axis::y}}) {
    const auto add = [&](Traction traction, Axis along, int out, int in,
                         std::vector<MatrixKernel>& to) {
      ParityKernel kernel{compliance_parity(traction, along),
                          influence.table(traction, along, grid, lattice)};
      if (size_of(kernel.quarter) <= negligible * scale) return;
      convolution_.transform(kernel);
      to.push_back({out, in, std::move(kernel)});
    };
    add(shear, Axis::z, 0, component, to_normal_);
    add(Traction::pressure, axis, component, 0, to_tangential_);
  }
}

void NormalTangentialCoupling::normal(const double* shear, double* displacement,
                                      ComplexField& work) const {
  convolution_.apply(to_normal_, 2, shear, 1, displacement, work);
}

void NormalTangentialCoupling::tangential(const double* pressure, double* displacement,
                                          ComplexField& work) const {
  convolution_.apply(to_tangential_, 1, pressure, 2, displacement, work);
}

}  // namespace samcontact::operators
