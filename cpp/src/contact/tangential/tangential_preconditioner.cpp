// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/tangential/tangential_preconditioner.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/operators/surface/kernel_floor.hpp"
#include "samcontact/operators/surface/near_displacement.hpp"

namespace samcontact::contact {
namespace {

/// Inverse of a symmetric matrix [[xx, xy], [xy, yy]] with its eigenvalues raised to at least
/// `min_eigenvalue`.
void invert(double min_eigenvalue, double& xx, double& xy, double& yy) {
  const double mean = 0.5 * (xx + yy), half = 0.5 * (xx - yy), radius = std::hypot(half, xy);
  const double first = 1.0 / std::max(mean + radius, min_eigenvalue),
               second = 1.0 / std::max(mean - radius, min_eigenvalue);
  const double stretch = radius > 0 ? 0.5 * (first - second) / radius : 0.0;
  xx = 0.5 * (first + second) + stretch * half;
  yy = 0.5 * (first + second) - stretch * half;
  xy *= stretch;
}

}  // namespace

TangentialPreconditioner::TangentialPreconditioner(const Grid& box,
                                                   const operators::TangentialInfluence& influence)
    : convolution_(box, operators::short_period_x(box), operators::short_period_y(box)),
      inverse_(operators::tangential_kernels(box, influence, convolution_.offsets())) {
  for (auto& entry : inverse_) convolution_.transform(entry.kernel);
  const double min_eigenvalue = operators::kernel_floor(box, influence);
  // Spectra contain 1/(mx my) of two transforms, and that of a doubly odd kernel a sign.
  const double points = static_cast<double>(convolution_.mx()) * convolution_.my();
  for (std::size_t k = 0; k < inverse_[0].kernel.quarter.size(); ++k) {
    const auto value = [&](int n) -> double& { return inverse_[n].kernel.quarter[k]; };
    double xx = points * value(0), xy = -points * value(1), yy = points * value(3);
    invert(min_eigenvalue, xx, xy, yy);
    value(0) = xx / points;
    value(1) = value(2) = -xy / points;
    value(3) = yy / points;
  }
}

}  // namespace samcontact::contact
