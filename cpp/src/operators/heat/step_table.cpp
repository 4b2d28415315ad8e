// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat/step_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "samcontact/kernels/talbot.hpp"
#include "samcontact/operators/heat/rate_fit.hpp"

namespace samcontact::operators {
namespace {

/// Nodes of the inverse transform.
constexpr int contour_nodes = 15;

using PulseValue = std::complex<double>;

/// Largest phase of young heat, and the fraction of its age at which it acts.
constexpr double young_phase = 1e-4, young_centre = 0.4;
constexpr double pulse_tolerance = 1e-8;
/// Slowest rate times the time of the flux, and step of the logarithm of the rates.
constexpr double slowest_pulse = 0.05, pulse_step = 0.22;

}  // namespace

OctavePanels::OctavePanels(double lowest, double highest)
    : panels_(std::max(1, static_cast<int>(std::ceil(std::log2(highest / lowest))))),
      first_(std::log(lowest)),
      width_(std::log(highest / lowest) / panels_) {
  for (int n = 0; n < nodes; ++n) {
    const double angle = std::numbers::pi * (n + 0.5) / nodes;
    places_[n] = std::cos(angle);
    weights_[n] = (n % 2 == 0 ? 1.0 : -1.0) * std::sin(angle);
  }
}

double OctavePanels::wavenumber(int panel, double place) const {
  return std::exp(first_ + width_ * (panel + 0.5 * (1 + place)));
}

OctavePanels::Shares OctavePanels::shares(double q) const {
  const double x = std::clamp((std::log(q) - first_) / width_, 0.0, static_cast<double>(panels_));
  Shares shares{std::min(static_cast<int>(x), panels_ - 1), {}, 0.0};
  const double place = 2 * (x - shares.panel) - 1;
  for (int n = 0; n < nodes; ++n) {
    const double distance = place - places_[n];
    if (distance == 0) {
      shares.of_nodes.fill(0.0);
      shares.of_nodes[n] = shares.whole = 1.0;
      return shares;
    }
    shares.of_nodes[n] = weights_[n] / distance;
    shares.whole += shares.of_nodes[n];
  }
  return shares;
}

StepTable::StepTable(const Modes& modes, int count, double time, double lowest, double highest)
    : count_(count), axis_(lowest, highest) {
  const auto contour = kernels::talbot_nodes(time, contour_nodes);
  std::vector<std::complex<double>> transforms(count);
  for (int panel = 0; panel < axis_.panels(); ++panel) {
    for (const double place : axis_.places()) {
      const double q = axis_.wavenumber(panel, place);
      std::vector<double> sums(count, 0.0);
      for (const auto& [s, weight] : contour) {
        modes(q, s, transforms.data());
        const std::complex<double> of_step = weight / s;
        for (int c = 0; c < count; ++c) sums[c] += std::imag(of_step * transforms[c]);
      }
      values_.insert(values_.end(), sums.begin(), sums.end());
    }
  }
}

void StepTable::at(double q, double* values) const {
  const auto [panel, shares, whole] = axis_.shares(q);
  const double* nodes =
      values_.data() + static_cast<std::ptrdiff_t>(panel) * OctavePanels::nodes * count_;
  std::fill_n(values, count_, 0.0);
  for (const double share : shares) {
    for (int c = 0; c < count_; ++c) values[c] += share * nodes[c];
    nodes += count_;
  }
  for (int c = 0; c < count_; ++c) values[c] /= whole;
}

PulseTable::PulseTable(const StepTable::Modes& modes, int count, const Flux& flux, double lowest,
                       double highest)
    : count_(count), flux_(flux), axis_(lowest, highest) {
  for (int panel = 0; panel < axis_.panels(); ++panel) {
    panels_.push_back(made(modes, axis_.wavenumber(panel, -1.0), axis_.wavenumber(panel, 1.0)));
  }
}

PulseTable::Panel PulseTable::made(const StepTable::Modes& modes, double bottom, double top) const {
  Panel panel;
  const double slowest = bottom * bottom * flux_.diffusivity, time = flux_.time;
  panel.begin = std::min(time, young_phase / (top * flux_.speed));
  const double first = std::max(slowest, slowest_pulse / time);
  const double last = first - 2 * std::log(pulse_tolerance) / panel.begin;
  if (panel.begin < time) {
    for (double rate = first; rate < last; rate *= std::exp(pulse_step)) {
      panel.rates.push_back(rate);
      panel.at_begin.push_back(std::exp(-rate * panel.begin));
      panel.left.push_back(std::exp(-rate * time));
    }
  }
  RateFit fit;
  if (!panel.rates.empty()) {
    fit = fit_rates(panel.rates, {panel.begin, time, slowest, pulse_tolerance}, flux_.power);
  }
  const auto young = kernels::talbot_nodes(panel.begin, contour_nodes);
  std::vector<PulseValue> transforms(count_);
  const auto rates = static_cast<Eigen::Index>(panel.rates.size());
  for (const double place : axis_.places()) {
    const double q = bottom * std::pow(top / bottom, 0.5 * (1 + place));  // as in OctavePanels
    Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(rates + 1, count_);
    for (std::size_t n = 0; n < fit.s.size(); ++n) {
      modes(q, fit.s[n], transforms.data());
      const auto column = fit.weights.col(static_cast<Eigen::Index>(n));
      for (int c = 0; c < count_; ++c) {
        weights.col(c).head(rates) +=
            column.real() * transforms[c].imag() + column.imag() * transforms[c].real();
      }
    }
    for (const auto& [s, weight] : young) {
      modes(q, s, transforms.data());
      for (int c = 0; c < count_; ++c) weights(rates, c) += std::imag(weight / s * transforms[c]);
    }
    panel.weights.insert(panel.weights.end(), weights.data(), weights.data() + weights.size());
  }
  return panel;
}

void PulseTable::at(double q, std::span<const double> omegas, std::vector<double>& weights,
                    PulseValue* values) const {
  const auto [number, shares, whole] = axis_.shares(q);
  const Panel& panel = panels_[number];
  const std::size_t rates = panel.rates.size(), size = count_ * (rates + 1);
  weights.assign(size, 0.0);
  const double* from = panel.weights.data();
  for (const double share : shares) {
    for (std::size_t n = 0; n < size; ++n) weights[n] += share / whole * from[n];
    from += size;
  }
  for (const double omega : omegas) {
    const PulseValue begin = std::polar(1.0, -omega * panel.begin);
    const PulseValue end = std::polar(1.0, -omega * flux_.time);
    const PulseValue young = std::polar(1.0, -omega * young_centre * panel.begin);
    for (int c = 0; c < count_; ++c) values[c] = weights[(c + 1) * (rates + 1) - 1] * young;
    for (std::size_t j = 0; j < rates; ++j) {
      const double rate = panel.rates[j];
      const PulseValue grown = (panel.at_begin[j] * begin - panel.left[j] * end) *
                               (PulseValue(rate, -omega) / (rate * rate + omega * omega));
      for (int c = 0; c < count_; ++c) values[c] += weights[c * (rates + 1) + j] * grown;
    }
    values += count_;
  }
}

}  // namespace samcontact::operators
