// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/tensor_fields.hpp"

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

}  // namespace samcontact::simulation
