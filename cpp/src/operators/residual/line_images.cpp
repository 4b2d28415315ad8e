// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/residual/line_images.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/kernels/eigenstrain.hpp"

namespace samcontact::operators {
namespace {

/// Grid with one cell along its periodic direction.
Grid line_of(const Grid& grid) {
  const bool along_x = grid.period.x == 0;
  Grid line(along_x ? grid.nx : 1, along_x ? 1 : grid.ny, grid.dx, grid.dy, grid.nz, grid.dz);
  line.period = {along_x ? 0 : 1, along_x ? 1 : 0, grid.period.reference};
  line.k0 = grid.k0;
  return line;
}

VolumeTransform transform_of(const Grid& line, const VolumeTransform& box, int factor) {
  const bool along_x = line.period.x == 0;
  return {line, box.symmetry(), along_x ? factor * box.mx() : 0, along_x ? 0 : factor * box.my()};
}

/// The field of images decreases with the square of their distance.
int longer(double tol) {
  return std::clamp(static_cast<int>(std::ceil(0.6 / std::sqrt(tol))), 4, 1024);
}

Field stress_of(const LayerResidualStress& residual, const VolumeTransform& transform, int nz,
                Tensor tensor, const Field& strain) {
  VolumeSpectrum spectrum(transform, nz, tensor);
  forward(transform, strain.data(), spectrum);
  residual.apply(spectrum);
  Field stress(strain.size());
  inverse(transform, spectrum, stress.data());
  return stress;
}

}  // namespace

LineImages::LineImages(const Grid& grid, const VolumeTransform& transform, const Stack& body,
                       double tol)
    : along_x_(grid.period.x == 0),
      whole_(along_x_ ? grid.ny : grid.nx),
      nz_(grid.nz),
      nx_(transform.nx()),
      ny_(transform.ny()),
      mirrored_(along_x_ ? transform.symmetry() != Symmetry::none
                         : transform.symmetry() == Symmetry::xy),
      line_(line_of(grid)),
      short_transform_(transform_of(line_, transform, 1)),
      long_transform_(transform_of(line_, transform, longer(tol))),
      short_(line_, short_transform_, body),
      long_(line_, long_transform_, body) {}

Field LineImages::mean(Tensor tensor, const double* strain) const {
  const auto places = components(tensor);
  const int cells = along_x_ ? nx_ : ny_, count = along_x_ ? ny_ : nx_;
  const std::size_t step = along_x_ ? ny_ : 1, across = along_x_ ? 1 : ny_;
  Field means(places.size() * nz_ * cells, 0.0);
  double* to = means.data();
  for (const int place : places) {
    const auto parity = kernels::component_parity(place);
    const bool odd = mirrored_ && (along_x_ ? parity.odd_y : parity.odd_x);
    for (int k = 0; k < nz_; ++k, strain += static_cast<std::size_t>(nx_) * ny_) {
      for (int i = 0; i < cells; ++i, ++to) {
        if (odd) continue;
        for (int j = 0; j < count; ++j) {
          const bool twice = mirrored_ && (j > 0 || whole_ % 2 == 0);
          *to += (twice ? 2.0 : 1.0) * strain[i * step + j * across] / whole_;
        }
      }
    }
  }
  return means;
}

Field LineImages::stress(Tensor tensor, const double* strain) const {
  const Field line = mean(tensor, strain);
  Field images = stress_of(short_, short_transform_, nz_, tensor, line);
  const Field alone = stress_of(long_, long_transform_, nz_, tensor, line);
  for (std::size_t n = 0; n < images.size(); ++n) images[n] -= alone[n];
  return images;
}

void LineImages::subtract(Tensor tensor, const Field& images, int layer, double* stress) const {
  const int cells = along_x_ ? nx_ : ny_;
  for (int c = 0; c < count(tensor); ++c) {
    const double* line = images.data() + (static_cast<std::size_t>(c) * nz_ + layer) * cells;
    for (int i = 0; i < nx_; ++i) {
      for (int j = 0; j < ny_; ++j) *stress++ -= line[along_x_ ? i : j];
    }
  }
}

}  // namespace samcontact::operators
