// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/heat_of_increment.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "samcontact/base/errors.hpp"
#include "samcontact/plasticity/return_mapping.hpp"

namespace samcontact::simulation {

using operators::Tensor;

namespace {

/// Calls use(index) for each cell of a box in order, the index being that of the cell in layers
/// [k][i][j] below the grid. Past heat is known there only: beside it that of the nearest cell is
/// taken.
template <class Use>
void for_cells(const Box& box, const Grid& grid, const Use& use) {
  for (int k = 0; k < box.nz; ++k) {
    for (int i = box.i0; i < box.i0 + box.nx; ++i) {
      const std::size_t row = static_cast<std::size_t>(k) * grid.nx + std::clamp(i, 0, grid.nx - 1);
      for (int j = box.j0; j < box.j0 + box.ny; ++j) {
        use(row * grid.ny + std::clamp(j, 0, grid.ny - 1));
      }
    }
  }
}

GivenHeat given_in(const Scene& scene, const Target& target, int body) {
  return {scene, body, target.past[body], target.duration, target.heating[body], target.slip_power};
}

}  // namespace

HeatOfIncrement::HeatOfIncrement(const Scene& scene, const Target& target,
                                 const std::array<double, 2>& offsets)
    : scene_(scene),
      target_(target),
      offsets_(offsets),
      given_{given_in(scene, target, 0), given_in(scene, target, 1)} {
  if (target.is_prescribed()) return;
  for (int b = 0; b < 2; ++b) {
    if (has_past(b)) displacement_.push_back(given_[b].displacement());
  }
}

void HeatOfIncrement::open(Field& gap) const {
  for (const Field& displacement : displacement_) {
    for (std::size_t i = 0; i < gap.size(); ++i) gap[i] += displacement[i];
  }
}

const Field& HeatOfIncrement::past_stress(int body, int layers) {
  const Grid& grid = scene_.grid;
  Field& stress = stress_[body];
  const std::size_t least = 6 * grid.surface_size() * layers;
  if (stress.size() < least) {
    stress = given_[body].stress(grid.z(std::max(layers, grid.nz)), offsets_[body]);
  }
  return stress;
}

void HeatOfIncrement::stress(int body, const Box& box, Tensor tensor, Field& sum) {
  if (!has_past(body)) return;
  const Field& stress = past_stress(body, box.nz);
  const std::size_t cells = stress.size() / 6;
  Field out(operators::count(tensor) * box.volume_size());
  double* to = out.data();
  for (const int c : operators::components(tensor)) {
    const bool deviator = tensor == Tensor::deviator && c < 3;
    for_cells(box, scene_.grid, [&](std::size_t n) {
      const double mean = (stress[n] + stress[cells + n] + stress[2 * cells + n]) / 3;
      *to++ = stress[c * cells + n] - (deviator ? mean : 0.0);
    });
  }
  add_to(sum, std::move(out));
}

Box HeatOfIncrement::above(int body, const operators::Tractions& tractions,
                           operators::ResidualMethod method, const YieldLimit& limit) {
  const Box below = scene_.volume_below(tractions.pressure);
  const auto operators =
      scene_.volume(body, below, Tensor::full, method, fft::Symmetry::none, target_.heating[body]);
  const Field stress = operators->stress(nullptr, &tractions, operators::shear_sign(body));
  const Field& past = past_stress(body, below.nz);
  const std::size_t cells = below.volume_size(), stride = past.size() / 6;
  std::vector<LayerRange> layers;
  layers.reserve(below.nz);
  for (int k = 0; k < below.nz; ++k) layers.push_back({k, k, k + 1});
  const std::vector<LayerLimit> limits = limit.of(layers);
  Box found;
  for (std::size_t n = 0; n < cells; ++n) {
    plasticity::Tensor s;
    for (int c = 0; c < 6; ++c) s[c] = stress[c * cells + n] + past[c * stride + n];
    const auto& [least, start] = limits[n / below.surface_size()];
    s[0] += start[0];
    s[1] += start[1];
    s[2] -= start[0] + start[1];
    s[5] += start[2];
    if (plasticity::von_mises(s) <= least) continue;
    const int j = static_cast<int>(n % below.ny), i = static_cast<int>(n / below.ny % below.nx);
    const int k = static_cast<int>(n / below.ny / below.nx);
    found = found.united({i, j, 1, 1, k + 1});
  }
  return found;
}

std::shared_ptr<const BoxField> HeatOfIncrement::softening(int body, const Softening& law,
                                                           const Field& pressure,
                                                           const Box& box) const {
  if (!law) return nullptr;
  const Grid& grid = scene_.grid;
  const auto depths = grid.z(box.nz);
  const auto operators = scene_.temperature(target_.heating[body], box);
  Field rise = operators->rise(window({pressure, {}, {}}, grid, box).pressure.data(), depths);
  if (has_past(body)) {
    const Field more = given_[body].temperature(depths, offsets_[body]);
    double* to = rise.data();
    for_cells(box, grid, [&](std::size_t n) { *to++ += more[n]; });
  }
  const std::string name = "softening of body " + std::to_string(body + 1);
  Field factor = law(rise, box);
  require(factor.size() == rise.size(), name, "a value for each cell of the grid",
          static_cast<double>(factor.size()));
  for (const double f : factor) require(f > 0 && f <= 1, name, "in (0, 1]", f);
  if (*std::min_element(factor.begin(), factor.end()) == 1) return nullptr;
  return std::make_shared<const BoxField>(BoxField{box, std::move(factor)});
}

}  // namespace samcontact::simulation
