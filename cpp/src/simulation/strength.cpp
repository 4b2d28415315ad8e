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

/// What bears less than this part of what lies above is weak.
constexpr double weak = 0.9;

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

Strength::Strength(const plasticity::Material& material, const Grid& grid, const Relief& relief,
                   int first)
    : material_(material), relief_(relief), first_(first), ny_(grid.ny), dz_(grid.dz) {
  const double dz = dz_;
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
  if (dz > 0) {
    layers_ = static_cast<int>(std::ceil(deepest / dz));
    const auto most = std::max_element(relief.worn.begin(), relief.worn.end());
    const double worn = most == relief.worn.end() ? 0.0 : std::min(*most, deepest);
    worn_layers_ = static_cast<int>(std::ceil(worn / dz));
  }
  variation_ = std::move(variation);
  double most = 0.0;
  for (const double z : variation_->depth) {
    most = std::max(most, bearing_at(z));
    most_above_.depth.push_back(z);
    most_above_.value.push_back(most);
    weakens_ = weakens_ || is_weak_at(z);
  }
}

double Strength::bearing_at(double z) const {
  const double yield_stress = material_.hardening.yield_stress(0.0) * factor_at(z);
  const auto& stress = material_.initial_stress;
  return stress ? yield_stress - 0.5 * (stress->xx.at(z) + stress->yy.at(z)) : yield_stress;
}

bool Strength::is_weak_at(double z) const {
  return !most_above_.depth.empty() && bearing_at(z) < weak * most_above_.at(z);
}

bool Strength::differs(int above, int below) const {
  if (!variation_) return false;
  const double step = std::max(smallest_step, variation_->value.back() / most_steps);
  return variation_->at(mid_depth(below)) - variation_->at(mid_depth(above)) > step;
}

std::array<double, 3> Strength::start_at(double z) const {
  if (!material_.initial_stress) return {};
  const auto& stress = *material_.initial_stress;
  const double x = stress.xx.at(z), y = stress.yy.at(z), mean = (x + y) / 3;
  return {x - mean, y - mean, stress.xy.at(z)};
}

template <class Use>
void Strength::for_cells(const Box& box, const Use& use) const {
  std::vector<double> worn(box.surface_size(), 0.0);
  if (!relief_.worn.empty()) {
    std::size_t n = 0;
    for (int i = box.i0; i < box.i0 + box.nx; ++i) {
      for (int j = box.j0; j < box.j0 + box.ny; ++j) {
        worn[n++] = relief_.worn_at(i + first_, j, ny_);
      }
    }
  }
  std::size_t n = 0;
  for (int k = 0; k < box.nz; ++k) {
    for (const double depth : worn) use(n++, mid_depth(k) + depth);
  }
}

Field Strength::factor(const Box& box) const {
  if (!material_.yield_profile) return {};
  Field out(box.volume_size());
  // Whole layers are alike.
  double known = -1.0, value = 0.0;
  for_cells(box, [&](std::size_t n, double z) {
    if (z != known) value = factor_at(known = z);
    out[n] = value;
  });
  return out;
}

void Strength::add_stress(const Box& box, operators::Tensor tensor, Field& sum) const {
  if (!material_.initial_stress || box.empty()) return;
  const auto& stress = *material_.initial_stress;
  const bool deviator = tensor == operators::Tensor::deviator;
  const auto places = operators::components(tensor);
  const std::size_t cells = box.volume_size();
  sum.resize(places.size() * cells, 0.0);
  double known = -1.0;
  std::array<double, 6> at{};
  for_cells(box, [&](std::size_t n, double z) {
    if (z != known) {
      const double x = stress.xx.at(z), y = stress.yy.at(z), mean = deviator ? (x + y) / 3 : 0.0;
      at = {x - mean, y - mean, -mean, 0.0, 0.0, stress.xy.at(z)};
      known = z;
    }
    for (std::size_t c = 0; c < places.size(); ++c) sum[c * cells + n] += at[places[c]];
  });
}

std::vector<LayerLimit> Strength::limits(const std::vector<LayerRange>& ranges, double softening,
                                         double share, double share_of_weak) const {
  std::vector<LayerLimit> limits;
  limits.reserve(ranges.size());
  for (const auto& [layer, first, end] : ranges) {
    const double z = mid_depth(layer);
    const int last = std::min(end + worn_layers_, layers_ + 1);
    double part = is_weak_at(z) ? share_of_weak : share;
    for (int k = first; k < last && weakens_; ++k) {
      if (is_weak_at(mid_depth(k))) part = std::min(share, share_of_weak);
    }
    const double yield_stress = part * softening * material_.hardening.yield_stress(0.0);
    LayerLimit limit{yield_stress * factor_at(z), start_at(z)};
    // Worn cells are as strong as deeper ones; far down they are alike.
    for (int k = first; k < last; ++k) {
      auto other = start_at(mid_depth(k));
      for (int c = 0; c < 3; ++c) other[c] = part * (other[c] - limit.start[c]);
      limit.stress =
          std::min(limit.stress, yield_stress * factor_at(mid_depth(k)) - von_mises(other));
    }
    for (double& s : limit.start) s *= part;
    limits.push_back(limit);
  }
  return limits;
}

}  // namespace samcontact::simulation
