// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/volume/traction_stress.hpp"

#include <algorithm>
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
      tensor_(tensor) {}

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

void TractionStress::prepare(Traction traction, const TractionStress* shallower) const {
  const std::lock_guard lock(mutex_);
  const auto needed = parts(traction);
  if (!spectra_[static_cast<int>(needed[0])].empty()) return;
  std::unique_lock<std::mutex> other;
  if (shallower != nullptr) other = std::unique_lock(shallower->mutex_);
  const Field none;
  const auto known = [&](Part part) -> const Field& {
    return shallower != nullptr ? shallower->spectra_[static_cast<int>(part)] : none;
  };
  const int first = known(needed[0]).empty() ? 0 : std::min(layers(), shallower->layers());
  std::vector<std::vector<ParityParts>> heat;
  if (heat_ && traction == Traction::pressure) {
    heat.resize(first);
    const KernelOffsets offsets(grid_, transform_->mx(), transform_->my());
    // Not in parallel: the computation of a table checks for an interrupt, and may throw.
    for (int k = first; k < layers(); ++k) {
      heat.push_back(parts_of(heat_->at(depths_[k], grid_, offsets), tensor_));
    }
  }
  std::array<Field, part_count> built;
  for (const Part part : needed) {
    built[static_cast<int>(part)] = build(part, heat, first, known(part));
  }
  for (const Part part : needed) {
    spectra_[static_cast<int>(part)] = std::move(built[static_cast<int>(part)]);
  }
}

Field TractionStress::build(Part part, const std::vector<std::vector<ParityParts>>& heat, int first,
                            const Field& known) const {
  const fft::ParitySpectrum spectrum(transform_->mx(), transform_->my());
  Field built(spectrum.size() * count(tensor_) * layers());
  if (first > 0) copy_layers(known, first, built, layers(), spectrum.hx());
  check_interrupt();
  const auto build_at = [&](int k) {
    build(part, k, heat.empty() ? std::vector<ParityParts>{} : heat[k], spectrum, built);
  };
  if (layers() - first == 1) {  // threads share the work inside
    build_at(first);
    return built;
  }
#pragma omp parallel for schedule(dynamic)
  for (int k = first; k < layers(); ++k) build_at(k);
  return built;
}

void TractionStress::build(Part part, int k, const std::vector<ParityParts>& heat,
                           const fft::ParitySpectrum& spectrum, Field& built) const {
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
      const std::size_t row = (static_cast<std::size_t>(ky) * count + c) * layers() + k;
      std::copy_n(quarter.data() + static_cast<std::size_t>(ky) * hx, hx, built.data() + row * hx);
    }
  }
}

void TractionStress::add(Part part, kernels::Parity input, const Field& traction, double scale,
                         VolumeSpectrum& out) const {
  const Field& spectra = spectra_[static_cast<int>(part)];
  const int hx = out.mx / 2 + 1;
  const auto places = components(tensor_);
#pragma omp parallel for schedule(static) if (2.0 * out.data.size() > min_parallel_operations)
  for (int ky = 0; ky < out.mh; ++ky) {
    const double* in = traction.data() + ky * transform_->row_size();
    for (int c = 0; c < out.components; ++c) {
      const double* quarter =
          spectra.data() + (static_cast<std::size_t>(ky) * out.components + c) * layers() * hx;
      const auto own = parity(part, places[c]);
      const double signed_scale = scale * mirror_sign(out.symmetry, own, input);
      for (int k = 0; k < std::min(out.nz, layers()); ++k, quarter += hx) {
        add_parity_product(quarter, own, signed_scale, in, out.row(ky, c, k), *transform_);
      }
    }
  }
  out.used.assign(out.nz, 1);
}

void TractionStress::add(Traction kind, const Field& spectrum, double shear_sign,
                         VolumeSpectrum& out, const TractionStress* shallower) const {
  prepare(kind, shallower);
  for (const Part part : parts(kind)) {
    add(part, vector_parity(kind), spectrum, sign_of(kind, shear_sign), out);
  }
}

void TractionStress::add(const Tractions& tractions, double shear_sign, VolumeSpectrum& out,
                         const TractionStress* shallower) const {
  for (const Traction kind : all_tractions) {
    const Field& field = tractions.of(kind);
    if (field.empty()) continue;
    add(kind, transform_->forward(field.data(), vector_parity(kind)), shear_sign, out, shallower);
  }
}

std::size_t TractionStress::bytes() const {
  const std::lock_guard lock(mutex_);
  std::size_t values = 0;
  for (const Field& spectrum : spectra_) values += spectrum.size();
  return values * sizeof(double);
}

Field traction_stress(const Grid& grid, const SharedMedium& medium, const Heating& heating,
                      std::span<const double> depths, const Tractions& tractions) {
  const VolumeTransform transform(grid, Symmetry::none);
  const auto heat = heating.is_on()
                        ? std::make_shared<const HeatStress>(grid, heat_of(*medium), heating)
                        : nullptr;
  const std::size_t plane = grid.surface_size();
  std::array<Field, all_tractions.size()> loads;
  for (const Traction kind : all_tractions) {
    const Field& field = tractions.of(kind);
    if (!field.empty()) loads[static_cast<int>(kind)] = transform.forward(field.data());
  }
  Field stress(6 * depths.size() * plane), layer(6 * plane);
  // One depth at a time: the kernels of a depth are used once, so only one set is kept.
  for (std::size_t d = 0; d < depths.size(); ++d) {
    VolumeSpectrum spectrum(transform, 1, Tensor::full);
    const TractionStress at(grid, transform, medium, heat, {depths[d]}, Tensor::full);
    for (const Traction kind : all_tractions) {
      const Field& load = loads[static_cast<int>(kind)];
      if (!load.empty()) at.add(kind, load, 1.0, spectrum, nullptr);
    }
    inverse(transform, spectrum, layer.data());
    for (int c = 0; c < 6; ++c) {
      std::copy(layer.begin() + c * plane, layer.begin() + (c + 1) * plane,
                stress.begin() + (c * depths.size() + d) * plane);
    }
  }
  return stress;
}

}  // namespace samcontact::operators
