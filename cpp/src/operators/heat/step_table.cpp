// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat/step_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "samcontact/kernels/talbot.hpp"

namespace samcontact::operators {
namespace {

/// Nodes of a panel, whose length is one octave, and nodes of the inverse transform.
constexpr int panel_nodes = 14, contour_nodes = 15;

}  // namespace

StepTable::StepTable(const Modes& modes, int count, double time, double lowest, double highest)
    : count_(count),
      panels_(std::max(1, static_cast<int>(std::ceil(std::log2(highest / lowest))))),
      first_(std::log(lowest)),
      width_(std::log(highest / lowest) / panels_) {
  for (int n = 0; n < panel_nodes; ++n) {
    const double angle = std::numbers::pi * (n + 0.5) / panel_nodes;
    places_.push_back(std::cos(angle));
    weights_.push_back((n % 2 == 0 ? 1.0 : -1.0) * std::sin(angle));
  }
  const auto contour = kernels::talbot_nodes(time, contour_nodes);
  std::vector<std::complex<double>> transforms(count);
  for (int panel = 0; panel < panels_; ++panel) {
    for (const double place : places_) {
      const double q = std::exp(first_ + width_ * (panel + 0.5 * (1 + place)));
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
  const double x = std::clamp((std::log(q) - first_) / width_, 0.0, static_cast<double>(panels_));
  const int panel = std::min(static_cast<int>(x), panels_ - 1);
  const double place = 2 * (x - panel) - 1;
  const double* nodes = values_.data() + static_cast<std::ptrdiff_t>(panel) * panel_nodes * count_;
  double whole = 0.0;
  std::fill_n(values, count_, 0.0);
  for (int n = 0; n < panel_nodes; ++n, nodes += count_) {
    const double distance = place - places_[n];
    if (distance == 0) {
      std::copy_n(nodes, count_, values);
      return;
    }
    const double share = weights_[n] / distance;
    whole += share;
    for (int c = 0; c < count_; ++c) values[c] += share * nodes[c];
  }
  for (int c = 0; c < count_; ++c) values[c] /= whole;
}

}  // namespace samcontact::operators
