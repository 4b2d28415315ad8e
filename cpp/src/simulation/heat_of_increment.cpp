// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/heat_of_increment.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "samcontact/base/errors.hpp"
#include "samcontact/plasticity/return_mapping.hpp"

namespace samcontact::simulation {

using operators::Tensor;

HeatOfIncrement::HeatOfIncrement(const Scene& scene, const Target& target)
    : scene_(scene), target_(target) {
  if (target.is_prescribed()) return;
  for (int b = 0; b < 2; ++b) {
    if (has_past(b)) {
      displacement_.push_back(target.past[b]->displacement(target.duration));
    }
  }
}

void HeatOfIncrement::open(Field& gap) const {
  for (const Field& displacement : displacement_) {
    for (std::size_t i = 0; i < gap.size(); ++i) gap[i] += displacement[i];
  }
}

const Field& HeatOfIncrement::past_stress(int body) {
  Field& stress = stress_[body];
  if (stress.empty()) {
    stress = target_.past[body]->stress(target_.duration, scene_.grid.z());
  }
  return stress;
}

void HeatOfIncrement::stress(int body, const Box& box, Tensor tensor, Field& sum) {
  if (!has_past(body)) return;
  const Field& stress = past_stress(body);
  const Box whole = Box::whole(scene_.grid);
  const std::size_t cells = whole.volume_size(), boxed = box.volume_size();
  Field out(operators::count(tensor) * boxed), component(cells);
  double* to = out.data();
  for (const int c : operators::components(tensor)) {
    const bool deviator = tensor == Tensor::deviator && c < 3;
    for (std::size_t n = 0; n < cells; ++n) {
      const double mean = (stress[n] + stress[cells + n] + stress[2 * cells + n]) / 3;
      component[n] = stress[c * cells + n] - (deviator ? mean : 0.0);
    }
    extract(component.data(), whole, to, box);
    to += boxed;
  }
  add_to(sum, std::move(out));
}

Box HeatOfIncrement::above(int body, const operators::Tractions& tractions,
                           operators::ResidualMethod method, double limit) {
  const Box whole = Box::whole(scene_.grid);
  const auto operators =
      scene_.volume(body, whole, Tensor::full, method, fft::Symmetry::none, target_.heating[body]);
  const Field stress = operators->stress(nullptr, &tractions, operators::shear_sign(body));
  const Field& past = past_stress(body);
  const std::size_t cells = whole.volume_size();
  Box found;
  for (std::size_t n = 0; n < cells; ++n) {
    plasticity::Tensor s;
    for (int c = 0; c < 6; ++c) s[c] = stress[c * cells + n] + past[c * cells + n];
    if (plasticity::von_mises(s) <= limit) continue;
    const int j = static_cast<int>(n % whole.ny), i = static_cast<int>(n / whole.ny % whole.nx);
    const int k = static_cast<int>(n / whole.ny / whole.nx);
    found = found.united({i, j, 1, 1, k + 1});
  }
  return found;
}

std::shared_ptr<const Field> HeatOfIncrement::softening(int body, const Softening& law,
                                                        const Field& pressure) const {
  if (!law) return nullptr;
  const auto& heat = target_.heating[body];
  Field rise = scene_.temperature(heat)->rise(pressure.data());
  if (has_past(body)) {
    const Field more = target_.past[body]->temperature(target_.duration, scene_.grid.z());
    for (std::size_t n = 0; n < rise.size(); ++n) rise[n] += more[n];
  }
  const std::string name = "softening of body " + std::to_string(body + 1);
  Field factor = law(rise);
  require(factor.size() == rise.size(), name, "a value for each cell of the grid",
          static_cast<double>(factor.size()));
  for (const double f : factor) require(f > 0 && f <= 1, name, "in (0, 1]", f);
  if (*std::min_element(factor.begin(), factor.end()) == 1) return nullptr;
  return std::make_shared<const Field>(std::move(factor));
}

}  // namespace samcontact::simulation
