// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/plastic_increment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "samcontact/base/reduce.hpp"
#include "samcontact/plasticity/return_mapping.hpp"

namespace samcontact::simulation {

PlasticIncrement::PlasticIncrement(const State& from, const Target& target, Counters& counters)
    : from_(from),
      target_(target),
      counters_(counters),
      scene_(from.scene()),
      cells_(scene_.grid.volume_size()),
      body_size_(6 * cells_),
      tractions_(target.kind == Target::Kind::tractions
                     ? target.tractions
                     : operators::Tractions{from.tractions.pressure, {}, {}}) {
  for (int b = 0; b < 2; ++b) {
    if (!scene_.materials[b].is_plastic()) continue;
    bodies_.push_back(b);
    spectra_.emplace_back(scene_.volumes[b]->transform(), scene_.grid.nz);
  }
  if (!bodies_.empty()) {
    equivalent_.resize(bodies_.size() * cells_);
    strain_.resize(body_size_);
    stress_.resize(body_size_);
  }
}

void PlasticIncrement::residual_fields(int body, const double* guess, Field& gap,
                                       operators::VolumeSpectrum& spectrum) {
  const auto& operators = *scene_.volumes[body];
  std::copy(guess, guess + body_size_, strain_.begin());
  if (from_.plastic[body]) {
    const Field& before = from_.plastic[body]->strain;
    for (std::size_t i = 0; i < body_size_; ++i) strain_[i] += before[i];
  }
  operators::forward(operators.transform(), strain_.data(), spectrum);
  if (std::none_of(spectrum.used.begin(), spectrum.used.end(), [](char u) { return u; })) {
    std::fill(spectrum.data.begin(), spectrum.data.end(), Complex{});
    return;
  }
  if (target_.kind != Target::Kind::tractions) {
    Field displacement(scene_.grid.surface_size());
    operators.residual_displacement().apply(spectrum, displacement.data());
    for (std::size_t i = 0; i < gap.size(); ++i) gap[i] += displacement[i];
  }
  operators.residual_stress().apply(spectrum);
}

contact::Solution PlasticIncrement::solve_contact(const Field& gap, double tol) {
  contact::Solution solution;
  if (target_.kind == Target::Kind::tractions) {
    solution.pressure = target_.tractions.pressure;
    solution.load = scene_.grid.cell_area() *
                    ordered_sum(gap.size(), [&](std::size_t i) { return solution.pressure[i]; });
    solution.approach = std::numeric_limits<double>::quiet_NaN();
    return solution;
  }
  const auto driver = target_.kind == Target::Kind::load ? contact::Driver::load(target_.value)
                                                         : contact::Driver::approach(target_.value);
  contact::ContactSettings settings;
  settings.tol = tol;
  // An iterate may be larger than the solution: the border is checked once, at the end.
  settings.on_border = contact::OnBorder::warn;
  solution = scene_.solver.solve(gap, driver, tractions_.pressure, settings);
  ++counters_.contact_solves;
  counters_.contact_iterations += solution.iterations;
  tractions_.pressure = solution.pressure;
  if (scene_.solver.friction() > 0) {
    tractions_.shear_x = solution.pressure;
    for (double& s : tractions_.shear_x) s *= scene_.solver.friction();
  }
  return solution;
}

void PlasticIncrement::return_map(int body, const double* guess, double* mapped, double* equivalent,
                                  Result& result) const {
  const auto& material = scene_.materials[body];
  const double shear_modulus = material.elastic.shear_modulus();
  const double* before = from_.plastic[body] ? from_.plastic[body]->equivalent.data() : nullptr;
  const std::ptrdiff_t n = cells_;
  double excess = 0.0, overshoot = 0.0;
  long flowing = 0;
#pragma omp parallel for schedule(static) reduction(max : excess, overshoot) reduction(+ : flowing)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    plasticity::Tensor s, e;
    for (int c = 0; c < 6; ++c) {
      s[c] = stress_[c * n + i];
      e[c] = guess[c * n + i];
    }
    const auto r = plasticity::radial_return(s, e, before ? before[i] : 0.0, shear_modulus,
                                             material.hardening);
    for (int c = 0; c < 6; ++c) mapped[c * n + i] = r.increment[c];
    equivalent[i] = r.equivalent;
    excess = std::max(excess, r.excess);
    overshoot = std::max(overshoot, r.overshoot);
    flowing += r.equivalent > 0;
  }
  result.excess = std::max(result.excess, excess);
  result.overshoot = std::max(result.overshoot, overshoot);
  const double yield_strain = material.hardening.yield_stress(0.0) / (3 * shear_modulus);
  result.yield_strain_norm =
      std::hypot(result.yield_strain_norm, yield_strain * std::sqrt(static_cast<double>(flowing)));
}

PlasticIncrement::Result PlasticIncrement::evaluate(const Field& guess, double contact_tol,
                                                    Field& mapped) {
  Field gap = scene_.initial_gap;
  for (std::size_t n = 0; n < bodies_.size(); ++n) {
    residual_fields(bodies_[n], guess.data() + n * body_size_, gap, spectra_[n]);
  }
  Result result;
  result.contact = solve_contact(gap, contact_tol);
  mapped.resize(size());
  for (std::size_t n = 0; n < bodies_.size(); ++n) {
    const int body = bodies_[n];
    const auto& operators = *scene_.volumes[body];
    operators.add_tractions(tractions_, body == 1 ? 1.0 : -1.0, spectra_[n]);
    operators::inverse(operators.transform(), spectra_[n], stress_.data());
    return_map(body, guess.data() + n * body_size_, mapped.data() + n * body_size_,
               equivalent_.data() + n * cells_, result);
  }
  return result;
}

State PlasticIncrement::finish(const Field& mapped, const Result& result) const {
  State state = from_;
  state.warnings.clear();
  state.tractions = tractions_;
  state.gap = result.contact.gap;
  state.load = result.contact.load;
  state.approach = result.contact.approach;
  for (std::size_t n = 0; n < bodies_.size(); ++n) {
    const double* increment = mapped.data() + n * body_size_;
    const double* equivalent = equivalent_.data() + n * cells_;
    if (std::none_of(equivalent, equivalent + cells_, [](double g) { return g > 0; })) continue;
    auto plastic = std::make_shared<PlasticState>();
    if (const auto& before = from_.plastic[bodies_[n]]) {
      *plastic = *before;
    } else {
      plastic->strain.assign(body_size_, 0.0);
      plastic->equivalent.assign(cells_, 0.0);
    }
    for (std::size_t i = 0; i < body_size_; ++i) plastic->strain[i] += increment[i];
    for (std::size_t i = 0; i < cells_; ++i) plastic->equivalent[i] += equivalent[i];
    state.plastic[bodies_[n]] = std::move(plastic);
  }
  return state;
}

}  // namespace samcontact::simulation
