// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/residual/image_correction.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "samcontact/base/multiversion.hpp"
#include "samcontact/base/threads.hpp"
#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/operators/residual/image_influence.hpp"

namespace samcontact::operators {
namespace {

// Stress components handled together: 6, padded to a whole register.
constexpr int row_width = image_row;
constexpr int matrix = 6 * row_width;  // [in][out]
using Lanes [[gnu::vector_size(row_width * sizeof(double)), gnu::may_alias]] = double;

/// sum += matrices applied to the strain of one row of sources in y. The matrix of the first source
/// is given; the next ones are `step` doubles apart.
SAMCONTACT_MULTIVERSION
void add_row(const double* first, std::ptrdiff_t step, const double* strain, int count,
             Lanes* sum) {
  Lanes total = *sum;
  for (int n = 0; n < count; ++n, first += step, strain += 6) {
    const auto* m = reinterpret_cast<const Lanes*>(first);
    for (int in = 0; in < 6; ++in) total += m[in] * strain[in];
  }
  *sum = total;
}

/// moments[a][b] = sum_ij along_x[a][i] along_y[b][j] plane[i][j].
SAMCONTACT_MULTIVERSION
void plane_moments(const double* plane, int nx, int ny, const double* along_x, int cx,
                   const double* along_y, int cy, double* moments) {
  for (int i = 0; i < nx; ++i) {
    const double* from = plane + static_cast<std::size_t>(i) * ny;
    for (int b = 0; b < cy; ++b) {
      const double* weight = along_y + static_cast<std::size_t>(b) * ny;
      double sums[row_width] = {};
      int j = 0;
      for (; j + row_width <= ny; j += row_width) {
        for (int l = 0; l < row_width; ++l) sums[l] += weight[j + l] * from[j + l];
      }
      for (int l = 0; j < ny; ++j, ++l) sums[l] += weight[j] * from[j];
      double sum = 0.0;
      for (const double part : sums) sum += part;
      for (int a = 0; a < cx; ++a) moments[a * cy + b] += along_x[a * nx + i] * sum;
    }
  }
}

/// plane[i][j] -= sum_ab along_x[a][i] along_y[b][j] nodes[a][b].
SAMCONTACT_MULTIVERSION
void subtract_plane(const double* nodes, int nx, int ny, const double* along_x, int cx,
                    const double* along_y, int cy, double* plane) {
  for (int i = 0; i < nx; ++i) {
    double* to = plane + static_cast<std::size_t>(i) * ny;
    for (int b = 0; b < cy; ++b) {
      double value = 0.0;
      for (int a = 0; a < cx; ++a) value += along_x[a * nx + i] * nodes[a * cy + b];
      const double* weight = along_y + static_cast<std::size_t>(b) * ny;
      for (int j = 0; j < ny; ++j) to[j] -= value * weight[j];
    }
  }
}

/// Factor by which the error decreases with each coarse cell over half a period.
constexpr double rate = 2.6;

/// Number of coarse cells over half a period for a tolerance. Measured on boxes full of strain: the
/// error is 10^-(1 + 0.42 cells) of the largest stress.
int cells_over_period(double tol) {
  return std::max(static_cast<int>(std::ceil((-std::log10(tol) - 1.0) / 0.42)), 2);
}

/// Truncation of the Fourier modes, in units of the tolerance.
constexpr double neglected = 0.03;

/// Number of coarse cells over an axis whose length is `ratio` half periods, if `cells` are needed
/// over one. Over a shorter axis polynomials converge faster: by `rate` and the ratio with each
/// cell.
int cells_over_depth(double ratio, int cells) {
  const double needed = ratio < 1 ? cells / (1 - std::log(ratio) / std::log(rate)) : cells * ratio;
  return std::clamp(static_cast<int>(std::ceil(needed)), 1, 4 * cells);
}

/// Chebyshev polynomials T_0..T_{n-1} at u.
void chebyshev(double u, int n, double* values) {
  values[0] = 1.0;
  if (n > 1) values[1] = u;
  for (int k = 2; k < n; ++k) values[k] = 2 * u * values[k - 1] - values[k - 2];
}

/// Means of T_0..T_{n-1} over [a, b].
void chebyshev_means(double a, double b, int n, double* means) {
  const auto integral = [](double u, int k) {
    const double theta = std::acos(std::clamp(u, -1.0, 1.0));
    if (k == 0) return u;
    if (k == 1) return 0.5 * u * u;
    return 0.5 * (std::cos((k + 1) * theta) / (k + 1) - std::cos((k - 1) * theta) / (k - 1));
  };
  for (int k = 0; k < n; ++k) means[k] = (integral(b, k) - integral(a, k)) / (b - a);
}

}  // namespace

ImageCorrection::Axis ImageCorrection::make_axis(int fine, double d, double extent, int coarse,
                                                 int order, bool mirrored, bool means) {
  Axis axis;
  axis.fine = fft::stored_cells(fine, mirrored);
  axis.coarse = coarse;
  axis.cell = extent / coarse;
  for (Field& moments : axis.moments) {
    moments.assign(static_cast<std::size_t>(coarse) * axis.fine, 0.0);
  }
  for (Field& values : axis.interpolants) values.assign(axis.moments[0].size(), 0.0);
  // Polynomials through `order` neighbouring coarse cells; u = -1..1 over these cells.
  Eigen::MatrixXd cell_means(order, order), points(order, order);
  Eigen::VectorXd row(order);
  for (int a = 0; a < order; ++a) {
    chebyshev_means(2.0 * a / order - 1, 2.0 * (a + 1) / order - 1, order, row.data());
    cell_means.row(a) = row;
    chebyshev((2.0 * a + 1) / order - 1, order, row.data());
    points.row(a) = row;
  }
  // Cells w with sum_a w_a mean_a(T) = T(x_i) d / cell for every polynomial T; and the values at
  // x_i of the polynomials that are 1 at the centre of one cell and 0 at the others.
  const auto moments = cell_means.transpose().partialPivLu();
  const auto interpolants = points.transpose().partialPivLu();
  for (int i = 0; i < fine; ++i) {
    const double x = (i + 0.5) * d / axis.cell;
    const int first = std::clamp(static_cast<int>(std::lround(x - 0.5 * order)), 0, coarse - order);
    const double u = 2 * (x - first) / order - 1, half = d / axis.cell / order;
    if (means) {
      chebyshev_means(u - half, u + half, order, row.data());
    } else {
      chebyshev(u, order, row.data());
    }
    const Eigen::VectorXd source = moments.solve(row) * (d / axis.cell);
    const Eigen::VectorXd value = means ? moments.solve(row) : interpolants.solve(row);
    const int middle = fine - axis.fine;  // the first stored cell
    const bool stored = i >= middle;
    const int at = stored ? i - middle : fine - 1 - i - middle;
    for (int a = 0; a < order; ++a) {
      const std::size_t n = static_cast<std::size_t>(first + a) * axis.fine + at;
      axis.moments[0][n] += source(a);
      axis.moments[1][n] += stored ? source(a) : -source(a);
      if (stored) axis.interpolants[0][n] = value(a);
      if (stored && !(mirrored && fine % 2 == 1 && i == middle)) axis.interpolants[1][n] = value(a);
    }
  }
  return axis;
}

ImageCorrection::ImageCorrection(const Grid& grid, const VolumeTransform& transform,
                                 const Stack& body, double tol)
    : period_x_(transform.mx() * grid.dx), period_y_(transform.my() * grid.dy) {
  const int cells = cells_over_period(tol);
  const double shortest = 0.5 * std::min(period_x_, period_y_);
  const auto count = [&, n = cells](double extent) {
    return std::max(n, static_cast<int>(std::ceil(n * extent / shortest - 1e-9)));
  };
  x_ = make_axis(grid.nx, grid.dx, 0.5 * period_x_, count(0.5 * period_x_), cells,
                 transform.symmetry() == Symmetry::xy, false);
  y_ = make_axis(grid.ny, grid.dy, 0.5 * period_y_, count(0.5 * period_y_), cells,
                 transform.symmetry() != Symmetry::none, false);
  build_layers(grid, body, tol);
}

ImageCorrection::Axis ImageCorrection::stacked(const std::vector<Axis>& layers) {
  Axis all;
  for (const Axis& axis : layers) {
    all.fine += axis.fine;
    all.coarse += axis.coarse;
  }
  all.moments[0].assign(static_cast<std::size_t>(all.coarse) * all.fine, 0.0);
  all.interpolants[0] = all.moments[0];
  std::size_t row = 0, column = 0;
  for (const Axis& axis : layers) {
    for (int a = 0; a < axis.coarse; ++a, ++row) {
      const std::size_t from = static_cast<std::size_t>(a) * axis.fine,
                        to = row * all.fine + column;
      std::copy_n(&axis.moments[0][from], axis.fine, &all.moments[0][to]);
      std::copy_n(&axis.interpolants[0][from], axis.fine, &all.interpolants[0][to]);
    }
    column += axis.fine;
  }
  return all;
}

void ImageCorrection::build_layers(const Grid& grid, const Stack& body, double tol) {
  const int cells = cells_over_period(tol);
  const double shortest = 0.5 * std::min(period_x_, period_y_);
  auto layers = layers::swept_layers(body, grid.k0, grid.nz, grid.dz);
  std::vector<Axis> axes;
  for (auto& layer : layers) {
    if (layer.cells == 0) continue;
    const double depth = layer.cells * layer.cell;
    const int coarse = std::min(layer.cells, cells_over_depth(depth / shortest, cells));
    axes.push_back(
        make_axis(layer.cells, layer.cell, depth, coarse, std::min(coarse, cells), false, true));
    layer.cells = coarse;
    layer.cell = depth / coarse;
  }
  z_ = stacked(axes);
  const layers::SweptStack stack(layers, body.substrate.is_rigid());
  influence_ = image_influence(stack, {x_.cell, x_.coarse, period_x_},
                               {y_.cell, y_.coarse, period_y_}, neglected * tol);
}

Field ImageCorrection::coarse_strain(Tensor tensor, const double* strain) const {
  const auto places = components(tensor);
  const int parts = static_cast<int>(places.size());
  const int cx = x_.coarse, cy = y_.coarse, cz = z_.coarse, nz = z_.fine;
  const std::size_t plane = static_cast<std::size_t>(x_.fine) * y_.fine;
  const int coarse_plane = cx * cy;
  Field layers(static_cast<std::size_t>(parts) * nz * coarse_plane, 0.0);
#pragma omp parallel for schedule(static) if (2.0 * parts * nz * cy * plane > \
                                                  min_parallel_operations)
  for (int ck = 0; ck < parts * nz; ++ck) {
    const auto parity = kernels::component_parity(places[ck / nz]);
    plane_moments(strain + ck * plane, x_.fine, y_.fine, x_.moments[parity.odd_x].data(), cx,
                  y_.moments[parity.odd_y].data(), cy,
                  layers.data() + static_cast<std::size_t>(ck) * coarse_plane);
  }
  // [layer][x][y][component], all six
  Field coarse(static_cast<std::size_t>(6) * cz * coarse_plane, 0.0);
  for (int c = 0; c < parts; ++c) {
    const int place = places[c];
    for (int k = 0; k < nz; ++k) {
      const double* from = layers.data() + (static_cast<std::size_t>(c) * nz + k) * coarse_plane;
      for (int n = 0; n < cz; ++n) {
        const double weight = z_.moments[0][n * nz + k];
        double* to = coarse.data() + static_cast<std::size_t>(n) * coarse_plane * 6 + place;
        for (int p = 0; p < coarse_plane; ++p)
          to[static_cast<std::ptrdiff_t>(p) * 6] += weight * from[p];
      }
    }
  }
  if (tensor == Tensor::deviator) {
    for (std::size_t n = 0; n < coarse.size(); n += 6) coarse[n + 2] = -coarse[n] - coarse[n + 1];
  }
  return coarse;
}

