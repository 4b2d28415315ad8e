// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/plasticity/body.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "samcontact/base/errors.hpp"

namespace samcontact::plasticity {
namespace {

constexpr double max_layers = 1000;

void require_one_relaxation(const Body& body) {
  bool relaxes = false;
  for (int n = 0; n < body.count(); ++n) relaxes |= body.material(n).is_viscoelastic();
  if (!relaxes) return;
  for (int n = 0; n < body.count(); ++n) {
    const Material& own = body.material(n);
    if (own.elastic.is_rigid() || own.relaxation == body.relaxation()) continue;
    throw std::invalid_argument(
        "layers and substrate must have one relaxation (equal times and shares; a rigid substrate "
        "has none): with different ones the rates of the displacement depend on the wavelength, "
        "and the elastic operators of the body do not suffice");
  }
}

}  // namespace

Body::Body(Material substrate, std::vector<MaterialLayer> layers)
    : substrate_(std::move(substrate)), layers_(std::move(layers)) {
  Stack::of(stack().layers, substrate_.elastic);
  const auto layers_count = static_cast<double>(layers_.size());
  require(layers_count <= max_layers, "number of layers", "at most 1000", layers_count);
  require_one_relaxation(*this);
}

int Body::number_at(double z) const {
  double bottom = 0.0;
  for (std::size_t n = 0; n < layers_.size(); ++n) {
    bottom += layers_[n].thickness;
    if (z < bottom) return static_cast<int>(n);
  }
  return static_cast<int>(layers_.size());
}

std::vector<double> Body::interfaces() const {
  std::vector<double> depths;
  depths.reserve(layers_.size());
  double bottom = 0.0;
  for (const MaterialLayer& layer : layers_) depths.push_back(bottom += layer.thickness);
  return depths;
}

Stack Body::stack() const {
  Stack stack{{}, substrate_.elastic};
  for (const auto& [material, thickness] : layers_) {
    stack.layers.push_back({material.elastic, thickness});
  }
  return stack;
}

bool Body::is_plastic() const {
  return substrate_.is_plastic() ||
         std::any_of(layers_.begin(), layers_.end(),
                     [](const MaterialLayer& layer) { return layer.material.is_plastic(); });
}

bool Body::has_initial_stress() const {
  return substrate_.initial_stress ||
         std::any_of(layers_.begin(), layers_.end(), [](const MaterialLayer& layer) {
           return layer.material.initial_stress.has_value();
         });
}

double Body::strain_at_yield() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (int n = 0; n < count(); ++n) {
    const Material& own = material(n);
    if (!own.is_plastic()) continue;
    smallest = std::min(smallest, own.smallest_yield_stress() / (3 * own.elastic.shear_modulus()));
  }
  return smallest;
}

std::size_t Body::backstresses() const {
  std::size_t max_count = 0;
  for (int n = 0; n < count(); ++n)
    max_count = std::max(max_count, material(n).backstresses.size());
  return max_count;
}

bool Body::changes_like(const Body& other) const {
  if (layers_.size() != other.layers_.size()) return false;
  for (std::size_t n = 0; n < layers_.size(); ++n) {
    if (layers_[n].thickness != other.layers_[n].thickness) return false;
  }
  for (int n = 0; n < count(); ++n) {
    const Material &one = material(n), &two = other.material(n);
    if (one.is_plastic() != two.is_plastic() || one.yield_profile != two.yield_profile ||
        one.initial_stress != two.initial_stress) {
      return false;
    }
  }
  return true;
}

}  // namespace samcontact::plasticity
