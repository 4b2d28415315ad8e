// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface/near_tangential.hpp"

#include <algorithm>
#include <utility>

#include "samcontact/operators/surface/near_displacement.hpp"

namespace samcontact::operators {
namespace {

/// Shorter boxes are padded in full: their coarse grid would be as fine as the box.
constexpr int shortest_side_with_coarse_grid = 64;

SurfaceConvolution convolution_for(const Grid& box) {
  if (std::min(box.nx, box.ny) < shortest_side_with_coarse_grid) return SurfaceConvolution(box);
  return {box, short_period_x(box), short_period_y(box)};
}

}  // namespace

NearTangential::NearTangential(const Grid& box, const TangentialInfluence& influence)
    : near_(convolution_for(box)),
      kernels_(tangential_kernels(box, influence, near_.offsets())),
      coarse_(box.nx, box.ny) {
  for (MatrixKernel& entry : kernels_) near_.transform(entry.kernel);
  if (!is_exact_period(near_.mx(), box.nx, box.period.x) ||
      !is_exact_period(near_.my(), box.ny, box.period.y)) {
    add_far_kernels(box, influence);
  }
}

void NearTangential::add_far_kernels(const Grid& box, const TangentialInfluence& influence) {
  const int cx = coarse_.x().coarse_cells(), cy = coarse_.y().coarse_cells();
  far_ = std::make_unique<SurfaceConvolution>(Grid(cx, cy, 1.0, 1.0));
  CellOffsets direct, nearest;  // to the cell, and to the nearest of its images
  for (int I = 0; I < cx; ++I) {
    direct.x.push_back(I * coarse_.x().factor);
    nearest.x.push_back(std::min(direct.x[I], near_.mx() - direct.x[I]));
  }
  for (int J = 0; J < cy; ++J) {
    direct.y.push_back(J * coarse_.y().factor);
    nearest.y.push_back(std::min(direct.y[J], near_.my() - direct.y[J]));
  }
  const auto kernel = [&](Traction traction, Axis axis) {
    const auto parity = compliance_parity(traction, axis);
    Field table = influence.table(traction, axis, box, direct);
    const Field periodic = influence.table(traction, axis, box, nearest);
    for (int J = 0; J < cy; ++J) {
      for (int I = 0; I < cx; ++I) {
        // The nearest image across the seam lies on the other side.
        const bool across_x = nearest.x[I] != direct.x[I], across_y = nearest.y[J] != direct.y[J];
        const bool odd = (parity.odd_x && across_x) != (parity.odd_y && across_y);
        const std::size_t at = static_cast<std::size_t>(J) * cx + I;
        table[at] = across_x || across_y ? table[at] - (odd ? -1.0 : 1.0) * periodic[at] : 0.0;
      }
    }
    ParityKernel far{parity, std::move(table)};
    far_->transform(far);
    return far;
  };
  far_kernels_.push_back({0, 0, kernel(Traction::shear_x, Axis::x)});
  far_kernels_.push_back({0, 1, kernel(Traction::shear_y, Axis::x)});
  far_kernels_.push_back({1, 0, far_kernels_[1].kernel});
  far_kernels_.push_back({1, 1, kernel(Traction::shear_y, Axis::y)});
}

void NearTangential::apply(const double* shear, double* displacement, ComplexField& work) const {
  near_.apply(kernels_, 2, shear, 2, displacement, work);
  if (!far_) return;
  const std::size_t cells = static_cast<std::size_t>(coarse_.x().cells) * coarse_.y().cells;
  Field sums(2 * coarse_.size());
  for (int c = 0; c < 2; ++c) coarse_.gather(shear + c * cells, &sums[c * coarse_.size()]);
  far_->apply(far_kernels_, 2, sums.data(), 2, sums.data(), work);
  for (int c = 0; c < 2; ++c) coarse_.add(&sums[c * coarse_.size()], displacement + c * cells);
}

double NearTangential::cost() const { return 2 * (near_.cost() + (far_ ? far_->cost() : 0.0)); }

}  // namespace samcontact::operators
