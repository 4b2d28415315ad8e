// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/outside_strain.hpp"

#include <algorithm>

namespace samcontact::simulation {

Box acting_box(const PlasticState& history, const Box& wanted, int reach) {
  const int step = std::max(8, (wanted.nx + 3) / 4);
  const auto beyond = [&](int cells) {
    return std::clamp((cells + step - 1) / step * step, 0, reach);
  };
  const Box& past = history.box();
  const int left = beyond(wanted.i0 - past.i0);
  const int right = beyond(past.i0 + past.nx - (wanted.i0 + wanted.nx));
  const Box long_box{wanted.i0 - left, past.j0, wanted.nx + left + right, past.ny, past.nz};
  return wanted.united(long_box);
}

OutsideStrain outside_strain(const Scene& scene, int body, const PlasticState& history,
                             const Zones& zones, operators::ResidualMethod method) {
  if (!history.reaches_beyond(zones)) return {};
  const Grid& grid = scene.grid;
  const fft::Symmetry symmetry = history.symmetry();
  const Box part = stored_part(grid, symmetry);
  const Box around =
      acting_box(history, Box{part.i0, part.j0, part.nx, 1, 1}.united(zones.around()), scene.reach);
  Field strain = history.strain(around);
  const std::size_t cells = around.volume_size();
  const int components = operators::count(history.tensor());
  const Field inside(zones.cells(), 0.0);
  for (int c = 0; c < components; ++c) {
    copy_common(inside.data(), zones, strain.data() + c * cells, Zones({around}));
  }
  if (std::all_of(strain.begin(), strain.end(), [](double v) { return v == 0; })) return {};

  const auto operators =
      scene.volume(body, whole_box(around, grid, symmetry), history.tensor(), method, symmetry, {});
  operators::VolumeSpectrum spectrum = operators->make_spectrum();
  operators::forward(operators->transform(), strain.data(), spectrum);
  OutsideStrain out;
  Field displacement(around.surface_size());
  operators->residual_displacement().apply(spectrum, displacement.data());
  out.surface = {part.i0, around.j0, part.nx, around.ny, 1};
  out.displacement.resize(out.surface.surface_size());
  Box surface = around;
  surface.nz = 1;
  extract(displacement.data(), surface, out.displacement.data(), out.surface);
  if (zones.empty()) return out;

  out.stress.resize(zones.count());
  for (std::size_t zone = 0; zone < zones.count(); ++zone) {
    out.stress[zone].resize(components * zones.boxes()[zone].volume_size());
  }
  operators->for_each_layer(spectrum, strain.data(), nullptr, 1.0, [&](int k, const double* s) {
    for (std::size_t zone = 0; zone < zones.count(); ++zone) {
      const Box& box = zones.boxes()[zone];
      if (k >= box.nz) continue;
      Box layer = box;
      layer.nz = 1;
      for (int c = 0; c < components; ++c) {
        extract(s + c * surface.surface_size(), surface,
                out.stress[zone].data() + (c * box.nz + k) * box.surface_size(), layer);
      }
    }
  });
  return out;
}

}  // namespace samcontact::simulation
