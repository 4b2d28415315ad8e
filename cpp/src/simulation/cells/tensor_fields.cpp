// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/cells/tensor_fields.hpp"

#include <algorithm>

namespace samcontact::simulation {

using operators::Tensor;

Field cut(const Field& tensor, const Box& from, const Box& to) {
  if (from == to) return tensor;
  Field out(6 * to.volume_size());
  for (int c = 0; c < 6; ++c) {
    extract(tensor.data() + c * from.volume_size(), from, out.data() + c * to.volume_size(), to);
  }
  return out;
}

void complete(const double* deviator, std::size_t n, double* full) {
  int place = 0;
  for (const int c : operators::components(Tensor::deviator)) {
    std::copy_n(deviator + place++ * n, n, full + c * n);
  }
  for (std::size_t i = 0; i < n; ++i) full[2 * n + i] = -(full[i] + full[n + i]);
}

Field six_components(Field strain, Tensor tensor) {
  if (tensor == Tensor::full) return strain;
  const std::size_t n = strain.size() / 5;
  Field full(6 * n);
  complete(strain.data(), n, full.data());
  return full;
}

void put_unfolded(const Field& part, const Box& stored, fft::Symmetry symmetry, const Grid& grid,
                  const Box& region, Field& out) {
  const Box box = whole_box(stored, grid, symmetry);
  Field plane(box.surface_size());
  Box layer = box, surface = region;
  layer.nz = surface.nz = 1;
  for (int c = 0; c < 6; ++c) {
    for (int k = 0; k < std::min(box.nz, region.nz); ++k) {
      unfold(part.data() + (c * box.nz + k) * stored.surface_size(), stored, symmetry,
             c == 4 || c == 5, c == 3 || c == 5, plane.data(), box, grid);
      copy_common(plane.data(), layer, out.data() + (c * region.nz + k) * region.surface_size(),
                  surface);
    }
  }
}

}  // namespace samcontact::simulation