Field ImageCorrection::coarse_stress(const Field& strain) const {
  const int cx = x_.coarse, cy = y_.coarse, cz = z_.coarse;
  const int wide = 2 * cx - 1, offsets = wide * (2 * cy - 1);
  Field stress(strain.size(), 0.0);
#pragma omp parallel for schedule(static) if (12.0 * strain.size() * strain.size() / 6 > \
                                                  min_parallel_operations)
  for (int target = 0; target < cz * cx; ++target) {
    const int z = target / cx, x = target % cx;
    for (int y = 0; y < cy; ++y) {
      Lanes sum{};
      for (int source = 0; source < cz; ++source) {
        const double* matrices =
            influence_.data() + static_cast<std::size_t>(z * cz + source) * offsets * matrix;
        for (int from_x = 0; from_x < cx; ++from_x) {
          const std::ptrdiff_t first =
              static_cast<std::ptrdiff_t>(y + cy - 1) * wide + x - from_x + cx - 1;
          add_row(matrices + first * matrix, -static_cast<std::ptrdiff_t>(wide) * matrix,
                  strain.data() + static_cast<std::size_t>(source * cx + from_x) * cy * 6, cy,
                  &sum);
        }
      }
      double* to = stress.data() + static_cast<std::size_t>(target * cy + y) * 6;
      for (int c = 0; c < 6; ++c) to[c] = sum[c];
    }
  }
  return stress;
}

