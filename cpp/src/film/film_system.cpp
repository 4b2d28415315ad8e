// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/film/film_system.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/iteration/gmres.hpp"

namespace samcontact::film {
namespace {

/// Accuracy of the pressure that belongs to a film, in the preconditioner; where the boundary layer
/// is stiff, the pressure of the fluid is a small difference of this pressure and that of the
/// layer.
constexpr double pressure_accuracy = 0.05, accuracy_with_layer = 1e-3;
/// Stiffness of the boundary layer in a cavitated cell, relative to that of the cell, from which on
/// the preconditioner couples its pressure to the others.
constexpr double least_contact = 1e-3;
constexpr double least_scale = 1e-300;

double largest(const double* values, std::size_t n) {
  return largest_of(n, [&](std::size_t i) { return std::fabs(values[i]); });
}

/// Distance of cells that the preconditioner couples. The few coefficients of a plane that reach
/// further are small: the pressure changes the density of the film that leaves a cell.
int coupled(const Lattice& lattice) { return lattice.ny() > 1 ? 2 : 4; }

}  // namespace

FilmSystem::FilmSystem(const Grid& grid, ElasticFilm& elastic)
    : lattice_(grid),
      cell_area_(grid.cell_area()),
      elastic_(elastic),
      matrix_(lattice_, coupled(lattice_)),
      factors_(lattice_, coupled(lattice_)) {}

void FilmSystem::classify(const Linearised& system) {
  const std::size_t n = size();
  const double own = elastic_.self_influence();
  full_.assign(n, 0);
  touched_ = stiff_ = pressed_ = full_;
  damping_.assign(n, 0.0);
  column_.assign(n, 1.0);
  accuracy_ = pressure_accuracy;
  contact_weight_ = column_;
  for (std::size_t i = 0; i < n; ++i) {
    const double k = system.stiffness[i];
    full_[i] = system.cavitated[i] ? 0 : 1;
    touched_[i] = system.cavitated[i] && k * own > least_contact ? 1 : 0;
    pressed_[i] = full_[i] || touched_[i] ? 1 : 0;
    // The fluid flows so easily that its pressure is known, and not the film.
    stiff_[i] = k * own > 1 && std::fabs(system.slopes.pressure.diagonal(i)) * k >
                                   std::fabs(system.slopes.film.diagonal(i))
                    ? 1
                    : 0;
    if (stiff_[i]) accuracy_ = accuracy_with_layer;
    if (stiff_[i] || touched_[i]) damping_[i] = 1 / std::max(k, least_scale);
    column_[i] = contact_weight_[i] = 1 / (1 + k * own);
  }
}

Field FilmSystem::nearest_pressure(const Field& displacement) const {
  Field pressure(size(), 0.0);
#pragma omp parallel for schedule(static) if (size() > 20'000)
  for (int i = 0; i < lattice_.nx(); ++i) {
    for (int j = 0; j < lattice_.ny(); ++j) {
      const std::ptrdiff_t row = lattice_.at(i, j);
      if (!full_[row]) continue;
      double sum = 0.0;
      for (const auto& near : elastic_.nearest()) {
        const std::ptrdiff_t at = lattice_.at(i + near.along_x, j + near.along_y);
        if (at >= 0 && pressed_[at]) sum += near.stiffness * displacement[at];
      }
      pressure[row] = sum;
    }
  }
  return pressure;
}

bool FilmSystem::decompose(const Linearised& system) {
  const auto& [by_pressure, by_film, by_void] = system.slopes;
  row_scale_.assign(size(), 0.0);
  std::vector<double> values(matrix_.width());
  const auto add = [&](int along_x, int along_y, double value) {
    const int slot = matrix_.slot(along_x, along_y);
    if (slot >= 0) values[slot] += value;
  };
  for (int i = 0; i < lattice_.nx(); ++i) {
    for (int j = 0; j < lattice_.ny(); ++j) {
      const std::ptrdiff_t row = lattice_.at(i, j);
      std::fill(values.begin(), values.end(), 0.0);
      for (int slot = 0; slot < Star::entries; ++slot) {
        const auto [di, dj] = Star::offset(slot);
        const std::ptrdiff_t at = lattice_.at(i + di, j + dj);
        if (at < 0) continue;
        if (!full_[at]) {
          add(di, dj, by_void.entry(row, slot));
          continue;
        }
        const double slope = by_pressure.entry(row, slot);
        add(di, dj, column_[at] * (slope * system.stiffness[at] + by_film.entry(row, slot)));
        if (slope == 0) continue;
        for (const auto& near : elastic_.nearest()) {
          const int a = di + near.along_x, b = dj + near.along_y;
          const std::ptrdiff_t to = lattice_.at(i + a, j + b);
          if (to >= 0 && full_[to]) add(a, b, slope * near.stiffness * column_[to]);
        }
      }
      const double scale = 1 / std::max(largest(values.data(), values.size()), least_scale);
      row_scale_[row] = scale;
      std::transform(values.begin(), values.end(), matrix_.row(row),
                     [&](double value) { return static_cast<float>(scale * value); });
    }
  }
  // Cavitated cells are filled from upstream, and need no other pivots; their coefficients, of
  // another unknown, do not compare.
  return factors_.decompose(matrix_, full_);
}

Field FilmSystem::flow_solution(const Field& residual) {
  const std::size_t n = size();
  Field scaled(n);
  for (std::size_t i = 0; i < n; ++i) scaled[i] = row_scale_[i] * residual[i];
  // Single precision has a short range.
  const double unit = std::max(largest(scaled.data(), n), least_scale);
  Singles found(n);
  for (std::size_t i = 0; i < n; ++i) found[i] = static_cast<float>(scaled[i] / unit);
  factors_.solve(found);
  for (std::size_t i = 0; i < n; ++i) scaled[i] = unit * found[i];
  return scaled;
}

Field FilmSystem::target(const Linearised& system, const Field& flow, double approach,
                         const Field& contact) const {
  const std::size_t n = size();
  Field film(n);
  for (std::size_t i = 0; i < n; ++i) film[i] = full_[i] ? flow[i] * column_[i] : 0.0;
  Field moved(n);
  for (std::size_t i = 0; i < n; ++i) moved[i] = film[i] + approach;
  const Field near = nearest_pressure(moved);
  Field goal(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double fluid = full_[i] ? near[i] + system.stiffness[i] * film[i] : 0.0;
    const double own = touched_[i] ? contact[i] * damping_[i]
                       : stiff_[i] ? fluid * damping_[i]
                                   : film[i];
    goal[i] = own + approach;
  }
  return goal;
}

void FilmSystem::find_response(const Linearised& system) {
  const std::size_t n = size();
  const Field zero(n, 0.0);
  Field flow(n, 0.0);
  system.slopes.pressure.add_product(nearest_pressure(Field(n, 1.0)), flow);
  flow_response_ = flow_solution(flow);
  Field negative = flow_response_;
  for (double& value : negative) value = -value;
  pressure_response_ =
      elastic_.press(target(system, negative, 1.0, zero), pressed_, damping_, accuracy_);
  load_response_ =
      cell_area_ * ordered_sum(n, [&](std::size_t i) { return pressure_response_[i]; });
}

/// Unknowns: [pressure or void fraction of each cell | pressure of the boundary layer in cavitated
/// cells | approach].
void FilmSystem::precondition(const Linearised& system, const Field& residual, Field& change) {
  const std::size_t n = size();
  Field contact(n);
  for (std::size_t i = 0; i < n; ++i) contact[i] = residual[n + i] / contact_weight_[i];
  Field flow = flow_solution(residual);
  Field pressure =
      elastic_.press(target(system, flow, 0.0, contact), pressed_, damping_, accuracy_);
  double approach = residual[2 * n];
  if (system.has_load) {
    const double load = cell_area_ * ordered_sum(n, [&](std::size_t i) { return pressure[i]; });
    approach = (residual[2 * n] - load) / load_response_;
  }
  change.assign(2 * n + 1, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const double z = pressure[i] + approach * pressure_response_[i];
    change[i] = full_[i] ? z : flow[i] - approach * flow_response_[i];
    if (!full_[i]) change[n + i] = touched_[i] ? z : contact[i];
  }
  change[2 * n] = approach;
}

Field FilmSystem::pressure_of(const Field& change) const {
  const std::size_t n = size();
  Field pressure(n);
  for (std::size_t i = 0; i < n; ++i) pressure[i] = full_[i] ? change[i] : change[n + i];
  return pressure;
}

void FilmSystem::apply(const Linearised& system, const Field& change, Field& image) {
  const std::size_t n = size();
  const Field pressure = pressure_of(change);
  const double approach = change[2 * n];
  Field film(n), fluid(n), voids(n), flow(n, 0.0);
  elastic_.displace(pressure, film);
  for (std::size_t i = 0; i < n; ++i) {
    film[i] -= approach;
    fluid[i] = full_[i] ? change[i] + system.stiffness[i] * film[i] : 0.0;
    voids[i] = full_[i] ? 0.0 : change[i];
  }
  system.slopes.pressure.add_product(fluid, flow);
  system.slopes.film.add_product(film, flow);
  system.slopes.void_fraction.add_product(voids, flow);
  image.assign(2 * n + 1, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    image[i] = flow[i];
    if (!full_[i]) {
      image[n + i] = (change[n + i] + system.stiffness[i] * film[i]) * contact_weight_[i];
    }
  }
  image[2 * n] = system.has_load
                     ? cell_area_ * ordered_sum(n, [&](std::size_t i) { return pressure[i]; })
                     : approach;
}

FilmChange FilmSystem::unpack(const Linearised& system, const Field& solution) {
  const std::size_t n = size();
  FilmChange change;
  const Field pressure = pressure_of(solution);
  change.approach = solution[2 * n];
  change.film.resize(n);
  elastic_.displace(pressure, change.film);
  change.fluid_pressure.assign(n, 0.0);
  change.boundary_pressure = change.void_fraction = change.fluid_pressure;
  for (std::size_t i = 0; i < n; ++i) {
    change.film[i] -= change.approach;
    change.boundary_pressure[i] = system.lag[i] - system.stiffness[i] * change.film[i];
    if (full_[i]) {
      change.fluid_pressure[i] = solution[i] - change.boundary_pressure[i];
    } else {
      change.void_fraction[i] = solution[i];
    }
  }
  return change;
}

FilmChange FilmSystem::solve(const Linearised& system, double share, int max_steps) {
  const std::size_t n = size();
  classify(system);
  if (!decompose(system)) return {};
  find_response(system);
  Field lag(n), right(2 * n + 1, 0.0), flow(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) lag[i] = full_[i] ? system.lag[i] : 0.0;
  system.slopes.pressure.add_product(lag, flow);
  for (std::size_t i = 0; i < n; ++i) {
    right[i] = flow[i] - system.outflow[i];
    if (!full_[i]) right[n + i] = system.lag[i] * contact_weight_[i];
  }
  right[2 * n] = system.has_load ? system.missing_load : 0.0;
  // The residuals of flow, contact pressure and load have equal weights.
  const double flow_weight = 1 / std::max(largest(right.data(), n), least_scale);
  const double contact_weight =
      1 / std::max({largest(right.data() + n, n),
                    1e-6 * system.load_scale / cell_area_ / static_cast<double>(n), least_scale});
  const double load_weight =
      1 / std::max({std::fabs(right[2 * n]), 1e-6 * system.load_scale, least_scale});
  const auto scale = [&](Field& field, bool inverse) {
    for (std::size_t i = 0; i <= 2 * n; ++i) {
      const double weight = i < n ? flow_weight : i < 2 * n ? contact_weight : load_weight;
      field[i] *= inverse ? 1 / weight : weight;
    }
  };
  scale(right, false);
  Field solution;
  FilmChange change;
  const int steps = contact::flexible_gmres(
      [&](const Field& v, Field& image) {
        apply(system, v, image);
        scale(image, false);
      },
      [&](const Field& v, Field& z) {
        check_interrupt();
        Field residual = v;
        scale(residual, true);
        precondition(system, residual, z);
      },
      right, share, max_steps, solution);
  change = unpack(system, solution);
  change.steps = steps;
  return change;
}

}  // namespace samcontact::film
