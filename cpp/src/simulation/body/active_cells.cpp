// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/body/active_cells.hpp"

#include <cassert>

namespace samcontact::simulation {

void ActiveCells::reserve(std::size_t count) {
  cells.reserve(count);
  stress.reserve(count);
  before_.reserve(count * components_);
}

void ActiveCells::append(const Cell& cell, const plasticity::Tensor& strain_before,
                         const plasticity::Tensor& deviator) {
  cells.push_back(cell);
  stress.push_back(deviator);
  before_.resize(cells.size() * components_);
  put(strain_before, before_, cells.size() - 1);
}

void ActiveCells::move(std::uint8_t body, const Zones& from, const Zones& to) {
  for (Cell& c : cells) {
    if (c.body != body) continue;
    const std::ptrdiff_t number = to.number(from.cell(c.cell));
    assert(number >= 0);
    c.cell = static_cast<std::uint32_t>(number);
  }
}

plasticity::Tensor ActiveCells::get(const Field& unknown, std::size_t n) const {
  const double* u = unknown.data() + n * components_;
  if (components_ == 6) return {u[0], u[1], u[2], u[3], u[4], u[5]};
  return {u[0], u[1], -(u[0] + u[1]), u[2], u[3], u[4]};
}

void ActiveCells::put(const plasticity::Tensor& t, Field& unknown, std::size_t n) const {
  using operators::Tensor;
  const auto places = operators::components(components_ == 6 ? Tensor::full : Tensor::deviator);
  for (int c = 0; c < components_; ++c) unknown[n * components_ + c] = t[places[c]];
}

plasticity::Tensor ActiveCells::strain(const Field& increment, std::size_t n) const {
  plasticity::Tensor sum = get(before_, n);
  const plasticity::Tensor more = get(increment, n);
  for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += more[c];
  return sum;
}

}  // namespace samcontact::simulation
