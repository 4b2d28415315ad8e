// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat/heat_decay.hpp"

#include <cmath>

namespace samcontact::operators {
namespace {

/// 1 - exp(-z) without cancellation.
Complex grown(Complex z) {
  const double e = std::exp(-z.real()), half = std::sin(z.imag() / 2);
  return {-std::expm1(-z.real()) + 2 * e * half * half, e * std::sin(z.imag())};
}

}  // namespace

Decay::Decay(const HeatLevel& level, double x, const PlaneVector& speed)
    : nodes_(level.rates.size()), grown_nodes_(level.rates.size()), x_(x) {
  decay_.reserve(level.modes.size());
  modes_.reserve(level.modes.size());
  grown_.reserve(level.modes.size());
  for (const HeatMode& mode : level.modes) {
    decay_.push_back(mode.decay + Complex{0.0, mode.w1 * speed[0] + mode.w2 * speed[1]});
    modes_.push_back(std::exp(-decay_.back() * x));
    grown_.push_back(grown(decay_.back() * x));
  }
  for (std::size_t j = 0; j < nodes_.size(); ++j) {
    const double y = level.rates[j] * x;
    nodes_[j] = std::exp(-y);
    grown_nodes_[j] = -std::expm1(-y);
  }
}

ComplexField phases_of(const HeatLevel& level, const PlaneVector& motion) {
  ComplexField phases;
  phases.reserve(level.modes.size());
  for (const HeatMode& mode : level.modes) {
    phases.push_back(std::polar(1.0, -(mode.w1 * motion[0] + mode.w2 * motion[1])));
  }
  return phases;
}

}  // namespace samcontact::operators