Field ImageCorrection::stress(Tensor tensor, const double* strain) const {
  Field images = coarse_stress(coarse_strain(tensor, strain));
  if (tensor == Tensor::deviator) {
    for (std::size_t n = 0; n < images.size(); n += 6) {
      const double mean = (images[n] + images[n + 1] + images[n + 2]) / 3;
      images[n] -= mean;
      images[n + 1] -= mean;
    }
  }
  return images;
}

void ImageCorrection::subtract(Tensor tensor, const Field& images, int layer,
                               double* stress) const {
  const auto places = components(tensor);
  const int cx = x_.coarse, cy = y_.coarse, cz = z_.coarse;
  const int coarse_plane = cx * cy;
  std::vector<double> nodes(coarse_plane);
  for (std::size_t c = 0; c < places.size(); ++c) {
    std::fill(nodes.begin(), nodes.end(), 0.0);
    for (int n = 0; n < cz; ++n) {
      const double weight = z_.interpolants[0][n * z_.fine + layer];
      const double* from =
          images.data() + static_cast<std::size_t>(n) * coarse_plane * 6 + places[c];
      for (int p = 0; p < coarse_plane; ++p)
        nodes[p] += weight * from[static_cast<std::ptrdiff_t>(p) * 6];
    }
    const auto parity = kernels::component_parity(places[c]);
    subtract_plane(nodes.data(), x_.fine, y_.fine, x_.interpolants[parity.odd_x].data(), cx,
                   y_.interpolants[parity.odd_y].data(), cy,
                   stress + c * static_cast<std::size_t>(x_.fine) * y_.fine);
  }
}

}  // namespace samcontact::operators
