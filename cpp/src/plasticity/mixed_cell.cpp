// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/plasticity/mixed_cell.hpp"

#include "samcontact/plasticity/two_phase_cell.hpp"

namespace samcontact::plasticity {
namespace {

/// Ratio of moduli above which cells are stiff, and their p relative to that of a sphere, with
/// which the iteration was found to take the fewest steps.
constexpr double stiff_ratio = 5.0, part_of_stiff = 0.6;

double mean_of(const Tensor& t) { return (t[0] + t[1] + t[2]) / 3; }

Tensor with_mean(Tensor t, double mean) {
  for (int c = 0; c < 3; ++c) t[c] += mean;
  return t;
}

Tensor sum_of_tensors(Tensor a, double factor, const Tensor& b) {
  for (int c = 0; c < 6; ++c) a[c] += factor * b[c];
  return a;
}

Tensor times(double factor, Tensor t) {
  for (double& v : t) v *= factor;
  return t;
}

}  // namespace

/// Materials that flow, their weight in the yield stress of the cell, and the share of the cell
/// that flows.
struct MixedLaw::Phases {
  const Material *first = nullptr, *second = nullptr;
  double first_weight = 1.0, second_weight = 0.0, share = 1.0;
};

MixedLaw::MixedLaw(const Material& matrix, bool strong) : matrix_(matrix), strong_(strong) {
  const double nu = matrix.elastic.nu, G = matrix.elastic.shear_modulus();
  bulk_modulus_ = 2 * G * (1 + nu) / (3 * (1 - 2 * nu));
  shear_modulus_ = G;
  // 3 K of the bulk part, finite for any nu after multiplication by its p.
  sphere_bulk_ = {2 * (1 - 2 * nu) / (3 * (1 - nu)), 4 * G * (1 + nu) / (3 * (1 - nu))};
  const double p = (7 - 5 * nu) / (15 * (1 - nu));
  sphere_shear_ = {p, 2 * G * p};
}

MixedLaw::Kept MixedLaw::kept(const Kept& sphere, double ratio) const {
  if (ratio == 1 || (ratio <= stiff_ratio && !strong_)) return sphere;
  const double p = ratio < 1 ? 1.0 : part_of_stiff * sphere.part;
  return {p, p / sphere.part * sphere.stiffness};
}

MixedLaw::Phases MixedLaw::phases(const MixedCell& cell, const Material* inclusion) const {
  const bool own = inclusion != nullptr && inclusion->is_plastic();
  const double left = 1 - cell.share;
  const Material* const rest = left > 0 && matrix_.is_plastic() ? &matrix_ : nullptr;
  if (inclusion == nullptr) return {.first = rest, .first_weight = left};
  if (own && rest != nullptr) return {rest, inclusion, left, cell.share};
  if (own) return {.first = inclusion, .share = cell.share};
  return {.first = rest, .share = left};
}

MixedReturn MixedLaw::step_of_two(const MixedCell& cell, const Material* inclusion,
                                  const Tensor& stress, const Tensor& eigenstrain,
                                  const MixedHistory& before) const {
  const auto law_of = [](const Material* material) {
    return material != nullptr && material->is_plastic() ? &material->hardening : nullptr;
  };
  const Kept bulk = kept(sphere_bulk_, cell.bulk), shear = kept(sphere_shear_, cell.shear);
  const double sm = mean_of(stress), em = mean_of(eigenstrain);
  const Tensor s = with_mean(stress, -sm), e = with_mean(eigenstrain, -em);
  const Tensor t = with_mean(sum_of_tensors(s, shear.stiffness, e), sm + bulk.stiffness * em);
  const double compliance = 1 / (2 * shear_modulus_), mean_compliance = 1 / (3 * bulk_modulus_);
  const auto elastic = [&](const Tensor& of) {
    const double mean = mean_of(of);
    return with_mean(times(compliance, with_mean(of, -mean)), mean_compliance * mean);
  };
  const std::array<Phase, 2> both{
      Phase{bulk_modulus_, shear_modulus_, law_of(&matrix_), before.strength, before.matrix_plastic,
            before.equivalent},
      Phase{cell.bulk * bulk_modulus_, cell.shear * shear_modulus_, law_of(inclusion), 1.0,
            sum_of_tensors(cell.misfit, 1.0, before.plastic), before.inclusion_equivalent}};
  const TwoPhaseStep r = two_phase_step(both, cell.share, cell.normal, {bulk.part, shear.part}, t,
                                        sum_of_tensors(elastic(stress), 1.0, eigenstrain));
  MixedReturn result;
  result.eigenstrain = sum_of_tensors(r.strain, -1.0, elastic(r.stress));
  result.matrix_plastic = result.flow = r.plastic[0];
  result.plastic = r.plastic[1];
  result.equivalent = r.equivalent[0];
  result.inclusion_equivalent = r.equivalent[1];
  result.overshoot = r.overshoot;
  if (r.equivalent[0] > 0 && r.equivalent[1] == 0) {
    result.excess = von_mises(sum_of_tensors(stress, -1.0, r.stress)) /
                    matrix_.hardening.yield_stress(before.equivalent);
  }
  return result;
}

MixedReturn MixedLaw::step(const MixedCell& cell, const Material* inclusion, const Tensor& stress,
                           const Tensor& eigenstrain, const MixedHistory& before) const {
  if (cell.has_two_phases()) return step_of_two(cell, inclusion, stress, eigenstrain, before);
  const Kept bulk = kept(sphere_bulk_, cell.bulk), shear = kept(sphere_shear_, cell.shear);
  const double sm = mean_of(stress), em = mean_of(eigenstrain), misfit = mean_of(cell.misfit);
  const Tensor s = with_mean(stress, -sm);
  const double tm = sm + bulk.stiffness * em;
  const Tensor t = sum_of_tensors(s, shear.stiffness, with_mean(eigenstrain, -em));
  const double new_sm =
      (tm - bulk.stiffness * misfit) * cell.bulk / ((1 - bulk.part) * cell.bulk + bulk.part);
  const double ratio = cell.shear / ((1 - shear.part) * cell.shear + shear.part);
  Tensor inelastic = with_mean(cell.misfit, -misfit);
  inelastic = sum_of_tensors(inelastic, 1.0, before.plastic);
  const Tensor trial = times(ratio, sum_of_tensors(t, -shear.stiffness, inelastic));
  MixedReturn result;
  Tensor new_s = trial;
  const Phases flowing = phases(cell, inclusion);
  if (flowing.first != nullptr && ratio > 0) {
    // Phases in parallel share the stress: that of the first one is the stress over its weight.
    const double stiffness = shear.stiffness * ratio * flowing.share;
    const bool both = flowing.second != nullptr;
    const double weight = both ? 1.0 : flowing.first_weight;
    const double G = 0.5 * stiffness / weight;
    const Tensor estimate = times(1 / stiffness, sum_of_tensors(trial, -1.0, s));
    const bool of_matrix = flowing.first == &matrix_;
    const double strength = of_matrix ? before.strength : 1.0;
    const auto backstresses = of_matrix ? before.backstresses : std::span<const Tensor>{};
    const Return r = both ? radial_return(s, estimate, before.equivalent, G,
                                          {{{*flowing.first, strength * flowing.first_weight},
                                            {*flowing.second, flowing.second_weight}}})
                          : radial_return(times(1 / weight, s), estimate, before.equivalent, G,
                                          *flowing.first, backstresses, strength);
    result.flow = r.increment;
    result.plastic = times(flowing.share, r.increment);
    result.equivalent = r.equivalent;
    // Relative to the yield stress of the whole phase: a nearly empty cell has hardly any strength.
    result.excess = weight * r.excess;
    result.overshoot = r.overshoot;
    new_s = sum_of_tensors(trial, -shear.stiffness * ratio, result.plastic);
  }
  result.eigenstrain = with_mean(times(1 / shear.stiffness, sum_of_tensors(t, -1.0, new_s)),
                                 (tm - new_sm) / bulk.stiffness);
  return result;
}

}  // namespace samcontact::plasticity
