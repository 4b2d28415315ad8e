// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/periodic/cell_influence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "samcontact/base/threads.hpp"
#include "samcontact/kernels/far_displacement.hpp"
#include "samcontact/kernels/surface_traction.hpp"
#include "samcontact/kernels/wave.hpp"
#include "samcontact/operators/influence/corner_sums.hpp"

namespace samcontact::operators {
namespace {

using std::numbers::pi;

/// u_z due to pressure on a cell of 1 by `aspect`: multipole moments at large distances, and a
/// table of corner sums at small ones.
class UnitPressure {
 public:
  explicit UnitPressure(double aspect) : aspect_(aspect), far_(1.0, aspect) {}

  /// The one of this aspect that this thread used last, or a new one: grids of a multilevel solver,
  /// both bodies, and subdomains share it.
  static UnitPressure& of(double aspect) {
    static thread_local std::optional<UnitPressure> last;
    if (!last || last->aspect_ != aspect) last.emplace(aspect);
    return *last;
  }

  const kernels::FarDisplacement& far() const { return far_; }

  /// Row of the table at an offset of j cells.
  const double* row(int j) const { return close_.data() + static_cast<std::size_t>(j) * nx_; }

  /// Extends the table to at least nx by ny offsets.
  void cover(int nx, int ny) {
    if (nx <= nx_ && ny <= ny_) return;
    nx_ = std::max(nx, nx_);
    ny_ = std::max(ny, ny_);
    constexpr std::array<std::size_t, 1> exchanged{0};
    close_ = corner_sums<1>(
        CellOffsets::lattice(nx_, ny_), aspect_, 1,
        [](double x, double y) { return std::array{kernels::pressure_displacement(x, y)}; },
        &exchanged);
  }

 private:
  double aspect_;
  kernels::FarDisplacement far_;
  int nx_ = 0, ny_ = 0;
  Field close_;
};

/// Number of cells up to the largest offset below a limit.
int close_cells(const std::vector<int>& cells, const std::vector<double>& offsets, double limit) {
  int count = 0;
  for (std::size_t n = 0; n < cells.size(); ++n) {
    if (offsets[n] < limit) count = std::max(count, cells[n] + 1);
  }
  return count;
}

Field pressure_sums(const CellOffsets& offsets, double aspect) {
  const Offsets metres = offsets.in_metres(1.0, aspect);
  const std::vector<double>&x = metres.x, &y = metres.y;
  UnitPressure& unit = UnitPressure::of(aspect);
  const double limit = unit.far().valid_from();
  unit.cover(close_cells(offsets.x, x, limit), close_cells(offsets.y, y, limit));
  Field sums(x.size() * y.size());
#pragma omp parallel for schedule(static) if (100.0 * sums.size() > min_parallel_operations)
  for (std::ptrdiff_t j = 0; j < std::ssize(y); ++j) {
    double* row = sums.data() + j * x.size();
    unit.far().evaluate(x.data(), y[j], x.size(), row);
    if (y[j] >= limit) continue;
    const double* close = unit.row(offsets.y[j]);
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (x[i] < limit) row[i] = close[offsets.x[i]];
    }
  }
  return sums;
}

/// Indices of xx, yy, zz, yz, xz, xy after x and y are exchanged, and of xx, yy, yz, xz, xy.
constexpr std::array<std::size_t, 6> exchanged_full{1, 0, 2, 4, 3, 5},
    exchanged_deviator{1, 0, 3, 2, 4, 5};

/// Components xx, yy, zz, yz, xz, xy with x and y exchanged.
std::array<double, 6> rotated(const std::array<double, 6>& s) {
  return {s[1], s[0], s[2], s[4], s[3], s[5]};
}

/// Corner sums of an infinite row of cells, from the functions of a strip: [component][i].
template <class Function>
Field strip_sums(int nx, double d, const Function& function) {
  Field sums(6 * static_cast<std::size_t>(nx));
  for (int i = 0; i < nx; ++i) {
    const auto upper = function((i + 0.5) * d), lower = function((i - 0.5) * d);
    for (int c = 0; c < 6; ++c) sums[c * nx + i] = (upper[c] - lower[c]) / pi;
  }
  return sums;
}

std::array<double, 6> bar_displacement(Axis axis, double x, double z, double nu) {
  if (axis == Axis::z) return kernels::bar_displacement(x, z, nu);
  return axis == Axis::x ? kernels::bar_displacement_across(x, z, nu)
                         : kernels::bar_displacement_along(x, z);
}

kernels::Stress strip_stress(Traction traction, double x, double z, double nu) {
  if (traction == Traction::pressure) return kernels::strip_pressure_stress(x, z, nu);
  if (traction == Traction::shear_x) return kernels::strip_shear_stress(x, z, nu);
  return kernels::strip_antiplane_stress(x, z);
}

/// Stress below a uniform load: in-plane strain is zero.
std::vector<double> uniform_stress(Traction traction, double nu) {
  if (traction == Traction::pressure) {
    const double along = -nu / (1 - nu);
    return {along, along, -1.0, 0.0, 0.0, 0.0};
  }
  if (traction == Traction::shear_x) return {0.0, 0.0, 0.0, 0.0, -1.0, 0.0};
  return {0.0, 0.0, 0.0, -1.0, 0.0, 0.0};
}

/// Displacement along an axis due to a Fourier mode, times the shear modulus.
double wave_displacement(Traction traction, Axis axis, double kx, double ky, double nu) {
  if (traction == Traction::shear_y) {
    return wave_displacement(Traction::shear_x, exchanged(axis), ky, kx, nu);
  }
  const auto u = traction == Traction::pressure ? kernels::pressure_wave_displacement(kx, ky, nu)
                                                : kernels::shear_wave_displacement(kx, ky, nu);
  return u[static_cast<int>(axis)];
}

/// Primitive of the displacement due to a line load at x = 0 whose Fourier mode is 1/k: even, with
/// ln(reference/x), or odd, a step.
double line_primitive(double x, bool odd, double reference) {
  if (odd) return 0.5 * std::fabs(x);
  return x == 0 ? 0.0 : -(x * std::log(std::fabs(x) / reference) - x) / pi;
}

}  // namespace

