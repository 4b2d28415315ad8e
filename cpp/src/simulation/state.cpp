// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/state.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "samcontact/operators/surface_displacement.hpp"
#include "samcontact/plasticity/return_mapping.hpp"

namespace samcontact::simulation {
namespace {

/// scalar[i] = f(tensor of cell i).
template <class F>
Field reduce_tensor(const Field& tensor, const F& f) {
  const std::ptrdiff_t n = tensor.size() / 6;
  Field scalar(n);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    scalar[i] = f(plasticity::Tensor{tensor[i], tensor[n + i], tensor[2 * n + i], tensor[3 * n + i],
                                     tensor[4 * n + i], tensor[5 * n + i]});
  }
  return scalar;
}

}  // namespace

Scene::Scene(const Grid& grid_, const plasticity::Material& body1,
             const plasticity::Material& body2, Field initial_gap_, double friction)
    : grid(grid_),
      materials{body1, body2},
      initial_gap(std::move(initial_gap_)),
      solver(grid_, body1.elastic, body2.elastic, friction) {
  for (int b = 0; b < 2; ++b) {
    if (grid.nz == 0 || materials[b].elastic.is_rigid()) continue;
    if (b == 1 && volumes[0] && materials[0].elastic == materials[1].elastic) {
      volumes[1] = volumes[0];
    } else {
      volumes[b] = std::make_shared<operators::VolumeOperators>(grid, materials[b].elastic);
    }
  }
}

State::State(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {
  tractions.pressure.assign(scene_->grid.surface_size(), 0.0);
  approach = *std::min_element(scene_->initial_gap.begin(), scene_->initial_gap.end());
  gap = scene_->initial_gap;
  for (double& g : gap) g -= approach;
}

const operators::VolumeOperators& State::volume(int body) const {
  if (scene_->grid.nz == 0) {
    throw std::invalid_argument("nz is 0: fields below the surface need a grid with nz and dz");
  }
  if (!scene_->volumes[body]) {
    throw std::invalid_argument("body " + std::to_string(body + 1) +
                                " is rigid: it has no stress or strain");
  }
  return *scene_->volumes[body];
}

Field State::stress(int body) const {
  const auto& operators = volume(body);
  operators::VolumeSpectrum spectrum(operators.transform(), scene_->grid.nz);
  if (plastic[body]) {
    operators::forward(operators.transform(), plastic[body]->strain.data(), spectrum);
    operators.residual_stress().apply(spectrum);
  }
  operators.add_tractions(tractions, body == 1 ? 1.0 : -1.0, spectrum);
  Field out(6 * scene_->grid.volume_size());
  operators::inverse(operators.transform(), spectrum, out.data());
  return out;
}

Field State::residual_stress(int body) const {
  const auto& operators = volume(body);
  Field out(6 * scene_->grid.volume_size(), 0.0);
  if (!plastic[body]) return out;
  operators::VolumeSpectrum spectrum(operators.transform(), scene_->grid.nz);
  operators::forward(operators.transform(), plastic[body]->strain.data(), spectrum);
  operators.residual_stress().apply(spectrum);
  operators::inverse(operators.transform(), spectrum, out.data());
  return out;
}

Field State::von_mises(int body) const {
  return reduce_tensor(stress(body), plasticity::von_mises);
}

Field State::hydrostatic(int body) const {
  return reduce_tensor(stress(body),
                       [](const plasticity::Tensor& s) { return (s[0] + s[1] + s[2]) / 3; });
}

Field State::plastic_strain(int body) const {
  volume(body);
  return plastic[body] ? plastic[body]->strain : Field(6 * scene_->grid.volume_size(), 0.0);
}

Field State::equivalent_plastic_strain(int body) const {
  volume(body);
  return plastic[body] ? plastic[body]->equivalent : Field(scene_->grid.volume_size(), 0.0);
}

Field State::residual_displacement(int body) const {
  Field out(scene_->grid.surface_size(), 0.0);
  if (!plastic[body]) return out;
  const auto& operators = volume(body);
  operators::VolumeSpectrum spectrum(operators.transform(), scene_->grid.nz);
  operators::forward(operators.transform(), plastic[body]->strain.data(), spectrum);
  operators.residual_displacement().apply(spectrum, out.data());
  return out;
}

Field State::surface_displacement(int body) const {
  Field out = residual_displacement(body);
  const Elastic& elastic = scene_->materials[body].elastic;
  const auto pointer = [](const Field& f) { return f.empty() ? nullptr : f.data(); };
  const Field loaded = operators::surface_displacement(
      scene_->grid, elastic.normal_compliance(),
      (body == 1 ? 1.0 : -1.0) * elastic.coupling_compliance(), pointer(tractions.pressure),
      pointer(tractions.shear_x), pointer(tractions.shear_y));
  for (std::size_t i = 0; i < out.size(); ++i) out[i] += loaded[i];
  return out;
}

}  // namespace samcontact::simulation
