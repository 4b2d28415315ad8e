// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/heat_of_increment.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "samcontact/base/errors.hpp"

namespace samcontact::simulation {

using operators::Tensor;

namespace {

/// Cells of a surface up to which stress at all depths is kept that yield is looked for at.
constexpr std::size_t small_surface = 200'000;

/// To a component of a tensor, from all six, `plane` numbers each.
void put_component(const double* stress, std::size_t plane, int component, Tensor tensor,
                   double* to) {
  const bool deviator = tensor == Tensor::deviator && component < 3;
  for (std::size_t n = 0; n < plane; ++n) {
    const double mean = (stress[n] + stress[plane + n] + stress[2 * plane + n]) / 3;
    to[n] = stress[component * plane + n] - (deviator ? mean : 0.0);
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

void HeatOfIncrement::find_stress(int body, std::span<const double> depths, ByDepth& known) const {
  std::vector<double> missing;
  for (const double z : depths) {
    if (!known.contains(z)) missing.push_back(z);
  }
  if (missing.empty()) return;
  const std::size_t plane = scene_.grid.surface_size();
  const Field found = given_[body].stress(missing, offsets_[body]);
  for (std::size_t d = 0; d < missing.size(); ++d) {
    Field& here = known[missing[d]];
    here.resize(6 * plane);
    for (std::size_t c = 0; c < 6; ++c) {
      std::copy_n(found.data() + (c * missing.size() + d) * plane, plane, here.data() + c * plane);
    }
  }
}

void HeatOfIncrement::stress(int body, const Box& box, Tensor tensor, Field& sum) {
  if (!has_past(body)) return;
  const std::vector<double> depths = scene_.grid.z(box.nz);
  find_stress(body, depths, stress_[body]);
  Box layer = box;
  layer.nz = 1;
  const std::size_t plane = layer.surface_size();
  Field out(operators::count(tensor) * box.volume_size());
  for (int k = 0; k < box.nz; ++k) {
    const Field here = below_in(stress_[body].at(depths[k]), 6, scene_.grid, layer);
    double* to = out.data() + k * plane;
    for (const int c : operators::components(tensor)) {
      put_component(here.data(), plane, c, tensor, to);
      to += box.volume_size();
    }
  }
  add_to(sum, std::move(out));
}

operators::DeviatorAt HeatOfIncrement::deviator(int body) const {
  if (!has_past(body)) return {};
  return [this, body](std::span<const double> depths) {
    const std::size_t plane = scene_.grid.surface_size();
    ByDepth passing;
    ByDepth& known = plane > small_surface ? passing : stress_[body];
    find_stress(body, depths, known);
    Field out(5 * depths.size() * plane);
    double* to = out.data();
    for (const int c : operators::components(Tensor::deviator)) {
      for (const double z : depths) {
        put_component(known.at(z).data(), plane, c, Tensor::deviator, to);
        to += plane;
      }
    }
    return out;
  };
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
    const Field more = below_in(given_[body].temperature(depths, offsets_[body]), 1, grid, box);
    for (std::size_t n = 0; n < rise.size(); ++n) rise[n] += more[n];
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
