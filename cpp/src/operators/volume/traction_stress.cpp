// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/volume/traction_stress.hpp"

#include <algorithm>
#include <exception>
#include <iterator>
#include <numeric>
#include <utility>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/threads.hpp"
#include "samcontact/fft/parity_spectrum.hpp"
#include "samcontact/operators/convolution/parity_product.hpp"

namespace samcontact::operators {
namespace {

/// Copies rows of a table [j][i] to those of a wider quarter.
template <class Put>
void for_rows(const double* table, const KernelOffsets& of, double* quarter, int hx,
              const Put& put) {
  for (int j = 0; j < of.ny; ++j, table += of.nx, quarter += hx) put(table, quarter);
}

}  // namespace

TractionStress::TractionStress(const Grid& grid, const VolumeTransform& transform,
                               SharedMedium medium, std::shared_ptr<const HeatStress> heat,
                               std::vector<double> depths, Tensor tensor)
    : grid_(grid),
      transform_(&transform),
      medium_(std::move(medium)),
      heat_(std::move(heat)),
      depths_(std::move(depths)),
      tensor_(tensor) {
  for (Kernels& kernels : kernels_) kernels.resize(depths_.size());
}

kernels::Parity TractionStress::parity(Part part, int component) {
  auto p = kernels::component_parity(component);
  const bool both = part == Part::heat_xy;
  if (part == Part::shear_x || part == Part::heat_x || both) p.odd_x = !p.odd_x;
  if (part == Part::shear_y || part == Part::heat_y || both) p.odd_y = !p.odd_y;
  return p;
}

std::vector<TractionStress::Part> TractionStress::parts(Traction traction) const {
  if (traction == Traction::shear_x) return {Part::shear_x};
  if (traction == Traction::shear_y) return {Part::shear_y};
  std::vector<Part> parts{Part::pressure};
  if (!heat_) return parts;
  if (heat_->heating().speed_x != 0) parts.push_back(Part::heat_x);
  if (heat_->heating().speed_y != 0) parts.push_back(Part::heat_y);
  if (parts.size() == 3) parts.push_back(Part::heat_xy);
  return parts;
}

void TractionStress::prepare(Traction traction, std::span<const int> depths,
                             const TractionStress* shallower) const {
  const std::lock_guard lock(mutex_);
  const auto needed = parts(traction);
  const auto of = [&](Part part) -> Kernels& { return kernels_[static_cast<int>(part)]; };
  if (shallower != nullptr) {
    const std::lock_guard other(shallower->mutex_);
    for (const Part part : needed) {
      const Kernels& known = shallower->kernels_[static_cast<int>(part)];
      for (int k = 0; k < std::min(layers(), shallower->layers()); ++k) {
        if (!of(part)[k]) of(part)[k] = known[k];
      }
    }
  }
  std::vector<int> missing;
  std::ranges::copy_if(depths, std::back_inserter(missing),
                       [&](int k) { return !of(needed[0])[k]; });
  if (missing.empty()) return;
  check_interrupt();
  const int count = static_cast<int>(missing.size());
  std::vector<std::vector<ParityParts>> heat(count);
  if (heat_ && traction == Traction::pressure) {
    const KernelOffsets offsets(grid_, transform_->mx(), transform_->my());
    // Not in parallel: the computation of a table checks for an interrupt, and may throw.
    for (int n = 0; n < count; ++n) {
      heat[n] = parts_of(heat_->at(depths_[missing[n]], grid_, offsets), tensor_);
    }
  }
  const fft::ParitySpectrum spectrum(transform_->mx(), transform_->my());
  std::array<Kernels, part_count> built;
  for (const Part part : needed) {
    Kernels& kernels = built[static_cast<int>(part)];
    kernels.resize(count);
    const auto build_at = [&](int n) {
      kernels[n] = std::make_shared<const Field>(build(part, missing[n], heat[n], spectrum));
    };
    if (count == 1) {  // threads share the work inside
      build_at(0);
      continue;
    }
    // An exception that leaves a parallel loop ends the process.
    std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic)
    for (int n = 0; n < count; ++n) {
      try {
        build_at(n);
      } catch (...) {
#pragma omp critical
        failure = std::current_exception();
      }
    }
    if (failure) std::rethrow_exception(failure);
  }
  for (const Part part : needed) {
    for (int n = 0; n < count; ++n) {
      of(part)[missing[n]] = std::move(built[static_cast<int>(part)][n]);
    }
  }
}

Field TractionStress::build(Part part, int k, const std::vector<ParityParts>& heat,
                            const fft::ParitySpectrum& spectrum) const {
  const int hx = spectrum.hx(), hy = spectrum.hy();
  const KernelOffsets offsets(grid_, transform_->mx(), transform_->my());
  const std::size_t plane = static_cast<std::size_t>(offsets.nx) * offsets.ny;
  const auto places = components(tensor_);
  const int count = static_cast<int>(places.size());
  const bool elastic = part == Part::pressure || part == Part::shear_x || part == Part::shear_y;
  const Traction traction = part == Part::shear_x   ? Traction::shear_x
                            : part == Part::shear_y ? Traction::shear_y
                                                    : Traction::pressure;
  const Field table =
      elastic ? medium_->stress(traction, grid_, offsets, depths_[k], tensor_) : Field{};
  Field built(spectrum.size() * count);
  for (int c = 0; c < count; ++c) {
    Field quarter(spectrum.size(), 0.0);
    if (elastic) {
      for_rows(table.data() + c * plane, offsets, quarter.data(), hx,
               [n = offsets.nx](const double* from, double* to) { std::copy_n(from, n, to); });
    }
    if (!heat.empty() && !heat[c][static_cast<int>(part)].empty()) {
      for_rows(heat[c][static_cast<int>(part)].data(), offsets, quarter.data(), hx,
               [n = offsets.nx](const double* from, double* to) {
                 for (int i = 0; i < n; ++i) to[i] += from[i];
               });
    }
    const auto p = parity(part, places[c]);
    spectrum.transform(quarter.data(), p.odd_x, p.odd_y);
    for (int ky = 0; ky < hy; ++ky) {
      const std::size_t row = static_cast<std::size_t>(ky) * count + c;
      std::copy_n(quarter.data() + static_cast<std::size_t>(ky) * hx, hx, built.data() + row * hx);
    }
  }
  return built;
}

