// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/sources/heat_source.hpp"

#include <algorithm>
#include <utility>

namespace samcontact::simulation {

using operators::Tensor;

namespace {

/// Number of surface cells up to which the stress at all depths of the search for yield is stored.
constexpr std::size_t small_surface = 200'000;

/// Copies one component of a tensor, from all six, `plane` numbers each.
void put_component(const double* stress, std::size_t plane, int component, Tensor tensor,
                   double* to) {
  const bool deviator = tensor == Tensor::deviator && component < 3;
  for (std::size_t n = 0; n < plane; ++n) {
    const double mean = (stress[n] + stress[plane + n] + stress[2 * plane + n]) / 3;
    to[n] = stress[component * plane + n] - (deviator ? mean : 0.0);
  }
}

}  // namespace

void HeatSource::displace(int body, Field& sum) const {
  if (!acts_on(body)) return;
  Field& displacement = displacement_[body];
  if (displacement.empty()) displacement = heat_[body].displacement();
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += displacement[i];
}

void HeatSource::find_stress(int body, std::span<const double> depths, ByDepth& known) const {
  std::vector<double> missing;
  for (const double z : depths) {
    if (!known.contains(z)) missing.push_back(z);
  }
  if (missing.empty()) return;
  const std::size_t plane = grid_.surface_size();
  const Field found = heat_[body].stress(missing, offsets_[body]);
  for (std::size_t d = 0; d < missing.size(); ++d) {
    Field& here = known[missing[d]];
    here.resize(6 * plane);
    for (std::size_t c = 0; c < 6; ++c) {
      std::copy_n(found.data() + (c * missing.size() + d) * plane, plane, here.data() + c * plane);
    }
  }
}

void HeatSource::stress(int body, const Box& box, Tensor tensor, Field& sum) const {
  if (!acts_on(body)) return;
  const std::vector<double> depths = grid_.z(box.nz);
  find_stress(body, depths, stress_[body]);
  const Box layer = box.layer();
  const std::size_t plane = layer.surface_size();
  Field out(operators::count(tensor) * box.volume_size());
  for (int k = 0; k < box.layers(); ++k) {
    const Field here = below_in(stress_[body].at(depths[box.k0 + k]), 6, grid_, layer);
    double* to = out.data() + k * plane;
    for (const int c : operators::components(tensor)) {
      put_component(here.data(), plane, c, tensor, to);
      to += box.volume_size();
    }
  }
  add_to(sum, std::move(out));
}

operators::DeviatorAt HeatSource::deviator(int body) const {
  if (!acts_on(body)) return {};
  return [this, body](std::span<const double> depths) {
    const std::size_t plane = grid_.surface_size();
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

}  // namespace samcontact::simulation
