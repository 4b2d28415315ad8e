// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface/relative_displacement.hpp"

#include <array>

namespace samcontact::operators {
namespace {

constexpr std::array tractions{Traction::pressure, Traction::shear_x, Traction::shear_y};
constexpr std::array axes{Axis::z, Axis::x, Axis::y};

}  // namespace

std::vector<MatrixKernel> relative_kernels(const Grid& grid, const TangentialInfluence& influence,
                                           const KernelOffsets& offsets) {
  const auto lattice = CellOffsets::lattice(offsets.nx, offsets.ny);
  std::vector<MatrixKernel> kernels;
  for (int out = 0; out < 3; ++out) {
    for (int in = 0; in < 3; ++in) {
      kernels.push_back({out,
                         in,
                         {compliance_parity(tractions[in], axes[out]),
                          influence.table(tractions[in], axes[out], grid, lattice)}});
    }
  }
  return kernels;
}

RelativeDisplacement::RelativeDisplacement(const Grid& grid, const TangentialInfluence& influence)
    : convolution_(grid),
      kernels_(relative_kernels(grid, influence, convolution_.offsets())),
      normal_self_influence_(kernels_[0].kernel.quarter[0]),
      tangential_self_influence_(kernels_[4].kernel.quarter[0]) {
  for (MatrixKernel& entry : kernels_) convolution_.transform(entry.kernel);
}

}  // namespace samcontact::operators
