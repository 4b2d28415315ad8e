// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat/heating.hpp"

#include "samcontact/kernels/heat_displacement.hpp"
#include "samcontact/kernels/heat_steady.hpp"
#include "samcontact/kernels/heat_stress.hpp"
#include "samcontact/kernels/heat_temperature.hpp"

namespace samcontact::operators {
namespace {

/// Error of tables, relative to their largest value.
constexpr double table_tol = 1e-7;

kernels::HeatSource source_of(const Heating& heating, double dx, double dy) {
  const double kappa = heating.thermal.substrate.diffusivity;
  return {dx / 2,
          dy / 2,
          kappa * heating.age,
          heating.speed_x / kappa,
          heating.speed_y / kappa,
          heating.period_x,
          heating.period_y};
}

/// Negative offsets too, in directions in which the source moves.
kernels::HeatPoints points_of(const Heating& heating, const Offsets& offsets) {
  const auto both = [](const std::vector<double>& from, bool moving) {
    if (!moving) return from;
    std::vector<double> all;
    for (std::size_t n = from.size(); n-- > 0;) {
      if (from[n] != 0) all.push_back(-from[n]);
    }
    all.insert(all.end(), from.begin(), from.end());
    return all;
  };
  return {both(offsets.x, heating.speed_x != 0), both(offsets.y, heating.speed_y != 0)};
}

/// Parts of a table over points_of(), [i][j], of a field with the given parity for a source at
/// rest; times `scale`.
ParityParts split(const Heating& heating, const Offsets& offsets, const double* table, bool odd_x,
                  bool odd_y, double scale) {
  const auto nx = static_cast<std::ptrdiff_t>(offsets.x.size());
  const auto ny = static_cast<std::ptrdiff_t>(offsets.y.size());
  const bool by_x = heating.speed_x != 0, by_y = heating.speed_y != 0;
  // Index of offset 0, and number of points along y.
  const std::ptrdiff_t x0 = by_x ? nx - (offsets.x[0] == 0) : 0;
  const std::ptrdiff_t y0 = by_y ? ny - (offsets.y[0] == 0) : 0;
  const std::ptrdiff_t pitch = y0 + ny;
  const auto index = [](std::ptrdiff_t zero, std::ptrdiff_t n, bool with_zero, int sign) {
    return sign > 0 ? zero + n : zero - n - (with_zero ? 0 : 1);
  };
  ParityParts parts;
  for (int flip = 0; flip < 4; ++flip) {
    const bool flip_x = flip & 1, flip_y = flip & 2;
    if ((flip_x && !by_x) || (flip_y && !by_y)) continue;
    Field& part = parts[flip];
    part.resize(nx * ny);
    // Part of f(x) with the required sign of f(-x).
    const double sign_x = odd_x != flip_x ? -1 : 1, sign_y = odd_y != flip_y ? -1 : 1;
    for (std::ptrdiff_t j = 0; j < ny; ++j) {
      for (std::ptrdiff_t i = 0; i < nx; ++i) {
        double sum = 0.0;
        for (const int sx : {1, -1}) {
          if (sx < 0 && !by_x) continue;
          for (const int sy : {1, -1}) {
            if (sy < 0 && !by_y) continue;
            const double weight = (sx < 0 ? sign_x : 1) * (sy < 0 ? sign_y : 1);
            sum += weight * table[index(x0, i, offsets.x[0] == 0, sx) * pitch +
                                  index(y0, j, offsets.y[0] == 0, sy)];
          }
        }
        part[j * nx + i] = scale * sum / ((by_x ? 2 : 1) * (by_y ? 2 : 1));
      }
    }
  }
  return parts;
}

/// Difference between u_z of a half-space that is heated uniformly and laterally held, -(1 + nu)/(1
/// - nu) times the integral of the temperature, and the limit of long waves that the kernel
/// contains, over that of the kernel; 0 unless the surface is periodic along x and y.
double mean_displacement(const Heating& heating, double nu, double dx, double dy) {
  if (heating.period_x == 0 || heating.period_y == 0) return 0.0;
  const double share = dx * dy / (heating.period_x * heating.period_y);
  return (2 - 1 / (1 - nu)) * share * heating.thermal.substrate.diffusivity * heating.age;
}

}  // namespace

std::vector<HeatPart> heat_stress_parts(const Heating& heating) {
  std::vector<HeatPart> parts;
  for (int c = 0; c < 6; ++c) {
    const auto at_rest = kernels::component_parity(c);
    for (int flip = 0; flip < 4; ++flip) {
      const bool flip_x = flip & 1, flip_y = flip & 2;
      if ((flip_x && heating.speed_x == 0) || (flip_y && heating.speed_y == 0)) continue;
      parts.push_back({c, flip, {at_rest.odd_x != flip_x, at_rest.odd_y != flip_y, at_rest.odd_z}});
    }
  }
  return parts;
}

ParityParts heat_displacement(const Heating& heating, double nu, double dx, double dy,
                              const Offsets& offsets) {
  const Thermal& body = heating.thermal.substrate;
  const double scale = heating.factor * body.expansion * (1 + nu) / body.conductivity;
  if (!heating.is_steady_at_rest()) {
    Field table = kernels::heat_displacement(source_of(heating, dx, dy),
                                             points_of(heating, offsets), table_tol);
    const double mean = mean_displacement(heating, nu, dx, dy);
    for (double& u : table) u += mean;
    return split(heating, offsets, table.data(), false, false, scale);
  }
  ParityParts parts;
  for (const double y : offsets.y) {
    for (const double x : offsets.x) {
      parts[0].push_back(
          scale * kernels::steady_heat_displacement(x, y, dx / 2, dy / 2, heating.reference));
    }
  }
  return parts;
}

std::array<ParityParts, 6> heat_stress(const Heating& heating, const Elastic& elastic, double dx,
                                       double dy, double z, const Offsets& offsets) {
  const Thermal& body = heating.thermal.substrate;
  const double scale = heating.factor * elastic.E * body.expansion / body.conductivity;
  std::array<ParityParts, 6> stress;
  if (!heating.is_steady_at_rest()) {
    const auto points = points_of(heating, offsets);
    const Field table =
        kernels::heat_stress(source_of(heating, dx, dy), points, z, elastic.nu, table_tol);
    const std::size_t plane = points.x.size() * points.y.size();
    for (int c = 0; c < 6; ++c) {
      const auto parity = kernels::component_parity(c);
      stress[c] = split(heating, offsets, table.data() + c * plane, parity.odd_x, parity.odd_y,
                        scale / (1 - elastic.nu));
    }
    return stress;
  }
  for (const double y : offsets.y) {
    for (const double x : offsets.x) {
      const auto s = kernels::steady_heat_stress(x, y, z, dx / 2, dy / 2);
      stress[0][0].push_back(scale * s[0]);
      stress[1][0].push_back(scale * s[1]);
      stress[5][0].push_back(scale * s[2]);
    }
  }
  return stress;
}

ParityParts heat_temperature(const Heating& heating, double dx, double dy, double z,
                             const Offsets& offsets) {
  const double scale = heating.factor / heating.thermal.substrate.conductivity;
  const Field table = kernels::heat_temperature(source_of(heating, dx, dy),
                                                points_of(heating, offsets), z, table_tol);
  return split(heating, offsets, table.data(), false, false, scale);
}

}  // namespace samcontact::operators
