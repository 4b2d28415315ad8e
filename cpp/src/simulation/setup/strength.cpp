// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/setup/strength.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "samcontact/base/cells_over.hpp"
#include "samcontact/base/deviator.hpp"
#include "samcontact/base/errors.hpp"

namespace samcontact::simulation {
namespace {

/// Maximum number of layers.
constexpr double max_tabulated_layers = 1e6;
/// Change of strength, relative to the yield stress, that requires a check at an additional depth;
/// maximum number of such depths.
constexpr double smallest_step = 0.05, max_steps = 40.0;

/// A layer is weak if its strength is less than this fraction of that above.
constexpr double weak_ratio = 0.9;

double von_mises(const std::array<double, 3>& s) {
  return std::sqrt(3 * second_invariant(s[0], s[1], 0.0, 0.0, s[2]));
}

/// Stands for unlimited pressure [Pa].
constexpr double unlimited_pressure = 1e30;

/// Depths at which a profile of a material has a kink, and both sides of interfaces.
std::vector<double> kinks(const plasticity::Body& body) {
  const std::vector<double> bottoms = body.interfaces();
  std::vector<double> depths;
  for (int n = 0; n < body.count(); ++n) {
    const double top = n > 0 ? bottoms[n - 1] : 0.0;
    const double bottom = n + 1 < body.count() ? bottoms[n] : INFINITY;
    const auto add = [&](const OverDepth& profile) {
      std::copy_if(profile.depth.begin(), profile.depth.end(), std::back_inserter(depths),
                   [&](double z) { return z >= top && z < bottom; });
    };
    const plasticity::Material& material = body.material(n);
    if (material.yield_profile) add(*material.yield_profile);
    if (material.initial_stress) add(material.initial_stress->xx);
    if (body.is_layered()) depths.push_back(top);
    if (std::isfinite(bottom)) depths.push_back(std::nextafter(bottom, 0.0));
  }
  std::sort(depths.begin(), depths.end());
  depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
  return depths;
}

}  // namespace

Strength::Strength(const plasticity::Body& body, const Grid& grid, const Relief& relief, int first)
    : body_(body), relief_(relief), first_(first), ny_(grid.ny), dz_(grid.dz) {
  const double dz = dz_;
  OverDepth variation{kinks(body), {0.0}};
  if (variation.depth.empty()) return;
  const double deepest = variation.depth.back();
  require(!(dz > 0) || deepest <= max_tabulated_layers * dz,
          "the maximum depth of a yield profile, residual stress or layers",
          "at most " + to_text(max_tabulated_layers * dz) + " m, " + to_text(max_tabulated_layers) +
              " layers of dz",
          deepest);
  for (std::size_t n = 1; n < variation.depth.size(); ++n) {
    const double above = variation.depth[n - 1], below = variation.depth[n];
    variation.value.push_back(variation.value.back() + change(above, below));
  }
  if (variation.value.back() == 0 && !body.is_layered()) return;
  if (dz > 0) {
    layers_ = cells_over(deepest, dz);
    const auto deepest_wear = std::max_element(relief.worn.begin(), relief.worn.end());
    const double worn = deepest_wear == relief.worn.end() ? 0.0 : std::min(*deepest_wear, deepest);
    worn_layers_ = cells_over(worn, dz);
  }
  variation_ = std::move(variation);
  double max_pressure = 0.0;
  for (const double z : variation_->depth) {
    max_pressure = std::max(max_pressure, yield_pressure_at(z));
    max_above_.depth.push_back(z);
    max_above_.value.push_back(max_pressure);
    weakens_ = weakens_ || is_weak_at(z);
  }
}

double Strength::change(double above, double below) const {
  const plasticity::Material& material = body_.at(above);
  // Both sides of an interface are checked; elastic material is not.
  if (&body_.at(below) != &material || !material.is_plastic()) return 0.0;
  const double one = material.yield_factor(above), two = material.yield_factor(below);
  const double change = std::fabs(two - one) / std::max(one, two);
  if (!material.initial_stress) return change;
  const auto of = [&](const OverDepth& s) { return s.at(below) - s.at(above); };
  const auto& [xx, yy, xy] = *material.initial_stress;
  const double x = of(xx), y = of(yy), mean = (x + y) / 3;
  return change + von_mises({x - mean, y - mean, of(xy)}) / material.smallest_yield_stress();
}

double Strength::yield_pressure_at(double z) const {
  const plasticity::Material& material = body_.at(z);
  if (!material.is_plastic()) return unlimited_pressure;
  const auto& stress = material.initial_stress;
  const double helping = stress ? 0.5 * (stress->xx.at(z) + stress->yy.at(z)) : 0.0;
  return yield_stress_at(z) - helping;
}

bool Strength::is_weak_at(double z) const {
  return !max_above_.depth.empty() && yield_pressure_at(z) < weak_ratio * max_above_.at(z);
}

bool Strength::differs(int above, int below) const {
  if (!variation_) return false;
  const double step = std::max(smallest_step, variation_->value.back() / max_steps);
  return is_interface(above, below) ||
         variation_->at(mid_depth(below)) - variation_->at(mid_depth(above)) > step;
}

std::array<double, 3> Strength::start_at(double z) const {
  const auto& stress = body_.at(z).initial_stress;
  if (!stress) return {};
  const double x = stress->xx.at(z), y = stress->yy.at(z), mean = (x + y) / 3;
  return {x - mean, y - mean, stress->xy.at(z)};
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
  for (int k = box.k0; k < box.nz; ++k) {
    for (const double depth : worn) use(n++, mid_depth(k) + depth);
  }
}

std::vector<std::uint16_t> Strength::materials(const Box& box) const {
  if (!body_.is_layered()) return {};
  std::vector<std::uint16_t> out(box.volume_size());
  double known = -1.0;
  std::uint16_t number = 0;
  for_cells(box, [&](std::size_t n, double z) {
    if (z != known) number = static_cast<std::uint16_t>(body_.number_at(known = z));
    out[n] = number;
  });
  return out;
}

Field Strength::factor(const Box& box) const {
  bool graded = false;
  for (int n = 0; n < body_.count(); ++n) graded |= body_.material(n).yield_profile.has_value();
  if (!graded) return {};
  Field out(box.volume_size());
  // Cells of one layer have equal values.
  double known = -1.0, value = 0.0;
  for_cells(box, [&](std::size_t n, double z) {
    if (z != known) value = body_.at(z).yield_factor(known = z);
    out[n] = value;
  });
  return out;
}

void Strength::add_stress(const Box& box, operators::Tensor tensor, Field& sum) const {
  if (!body_.has_initial_stress() || box.empty()) return;
  const bool deviator = tensor == operators::Tensor::deviator;
  const auto places = operators::components(tensor);
  const std::size_t cells = box.volume_size();
  sum.resize(places.size() * cells, 0.0);
  double known = -1.0;
  std::array<double, 6> at{};
  for_cells(box, [&](std::size_t n, double z) {
    if (z != known) {
      const auto& stress = body_.at(z).initial_stress;
      const double x = stress ? stress->xx.at(z) : 0.0, y = stress ? stress->yy.at(z) : 0.0;
      const double mean = deviator ? (x + y) / 3 : 0.0;
      at = {x - mean, y - mean, -mean, 0.0, 0.0, stress ? stress->xy.at(z) : 0.0};
      known = z;
    }
    for (std::size_t c = 0; c < places.size(); ++c) sum[c * cells + n] += at[places[c]];
  });
}

std::vector<LayerLimit> Strength::limits(const std::vector<LayerRange>& ranges, double softening,
                                         double share, double weak_share) const {
  std::vector<LayerLimit> limits;
  limits.reserve(ranges.size());
  for (const auto& [layer, first, end] : ranges) {
    const double z = mid_depth(layer);
    const int last = std::min(end + worn_layers_, layers_ + 1);
    double part = is_weak_at(z) ? weak_share : share;
    for (int k = first; k < last && weakens_; ++k) {
      if (is_weak_at(mid_depth(k))) part = std::min(share, weak_share);
    }
    const double factor = part * softening;
    LayerLimit limit{factor * yield_stress_at(z), start_at(z)};
    // Worn cells have the strength of deeper ones; at large depths all are equal.
    for (int k = first; k < last; ++k) {
      auto other = start_at(mid_depth(k));
      for (int c = 0; c < 3; ++c) other[c] = part * (other[c] - limit.start[c]);
      limit.stress =
          std::min(limit.stress, factor * yield_stress_at(mid_depth(k)) - von_mises(other));
    }
    for (double& s : limit.start) s *= part;
    limits.push_back(limit);
  }
  return limits;
}

}  // namespace samcontact::simulation