kernels::Parity compliance_parity(Traction traction, Axis axis) {
  const auto load = vector_parity(traction), moved = vector_parity(traction_along(axis));
  return {load.odd_x != moved.odd_x, load.odd_y != moved.odd_y, false};
}

kernels::Parity stress_parity(Traction traction, int component) {
  const auto load = vector_parity(traction), own = kernels::component_parity(component);
  return {load.odd_x != own.odd_x, load.odd_y != own.odd_y, own.odd_z};
}

const std::array<std::size_t, 6>& exchanged_places(Tensor tensor) {
  return tensor == Tensor::full ? exchanged_full : exchanged_deviator;
}

kernels::Stress select(kernels::Stress s, Tensor tensor) {
  if (tensor == Tensor::full) return s;
  const double mean = (s[0] + s[1] + s[2]) / 3;
  return {s[0] - mean, s[1] - mean, s[3], s[4], s[5], 0.0};
}

kernels::Stress wave_stress(Traction traction, double kx, double ky, double z, double nu) {
  if (traction == Traction::pressure) return kernels::pressure_wave_stress(kx, ky, z, nu);
  if (traction == Traction::shear_x) return kernels::shear_wave_stress(kx, ky, z, nu);
  return rotated(kernels::shear_wave_stress(ky, kx, z, nu));
}

kernels::Stress wave_mean(Traction traction, double kx, double ky, double z0, double z1,
                          double nu) {
  if (traction == Traction::pressure) return kernels::pressure_wave_mean(kx, ky, z0, z1, nu);
  if (traction == Traction::shear_x) return kernels::shear_wave_mean(kx, ky, z0, z1, nu);
  return rotated(kernels::shear_wave_mean(ky, kx, z0, z1, nu));
}

