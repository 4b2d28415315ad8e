// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/convolution/volume_spectrum.hpp"

#include <algorithm>
#include <utility>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/threads.hpp"
#include "samcontact/kernels/eigenstrain.hpp"

namespace samcontact::operators {
namespace {

/// Planes of one layer; those of consecutive components are `step` apart.
std::vector<VolumeTransform::Plane> planes_of(const double* tensor, std::size_t step,
                                              VolumeSpectrum& spectrum, int layer) {
  std::vector<VolumeTransform::Plane> planes;
  const auto places = components(spectrum.tensor);
  for (int c = 0; c < spectrum.components; ++c) {
    const auto parity = kernels::component_parity(places[c]);
    const double* values = tensor + c * step;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): forward transforms only read them.
    auto* read = const_cast<double*>(values);
    planes.push_back({read, spectrum.row(0, c, layer), parity.odd_x, parity.odd_y});
  }
  return planes;
}

}  // namespace

VolumeSpectrum::VolumeSpectrum(const VolumeTransform& transform, int nz_, Tensor tensor_,
                               Field memory)
    : symmetry(transform.symmetry()),
      tensor(tensor_),
      components(count(tensor_)),
      nz(nz_),
      mx(transform.mx()),
      my(transform.my()),
      mh(transform.mh()),
      modes(transform.modes()),
      parts(transform.parts()),
      pitch(transform.pitch()),
      data(std::move(memory)),
      used(nz_, 1) {
  data.resize(mh * stride());
}

void forward(const VolumeTransform& transform, const double* tensor, VolumeSpectrum& out) {
  check_interrupt();
  const std::size_t plane = transform.plane_size();
  const double work = per_number * plane * out.components * out.nz;
#pragma omp parallel for schedule(dynamic) if (work > min_parallel_operations)
  for (int k = 0; k < out.nz; ++k) {
    out.used[k] = 0;
    for (int c = 0; c < out.components && !out.used[k]; ++c) {
      const double* values = tensor + (static_cast<std::size_t>(c) * out.nz + k) * plane;
      out.used[k] = std::any_of(values, values + plane, [](double v) { return v != 0.0; });
    }
    if (out.used[k])
      transform.forward(planes_of(tensor + k * plane, out.nz * plane, out, k), out.stride());
  }
}

void forward(const VolumeTransform& transform, const double* tensor, VolumeSpectrum& out,
             int layer) {
  transform.forward(planes_of(tensor, transform.plane_size(), out, layer), out.stride());
}

void inverse(const VolumeTransform& transform, VolumeSpectrum& spectrum, int layer, double* tensor,
             std::span<const fft::RowRun> rows) {
  transform.inverse(planes_of(tensor, transform.plane_size(), spectrum, layer), spectrum.stride(),
                    rows);
}

void inverse(const VolumeTransform& transform, VolumeSpectrum& spectrum, double* tensor) {
  check_interrupt();
  const std::size_t plane = transform.plane_size();
  const double work = per_number * plane * spectrum.components * spectrum.nz;
#pragma omp parallel for schedule(dynamic) if (work > min_parallel_operations)
  for (int k = 0; k < spectrum.nz; ++k) {
    transform.inverse(planes_of(tensor + k * plane, spectrum.nz * plane, spectrum, k),
                      spectrum.stride());
  }
}

}  // namespace samcontact::operators
