// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/film/elastic_film.hpp"

#include <cmath>

#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"

namespace samcontact::film {
namespace {

constexpr int max_steps = 60;
/// Neighbours of a cell on each side: of a plane, and of a line contact.
constexpr int reach_of_plane = 1, reach_of_line = 2;
/// Share of the pressure due to a uniform displacement that is taken from the nearest coefficients:
/// on a plane this pressure tends to zero, but a few coefficients around the cell leave a rest,
/// which would be too stiff for long waves.
constexpr double uniform_share = 0.8;

double dot(const Field& a, const Field& b) { return ordered_dot(a.data(), b.data(), a.size()); }

}  // namespace

ElasticFilm::ElasticFilm(const Grid& grid, const operators::SurfaceInfluence& influence)
    : lattice_(grid), displacement_(grid, influence), near_(grid, influence, displacement_.ends()) {
  Field unit(lattice_.size(), 0.0), found(lattice_.size());
  const int i = grid.nx / 2, j = grid.ny / 2;
  unit[lattice_.at(i, j)] = 1.0;
  near_.preconditioner.apply(unit.data(), found.data(), work_);
  const int reach = grid.ny > 1 ? reach_of_plane : reach_of_line;
  for (int a = -reach; a <= reach; ++a) {
    for (int b = -reach; b <= reach; ++b) {
      const std::ptrdiff_t at = lattice_.at(i + a, j + b);
      if (at < 0 || (grid.ny == 1 && b != 0)) continue;
      nearest_.push_back({a, b, found[at]});
    }
  }
  double uniform = 0.0;
  for (const Neighbour& near : nearest_) uniform += near.stiffness;
  for (Neighbour& near : nearest_) {
    if (near.along_x == 0 && near.along_y == 0) near.stiffness -= uniform_share * uniform;
  }
}

void ElasticFilm::displace(const Field& pressure, Field& displacement) {
  displacement_.apply(pressure.data(), displacement.data(), work_);
  ++applications_;
}

void ElasticFilm::precondition(const std::vector<char>& marked, const Field& residual,
                               Field& step) {
  near_.preconditioner.apply(residual.data(), step.data(), work_);
  applications_ += near_.preconditioner.cost() / displacement_.cost();
  for_each_cell(std::ssize(step), [&](std::ptrdiff_t i) { step[i] *= marked[i]; });
}

Field ElasticFilm::press(const Field& displacement, const std::vector<char>& marked,
                         const Field& compliance, double share) {
  const std::ptrdiff_t n = std::ssize(displacement);
  Field pressure(n, 0.0), residual(n), z(n), direction(n), moved(n);
  for_each_cell(n, [&](std::ptrdiff_t i) { residual[i] = marked[i] ? displacement[i] : 0.0; });
  const double enough = share * std::sqrt(dot(residual, residual));
  precondition(marked, residual, z);
  direction = z;
  double along = dot(residual, z);
  for (int step = 0; step < max_steps && along > 0; ++step) {
    displace(direction, moved);
    for_each_cell(n, [&](std::ptrdiff_t i) {
      moved[i] = marked[i] ? moved[i] + compliance[i] * direction[i] : 0.0;
    });
    const double length = along / dot(direction, moved);
    for_each_cell(n, [&](std::ptrdiff_t i) {
      pressure[i] += length * direction[i];
      residual[i] -= length * moved[i];
    });
    if (std::sqrt(dot(residual, residual)) < enough) break;
    precondition(marked, residual, z);
    const double next = dot(residual, z);
    const double turn = next / along;
    for_each_cell(n, [&](std::ptrdiff_t i) { direction[i] = z[i] + turn * direction[i]; });
    along = next;
  }
  return pressure;
}

}  // namespace samcontact::film