Field selected(Field six, Tensor tensor) {
  if (tensor == Tensor::full) return six;
  const std::size_t plane = six.size() / 6;
  Field five(5 * plane);
  for (std::size_t n = 0; n < plane; ++n) {
    const double mean = (six[n] + six[plane + n] + six[2 * plane + n]) / 3;
    five[n] = six[n] - mean;
    five[plane + n] = six[plane + n] - mean;
    for (int c = 2; c < 5; ++c) five[c * plane + n] = six[(c + 1) * plane + n];
  }
  return five;
}

double betti_factor(Traction traction, int component) {
  const auto parity = stress_parity(traction, component);
  return (parity.odd_x != parity.odd_y ? -1.0 : 1.0) * (component < 3 ? 1.0 : 2.0);
}

double compliance_corner(Traction traction, Axis axis, double x, double y, double nu) {
  const Traction moved = traction_along(axis);
  if (traction == Traction::shear_y || (traction == Traction::pressure && axis == Axis::y)) {
    return compliance_corner(exchanged(traction), exchanged(axis), y, x, nu);
  }
  if (traction == moved) {
    return axis == Axis::z ? kernels::pressure_displacement(x, y)
                           : kernels::along_displacement(x, y, nu);
  }
  // Betti's theorem: the tangential displacement due to pressure follows from the normal
  // displacement due to shear.
  return axis == Axis::y ? kernels::cross_displacement(x, y, nu)
                         : kernels::shear_displacement(x, y);
}

double compliance_factor(const Elastic& elastic, Traction traction, Axis axis) {
  if (traction == Traction::pressure && axis == Axis::z) return elastic.normal_compliance();
  if (axis == Axis::z) return 0.5 * elastic.coupling_compliance();
  if (traction == Traction::pressure) return -0.5 * elastic.coupling_compliance();
  return 0.5 / elastic.shear_modulus();
}

Field cell_compliance(const Elastic& elastic, Traction traction, Axis axis, const Grid& grid,
                      const CellOffsets& offsets) {
  const double aspect = grid.dy / grid.dx, nu = elastic.nu;
  Field table = traction == Traction::pressure && axis == Axis::z
                    ? pressure_sums(offsets, aspect)
                    : corner_sums(offsets, aspect, [=](double x, double y) {
                        return compliance_corner(traction, axis, x, y, nu);
                      });
  const double factor = compliance_factor(elastic, traction, axis) * (grid.dx / pi);
  for (double& value : table) value *= factor;
  return table;
}

CellInfluence compliance_of_cell(const Elastic& elastic, Traction traction, Axis axis,
                                 const Grid& grid) {
  const auto parity = compliance_parity(traction, axis);
  const double nu = elastic.nu, softness = 1 / elastic.shear_modulus();
  CellInfluence influence;
  influence.parities = {parity};
  influence.uniform = {0.0};
  influence.cell = [=](int nx, int ny) {
    return cell_compliance(elastic, traction, axis, grid, CellOffsets::lattice(nx, ny));
  };
  influence.wave = [=](double kx, double ky, double* value) {
    *value = softness * wave_displacement(traction, axis, kx, ky, nu);
  };
  influence.strip = [=](int nx) {
    Field sums(nx, 0.0);
    if (parity.odd_y) return sums;
    const double factor = softness * wave_displacement(traction, axis, 1.0, 0.0, nu);
    // With both directions periodic the reference has no effect.
    const double reference = grid.period.reference > 0 ? grid.period.reference : grid.dx;
    for (int i = 0; i < nx; ++i) {
      sums[i] = factor * (line_primitive((i + 0.5) * grid.dx, parity.odd_x, reference) -
                          line_primitive((i - 0.5) * grid.dx, parity.odd_x, reference));
    }
    return sums;
  };
  return influence;
}

kernels::Stress stress_corner(Traction traction, double x, double y, double z, double nu) {
  if (traction == Traction::pressure) return kernels::pressure_stress(x, y, z, nu);
  if (traction == Traction::shear_x) return kernels::shear_stress(x, y, z, nu);
  return rotated(kernels::shear_stress(y, x, z, nu));
}

