// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/residual/swept_stack.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "samcontact/base/errors.hpp"

namespace samcontact::operators::layers {
namespace {

/// Allowed distance of an interface from a boundary between cells, in layers of cells.
constexpr double off_face = 1e-6;

/// Coefficients for one thickness of cells.
void fill_coefficients(double kx, double ky, double h, double weight, double* mode, int step) {
  const double q = std::hypot(kx, ky), x = q * h;
  const auto set = [&](Coefficient c, double value) {
    mode[static_cast<std::ptrdiff_t>(c) * step] = value;
  };
  set(share, weight);
  if (q == 0) {
    set(direction_x, 1.0);
    set(decay, 1.0);
    return;
  }
  const double e = std::exp(-x), decayed = -std::expm1(-x);
  set(direction_x, kx / q);
  set(direction_y, ky / q);
  set(thickness, x);
  set(decay, e);
  set(own, 0.5 * (1 - decayed / x));
  set(own_linear, 0.5 * (1 - (2 * decayed - x * e) / x));
  set(other, 0.5 * decayed * decayed / x);
  set(other_shift, x * (1 + e) / decayed - 2);
  set(leaving, 0.5 * decayed);
  set(leaving_shift, 1 - x * e / decayed);
}

}  // namespace

std::vector<SweptLayer> swept_layers(const Stack& body, int k0, int nz, double dz) {
  std::vector<SweptLayer> found;
  const int end = k0 + nz;
  const double upper = k0 * dz;
  double top = 0.0;
  int first = 0;
  // The part of a layer above the first cell.
  const auto add_above = [&](const Elastic& elastic, double bottom) {
    if (!(top < upper)) return;
    const double above = std::min(bottom, upper);
    found.push_back({elastic, above - top, 0, dz});
    top = above;
    first = k0;
  };
  for (std::size_t n = 0; n < body.layers.size(); ++n) {
    const auto& [elastic, thickness] = body.layers[n];
    const double bottom = top + thickness, face = bottom / dz;
    if (face <= end + off_face && std::fabs(face - std::round(face)) > off_face) {
      throw std::invalid_argument(
          "the bottom of layers[" + std::to_string(n) + "], at " + to_text(bottom) +
          " m, must coincide with a cell boundary, got dz = " + to_text(dz) +
          " m: use a whole fraction of the thickness");
    }
    if (k0 > 0) {
      add_above(elastic, bottom);
      if (face <= k0 + off_face) {
        top = bottom;
        continue;
      }
    }
    const double left = k0 > 0 ? bottom - top : thickness;
    const int last = face < end ? static_cast<int>(std::lround(face)) : end;
    const double within = face > end + off_face ? end * dz - top : left;
    if (last > first) found.push_back({elastic, within, last - first, dz});
    const double beyond = last > first ? left - within : left;
    if (beyond > 0) found.push_back({elastic, beyond, 0, dz});
    first = last;
    top = bottom;
  }
  if (!body.substrate.is_rigid()) {
    add_above(body.substrate, INFINITY);
    found.push_back({body.substrate, INFINITY, end - first, dz});
  } else if (first < end) {
    throw std::invalid_argument("the grid must end above the rigid substrate, at " + to_text(top) +
                                " m, got " + std::to_string(end) +
                                " layers of dz = " + to_text(dz) + " m");
  }
  return found;
}

SweptStack::SweptStack(const std::vector<SweptLayer>& layers, bool on_rigid) {
  for (const SweptLayer& layer : layers) {
    const auto same = std::ranges::find(thicknesses_, layer.cell);
    const auto mode = static_cast<int>(same - thicknesses_.begin()) * coefficient_count;
    if (same == thicknesses_.end()) thicknesses_.push_back(layer.cell);
    const int first = layers_.empty() ? 0 : layers_.back().last;
    const double nu = layer.elastic.nu, mu = layer.elastic.shear_modulus();
    layers_.push_back({first, first + layer.cells, nu, 2 * mu * nu / (1 - 2 * nu), mu,
                       layer.thickness, layer.thickness / layer.cell, mode, 0});
  }
  if (!on_rigid) layers_.back().depth = INFINITY;
  numbers_ = static_cast<int>(thicknesses_.size()) * coefficient_count;
  for (Layer& layer : layers_) {
    if (!layer.is_endless()) layer.through = numbers_++;
  }
}

void SweptStack::fill_mode(double kx, double ky, double weight, double* mode, int step) const {
  const auto at = [&](int place) { return mode + static_cast<std::ptrdiff_t>(place) * step; };
  for (std::size_t n = 0; n < thicknesses_.size(); ++n) {
    fill_coefficients(kx, ky, thicknesses_[n], weight, at(static_cast<int>(n) * coefficient_count),
                      step);
  }
  for (const Layer& layer : layers_) {
    if (!layer.is_endless()) *at(layer.through) = std::exp(-std::hypot(kx, ky) * layer.depth);
  }
}

}  // namespace samcontact::operators::layers
