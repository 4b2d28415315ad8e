// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/strain/box_volume.hpp"

#include <algorithm>

#include "samcontact/simulation/cells/traction_window.hpp"

namespace samcontact::simulation {

namespace {

/// Reach in a box of the cells of a part of it; both are stored. Unlimited in layered bodies, where
/// each coefficient depends slightly on the number of offsets.
operators::Reach reach_in(const Setup& setup, int body, const Box& box, const Box& part,
                          fft::Symmetry symmetry) {
  if (setup.bodies[body].is_layered()) return {};
  const Grid& grid = setup.grid;
  const Box whole = whole_box(box, grid, symmetry),
            own = whole_box(from_planes_on(part, grid, symmetry), grid, symmetry);
  return {std::max(own.i0 + own.nx - whole.i0, whole.i0 + whole.nx - own.i0),
          std::max(own.j0 + own.ny - whole.j0, whole.j0 + whole.ny - own.j0)};
}

}  // namespace

Box nonzero_part(const Field& field, const Box& box) {
  Box part;
  const auto* value = field.data();
  for (std::size_t row = 0; row < field.size() / box.ny; ++row) {
    const int i = box.i0 + static_cast<int>(row % box.nx);
    for (int j = box.j0; j < box.j0 + box.ny; ++j) {
      if (*value++ != 0) part = part.united({i, j, 1, 1, box.nz, box.k0});
    }
  }
  return part;
}

BoxVolume::BoxVolume(const Setup& setup, int body, const Zones& zones, operators::Tensor tensor,
                     operators::ResidualMethod method, fft::Symmetry symmetry,
                     const operators::Heating& heating, const Box& needed)
    : grid_(setup.grid),
      zones_(zones),
      tensor_(tensor),
      box_(from_planes_on(zones.around(), setup.grid, symmetry)),
      surface_(box_.layer()),
      rows_{needed.i0 - box_.i0, needed.nx},
      first_(needed.k0 - box_.k0),
      operators_(setup.cache.volume(body, whole_box(box_, setup.grid, symmetry), tensor, method,
                                    symmetry, heating,
                                    reach_in(setup, body, box_, needed, symmetry))),
      spectrum_(operators_->make_spectrum()) {}

Field BoxVolume::spread(const Field& strain) const {
  const Zones whole({box_});
  const int components = operators::count(tensor_);
  Field out(components * whole.cells(), 0.0);
  for (int c = 0; c < components; ++c) {
    copy_common(strain.data() + c * zones_.cells(), zones_, out.data() + c * whole.cells(), whole);
  }
  return out;
}

void BoxVolume::transform(const Field& strain, std::span<const operators::Axis>) {
  if (is_one()) {
    operators::forward(operators_->transform(), strain.data(), spectrum_);
  } else {
    operators::forward(operators_->transform(), spread(strain).data(), spectrum_);
  }
}

void BoxVolume::displacement(operators::Axis axis, double* out) const {
  operators_->residual_displacement(axis).apply(spectrum_, out);
}

void BoxVolume::for_each_layer(bool strained, const Field& strain,
                               const operators::Tractions& tractions, double sign, const Use& use) {
  if (!strained) std::fill(spectrum_.data.begin(), spectrum_.data.end(), 0.0);
  const operators::Tractions here = window(tractions, grid_, box_);
  if (is_one()) {
    operators_->for_each_layer(
        spectrum_, strained ? strain.data() : nullptr, &here, sign,
        [&](int k, const double* stress) { use(0, k, stress); }, spectrum_.nz,
        [this](int) { return std::span<const fft::RowRun>(&rows_, 1); }, first_);
    return;
  }
  const Field spreaded = strained ? spread(strain) : Field{};
  const int components = operators::count(tensor_);
  operators_->for_each_layer(spectrum_, strained ? spreaded.data() : nullptr, &here, sign,
                             [&](int k, const double* stress) {
                               for (std::size_t zone = 0; zone < zones_.count(); ++zone) {
                                 const Box& own = zones_.boxes()[zone];
                                 const int at = box_.k0 + k;
                                 if (at < own.k0 || at >= own.nz) continue;
                                 const Box layer = own.layer();
                                 Field part(components * layer.surface_size());
                                 for (int c = 0; c < components; ++c) {
                                   extract(stress + c * surface_.surface_size(), surface_,
                                           part.data() + c * layer.surface_size(), layer);
                                 }
                                 use(zone, at - own.k0, part.data());
                               }
                             });
}

}  // namespace samcontact::simulation
