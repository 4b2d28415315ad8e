// SPDX-License-Identifier: GPL-3.0-or-later
// What heat does to an increment: the yield stress falls with the temperature, and heat of earlier
// steps stresses the body.
#include <algorithm>
#include <string>
#include <utility>

#include "samcontact/base/errors.hpp"
#include "samcontact/plasticity/return_mapping.hpp"
#include "samcontact/simulation/plastic_increment.hpp"

namespace samcontact::simulation {

using operators::Tensor;

void PlasticIncrement::soften() {
  if (softened_) return;
  softened_ = true;
  for (Body& body : bodies_) {
    const Softening& law = settings_.softening[body.index];
    if (!law) continue;
    const auto& heat = target_.heating[body.index];
    Field rise = scene_.temperature(heat)->rise(tractions_.pressure.data());
    if (const auto& past = target_.past[body.index]) {
      const Field more = past->temperature(heat.time, scene_.grid.z());
      for (std::size_t n = 0; n < rise.size(); ++n) rise[n] += more[n];
    }
    const std::string name = "softening of body " + std::to_string(body.index + 1);
    Field factor = law(rise);
    require(factor.size() == rise.size(), name, "a value for each cell of the grid",
            static_cast<double>(factor.size()));
    for (const double f : factor) require(f > 0 && f <= 1, name, "in (0, 1]", f);
    body.weakest = *std::min_element(factor.begin(), factor.end());
    if (body.weakest < 1) body.softening = std::make_shared<const Field>(std::move(factor));
  }
}

const Field& PlasticIncrement::past_stress(int body) {
  Field& stress = past_stress_[body];
  if (stress.empty()) {
    stress = target_.past[body]->stress(target_.heating[body].time, scene_.grid.z());
  }
  return stress;
}

void PlasticIncrement::set_past_stress(Body& body) {
  if (!target_.past[body.index]) return;
  const Field& stress = past_stress(body.index);
  const Box &box = body.box, whole = Box::whole(scene_.grid);
  const std::size_t cells = whole.volume_size();
  const bool deviator = body.tensor == Tensor::deviator;
  body.past_stress.clear();
  Field component(cells), part(box.volume_size());
  for (const int c : operators::components(body.tensor)) {
    for (std::size_t n = 0; n < cells; ++n) {
      const double mean = (stress[n] + stress[cells + n] + stress[2 * cells + n]) / 3;
      component[n] = stress[c * cells + n] - (deviator && c < 3 ? mean : 0.0);
    }
    extract(component.data(), whole, part.data(), box);
    body.past_stress.insert(body.past_stress.end(), part.begin(), part.end());
  }
}

Box PlasticIncrement::near_yield_with_past(const Body& body, double limit) {
  const auto& heat = target_.heating[body.index];
  const Box whole = Box::whole(scene_.grid);
  const auto operators =
      scene_.volume(body.index, whole, Tensor::full, from_.method, fft::Symmetry::none, heat);
  Field stress = operators->stress(nullptr, &tractions_, body.index == 1 ? 1.0 : -1.0);
  const Field& past = past_stress(body.index);
  const std::size_t cells = whole.volume_size();
  Box near;
  for (std::size_t n = 0; n < cells; ++n) {
    plasticity::Tensor s;
    for (int c = 0; c < 6; ++c) s[c] = stress[c * cells + n] + past[c * cells + n];
    if (plasticity::von_mises(s) <= limit) continue;
    const int j = static_cast<int>(n % whole.ny), i = static_cast<int>(n / whole.ny % whole.nx);
    const int k = static_cast<int>(n / whole.ny / whole.nx);
    near = near.united({i, j, 1, 1, k + 1});
  }
  return near;
}

}  // namespace samcontact::simulation
