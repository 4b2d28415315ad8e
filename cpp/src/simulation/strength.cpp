// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/strength.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/deviator.hpp"
#include "samcontact/base/errors.hpp"

namespace samcontact::simulation {
namespace {

/// Layers that can be counted.
constexpr double most_layers = 1e6;
/// A change of strength that asks for a look of its own, a part of the yield stress; at most so
/// many looks.
constexpr double smallest_step = 0.05, most_steps = 40.0;

double von_mises(const std::array<double, 3>& s) {
  return std::sqrt(3 * second_invariant(s[0], s[1], 0.0, 0.0, s[2]));
}

/// Depths at which a profile of the material has a kink.
std::vector<double> kinks(const plasticity::Material& material) {
  std::vector<double> depths;
  const auto add = [&](const OverDepth& profile) {
    depths.insert(depths.end(), profile.depth.begin(), profile.depth.end());
  };
  if (material.yield_profile) add(*material.yield_profile);
  if (material.initial_stress) add(material.initial_stress->xx);
  std::sort(depths.begin(), depths.end());
  depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
  return depths;
}

}  // namespace

Strength::Strength(const plasticity::Material& material, double dz) : material_(material), dz_(dz) {
  const auto& profile = material.yield_profile;
  const auto& stress = material.initial_stress;
  if (!profile && !stress) return;
  OverDepth variation{kinks(material), {0.0}};
  const double deepest = variation.depth.back();
  require(!(dz > 0) || deepest <= most_layers * dz,
          "the deepest z of a yield profile or residual stress",
          "at most " + to_text(most_layers * dz) + " m, " + to_text(most_layers) + " layers of dz",
          deepest);
  const double yield_stress = material.is_plastic() ? material.smallest_yield_stress() : 1.0;
  for (std::size_t n = 1; n < variation.depth.size(); ++n) {
    const double above = variation.depth[n - 1], below = variation.depth[n];
    double change = profile ? std::fabs(profile->at(below) - profile->at(above)) /
                                  std::max(profile->at(below), profile->at(above))
                            : 0.0;
    if (stress) {
      const auto of = [&](const OverDepth& s) { return s.at(below) - s.at(above); };
      const double x = of(stress->xx), y = of(stress->yy), mean = (x + y) / 3;
      change += von_mises({x - mean, y - mean, of(stress->xy)}) / yield_stress;
    }
    variation.value.push_back(variation.value.back() + change);
  }
  if (variation.value.back() == 0) return;
  layers_ = dz > 0 ? static_cast<int>(std::ceil(deepest / dz)) : 0;
  variation_ = std::move(variation);
}

bool Strength::differs(int above, int below) const {
  if (!variation_) return false;
  const double step = std::max(smallest_step, variation_->value.back() / most_steps);
  return variation_->at(mid_depth(below)) - variation_->at(mid_depth(above)) > step;
}

double Strength::factor(int k) const {
  return material_.yield_profile ? material_.yield_profile->at(mid_depth(k)) : 1.0;
}

std::array<double, 3> Strength::start(int k) const {
  if (!material_.initial_stress) return {};
  const auto& stress = *material_.initial_stress;
  const double z = mid_depth(k), x = stress.xx.at(z), y = stress.yy.at(z), mean = (x + y) / 3;
  return {x - mean, y - mean, stress.xy.at(z)};
}

Field Strength::factor(const Box& box) const {
  if (!material_.yield_profile) return {};
  Field out;
  out.reserve(box.volume_size());
  for (int k = 0; k < box.nz; ++k) out.insert(out.end(), box.surface_size(), factor(k));
  return out;
}

void Strength::add_stress(const Box& box, operators::Tensor tensor, Field& sum) const {
  if (!material_.initial_stress || box.empty()) return;
  const auto& stress = *material_.initial_stress;
  const bool deviator = tensor == operators::Tensor::deviator;
  const auto places = operators::components(tensor);
  sum.resize(places.size() * box.volume_size(), 0.0);
  double* to = sum.data();
  for (const int c : places) {
    for (int k = 0; k < box.nz; ++k) {
      const double z = mid_depth(k), x = stress.xx.at(z), y = stress.yy.at(z);
      const double mean = deviator ? (x + y) / 3 : 0.0;
      const std::array<double, 6> at{x - mean, y - mean, -mean, 0.0, 0.0, stress.xy.at(z)};
      for (std::size_t n = 0; n < box.surface_size(); ++n) *to++ += at[c];
    }
  }
}

std::vector<LayerLimit> Strength::limits(const std::vector<LayerRange>& ranges, double softening,
                                         double share) const {
  const double yield_stress = share * softening * material_.hardening.yield_stress(0.0);
  std::vector<LayerLimit> limits;
  limits.reserve(ranges.size());
  for (const auto& [layer, first, end] : ranges) {
    LayerLimit limit{yield_stress * factor(layer), start(layer)};
    // Further down they are alike.
    for (int k = first; k < std::min(end, layers_ + 1); ++k) {
      auto other = start(k);
      for (int c = 0; c < 3; ++c) other[c] = share * (other[c] - limit.start[c]);
      limit.stress = std::min(limit.stress, yield_stress * factor(k) - von_mises(other));
    }
    for (double& s : limit.start) s *= share;
    limits.push_back(limit);
  }
  return limits;
}

}  // namespace samcontact::simulation
