// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/strain/outside_strain.hpp"

#include <algorithm>

#include "samcontact/operators/zones/zone_operators.hpp"
#include "samcontact/simulation/strain/acting_strain.hpp"

namespace samcontact::simulation {
namespace {

/// Strain over some zones, 0 in others.
Field strain_without(const PlasticState& history, const Zones& over, const Zones& others) {
  Field strain = history.strain(over);
  const Field nothing(others.cells(), 0.0);
  for (int c = 0; c < operators::count(history.tensor()); ++c) {
    copy_common(nothing.data(), others, strain.data() + c * over.cells(), over);
  }
  return strain;
}

}  // namespace

OutsideStrain outside_strain(const Setup& setup, int body, const PlasticState& history,
                             const Zones& zones, operators::ResidualMethod method,
                             std::span<const operators::Axis> axes) {
  if (!history.reaches_beyond(zones)) return {};
  const Grid& grid = setup.grid;
  const fft::Symmetry symmetry = history.symmetry();
  const Box part = stored_part(grid, symmetry);
  const Box around =
      acting_box(history, Box{part.i0, part.j0, part.nx, 1, 1}.united(zones.around()), setup.reach);
  const Field strain = strain_without(history, Zones({around}), zones);
  const int components = operators::count(history.tensor());
  if (std::all_of(strain.begin(), strain.end(), [](double v) { return v == 0; })) return {};

  const auto operators = setup.cache.volume(body, whole_box(around, grid, symmetry),
                                            history.tensor(), method, symmetry, {});
  operators::VolumeSpectrum spectrum = operators->make_spectrum();
  operators::forward(operators->transform(), strain.data(), spectrum);
  OutsideStrain out;
  out.surface = {part.i0, around.j0, part.nx, around.ny, 1};
  Box surface = around;
  surface.nz = 1;
  Field displacement(around.surface_size());
  for (const operators::Axis axis : axes) {
    operators->residual_displacement(axis).apply(spectrum, displacement.data());
    Field& of_axis = out.displacement[static_cast<int>(axis)];
    of_axis.resize(out.surface.surface_size());
    extract(displacement.data(), surface, of_axis.data(), out.surface);
  }
  if (zones.empty()) return out;

  out.stress.resize(zones.count());
  for (std::size_t zone = 0; zone < zones.count(); ++zone) {
    out.stress[zone].resize(components * zones.boxes()[zone].volume_size());
  }
  operators->for_each_layer(spectrum, strain.data(), nullptr, 1.0, [&](int k, const double* s) {
    for (std::size_t zone = 0; zone < zones.count(); ++zone) {
      const Box& box = zones.boxes()[zone];
      if (k < box.k0 || k >= box.nz) continue;
      for (int c = 0; c < components; ++c) {
        extract(s + c * surface.surface_size(), surface,
                out.stress[zone].data() + (c * box.layers() + k - box.k0) * box.surface_size(),
                box.layer());
      }
    }
  });
  return out;
}

OutsideStrain outside_strain_in_zones(const std::shared_ptr<const operators::ZoneTables>& tables,
                                      const PlasticState& history, const Zones& zones, int reach,
                                      std::span<const operators::Axis> axes) {
  const Zones all = acting_zones(history, zones, *tables, reach);
  if (all == zones) return {};
  operators::ZoneOperators operators(tables, all.boxes());
  const Field strain = strain_without(history, all, zones);
  operators.transform(strain, axes);
  OutsideStrain out;
  out.surface = Box::surface(tables->grid());
  for (const operators::Axis axis : axes) {
    Field& of_axis = out.displacement[static_cast<int>(axis)];
    of_axis.resize(out.surface.surface_size());
    operators.displacement(axis, of_axis.data());
  }
  const int components = operators::count(history.tensor());
  for (const Box& box : zones.boxes()) out.stress.emplace_back(components * box.volume_size());
  operators.for_each_layer(&strain, {}, 1.0, [&](std::size_t from, int k, const double* stress) {
    Box layer = all.boxes()[from];
    layer.nz = 1;
    for (std::size_t zone = 0; zone < zones.count(); ++zone) {
      Box to = zones.boxes()[zone];
      if (k >= to.nz) continue;
      double* first = out.stress[zone].data() + k * to.surface_size();
      const std::size_t cells = to.volume_size();
      to.nz = 1;
      for (int c = 0; c < components; ++c) {
        copy_common(stress + c * layer.surface_size(), layer, first + c * cells, to);
      }
    }
  });
  return out;
}

}  // namespace samcontact::simulation