Field cell_stress(double nu, Traction traction, const Grid& grid, const CellOffsets& offsets,
                  double z, Tensor tensor) {
  const auto corner = [&](double x, double y) {
    auto s = select(stress_corner(traction, x, y, z / grid.dx, nu), tensor);
    for (double& v : s) v /= 2 * pi;
    return s;
  };
  return corner_sums<6>(offsets, grid.dy / grid.dx, count(tensor), corner,
                        traction == Traction::pressure ? &exchanged_places(tensor) : nullptr);
}

CellInfluence stress_of_cell(double nu, Traction traction, const Grid& grid, double z) {
  CellInfluence influence;
  for (int c = 0; c < 6; ++c) influence.parities.push_back(stress_parity(traction, c));
  influence.uniform = uniform_stress(traction, nu);
  influence.cell = [=](int nx, int ny) {
    return cell_stress(nu, traction, grid, CellOffsets::lattice(nx, ny), z, Tensor::full);
  };
  influence.wave = [=](double kx, double ky, double* stress) {
    std::ranges::copy(wave_stress(traction, kx, ky, z, nu), stress);
  };
  influence.strip = [=](int nx) {
    return strip_sums(nx, grid.dx, [&](double x) { return strip_stress(traction, x, z, nu); });
  };
  return influence;
}

std::array<double, 6> residual_corner(Axis axis, double x, double y, double z, double nu) {
  if (axis == Axis::z) return kernels::eigenstrain_displacement(x, y, z, nu);
  if (axis == Axis::x) return kernels::eigenstrain_side_displacement(x, y, z, nu);
  return rotated(kernels::eigenstrain_side_displacement(y, x, z, nu));
}

Field cell_residual_displacement(double nu, Axis axis, const Grid& grid, const CellOffsets& offsets,
                                 int layer) {
  const auto corner = [&](double x, double y) {
    const double dz = grid.dz / grid.dx;
    auto u = residual_corner(axis, x, y, (layer + 1) * dz, nu);
    const auto upper = residual_corner(axis, x, y, layer * dz, nu);
    for (int c = 0; c < 6; ++c) u[c] = (u[c] - upper[c]) * grid.dx / (2 * pi);
    return u;
  };
  return corner_sums<6>(offsets, grid.dy / grid.dx, 6, corner,
                        axis == Axis::z ? &exchanged_places(Tensor::full) : nullptr);
}

CellInfluence residual_of_cell(double nu, Axis axis, const Grid& grid, int layer) {
  const double z0 = layer * grid.dz, z1 = (layer + 1) * grid.dz, h = grid.dz;
  // Betti's theorem: the work of a traction on the displacement equals that of its stress on the
  // eigenstrain.
  const Traction traction = traction_along(axis);
  CellInfluence influence;
  std::array<double, 6> factors{};
  const auto uniform = uniform_stress(traction, nu);
  for (int c = 0; c < 6; ++c) {
    const auto parity = stress_parity(traction, c);
    factors[c] = betti_factor(traction, c);
    influence.parities.push_back(parity);
    influence.uniform.push_back(h * factors[c] * uniform[c]);
  }
  influence.wave = [=](double kx, double ky, double* u) {
    const auto stress = wave_mean(traction, kx, ky, z0, z1, nu);
    for (int c = 0; c < 6; ++c) u[c] = h * stress[c] * factors[c];
  };
  influence.cell = [=](int nx, int ny) {
    return cell_residual_displacement(nu, axis, grid, CellOffsets::lattice(nx, ny), layer);
  };
  influence.strip = [=](int nx) {
    return strip_sums(nx, grid.dx, [&](double x) {
      auto u = bar_displacement(axis, x, z1, nu);
      const auto lower = bar_displacement(axis, x, z0, nu);
      for (int c = 0; c < 6; ++c) u[c] -= lower[c];
      return u;
    });
  };
  return influence;
}

}  // namespace samcontact::operators