void TractionStress::add(Part part, kernels::Parity input, const Field& traction, double scale,
                         Depths depths, VolumeSpectrum& out, int to) const {
  const Kernels& kernels = kernels_[static_cast<int>(part)];
  const int hx = out.mx / 2 + 1;
  const auto places = components(tensor_);
#pragma omp parallel for schedule(static) if (2.0 * out.data.size() > min_parallel_operations)
  for (int ky = 0; ky < out.mh; ++ky) {
    const double* in = traction.data() + ky * transform_->row_size();
    for (int c = 0; c < out.components; ++c) {
      const std::size_t row = (static_cast<std::size_t>(ky) * out.components + c) * hx;
      const auto own = parity(part, places[c]);
      const double signed_scale = scale * mirror_sign(out.symmetry, own, input);
      for (int k = depths.first; k < depths.last; ++k) {
        add_parity_product(kernels[k]->data() + row, own, signed_scale, in,
                           out.row(ky, c, to + k - depths.first), *transform_);
      }
    }
  }
}

TractionStress::Spectra TractionStress::spectra(const Tractions& tractions) const {
  Spectra spectra;
  for (const Traction kind : all_tractions) {
    const Field& field = tractions.of(kind);
    if (field.empty()) continue;
    spectra[static_cast<int>(kind)] = transform_->forward(field.data(), vector_parity(kind));
  }
  return spectra;
}

void TractionStress::prepare(const Spectra& tractions, std::span<const int> depths,
                             const TractionStress* shallower) const {
  for (const Traction kind : all_tractions) {
    if (!tractions[static_cast<int>(kind)].empty()) prepare(kind, depths, shallower);
  }
}

void TractionStress::add(const Spectra& tractions, double shear_sign, Depths depths,
                         VolumeSpectrum& out, int to) const {
  for (const Traction kind : all_tractions) {
    const Field& spectrum = tractions[static_cast<int>(kind)];
    if (spectrum.empty()) continue;
    for (const Part part : parts(kind)) {
      add(part, vector_parity(kind), spectrum, sign_of(kind, shear_sign), depths, out, to);
    }
    out.used.assign(out.nz, 1);
  }
}

void TractionStress::add_depth(const Spectra& tractions, double shear_sign, int depth,
                               VolumeSpectrum& out) const {
  add(tractions, shear_sign, {depth, depth + 1}, out, 0);
}

void TractionStress::add(const Tractions& tractions, double shear_sign, VolumeSpectrum& out,
                         const TractionStress* shallower, int first) const {
  const Spectra known = spectra(tractions);
  const int last = std::max(first, std::min(out.nz, layers()));
  std::vector<int> depths(last - first);
  std::iota(depths.begin(), depths.end(), first);
  prepare(known, depths, shallower);
  add(known, shear_sign, {first, last}, out, first);
}

std::size_t TractionStress::bytes() const {
  const std::lock_guard lock(mutex_);
  std::size_t values = 0;
  for (const Kernels& kernels : kernels_) {
    for (const auto& kernel : kernels) values += kernel ? kernel->size() : 0;
  }
  return values * sizeof(double);
}

Field traction_stress(const Grid& grid, const SharedMedium& medium, const Heating& heating,
                      std::span<const double> depths, const Tractions& tractions) {
  const VolumeTransform transform(grid, Symmetry::none);
  const auto heat = heating.is_on()
                        ? std::make_shared<const HeatStress>(grid, heat_of(*medium), heating)
                        : nullptr;
  const std::size_t plane = grid.surface_size();
  TractionStress::Spectra loads;
  for (const Traction kind : all_tractions) {
    const Field& field = tractions.of(kind);
    if (!field.empty()) loads[static_cast<int>(kind)] = transform.forward(field.data());
  }
  Field stress(6 * depths.size() * plane), layer(6 * plane);
  // One depth at a time: the kernels of a depth are used once, so only one set is kept.
  for (std::size_t d = 0; d < depths.size(); ++d) {
    VolumeSpectrum spectrum(transform, 1, Tensor::full);
    const TractionStress at(grid, transform, medium, heat, {depths[d]}, Tensor::full);
    at.prepare(loads, std::array{0});
    at.add_depth(loads, 1.0, 0, spectrum);
    inverse(transform, spectrum, layer.data());
    for (int c = 0; c < 6; ++c) {
      std::copy(layer.begin() + c * plane, layer.begin() + (c + 1) * plane,
                stress.begin() + (c * depths.size() + d) * plane);
    }
  }
  return stress;
}

}  // namespace samcontact::operators
