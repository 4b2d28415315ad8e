// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface/coarse_grid.hpp"

#include <algorithm>

#include "samcontact/base/threads.hpp"

namespace samcontact::operators {
namespace {

/// Number of coarse cells along a box; eight of them fit into the shortest distance across the seam
/// of periods longer than it by an eighth.
constexpr int coarse_count = 64;

int coarse_factor(int cells) { return std::max(2, cells / coarse_count); }

}  // namespace

int CoarseAxis::lower(int i) const {
  return std::clamp((2 * i + 1 - factor) / (2 * factor), 0, coarse_cells() - 2);
}

double CoarseAxis::weight(int i, int I) const {
  const double beyond = (i + 0.5) / factor - 0.5 - lower(i);
  return I == lower(i) ? 1.0 - beyond : I == lower(i) + 1 ? beyond : 0.0;
}

int CoarseAxis::begin(int I) const { return std::max((I - 1) * factor, 0); }

int CoarseAxis::end(int I) const { return std::min((I + 2) * factor, cells); }

CoarseGrid::CoarseGrid(int nx, int ny)
    : x_{nx, coarse_factor(nx)}, y_{ny, coarse_factor(ny)}, y_begin_(y_.coarse_cells(), ny) {
  for (int j = ny - 1; j >= 0; --j) y_begin_[std::max(y_.lower(j), 0)] = j;
  for (int j = 0; j < ny; ++j) y_share_.push_back(y_.weight(j, y_.lower(j) + 1));
}

void CoarseGrid::gather(const double* field, double* coarse) const {
  const int nx = x_.cells, ny = y_.cells, cx = x_.coarse_cells(), cy = y_.coarse_cells();
  Field rows(static_cast<std::size_t>(nx) * cy);
  // Each thread gathers whole rows, so that no sum depends on the number of threads.
#pragma omp parallel if (static_cast<std::ptrdiff_t>(nx) * ny >= min_parallel_cells)
  {
#pragma omp for schedule(static)
    for (int i = 0; i < nx; ++i) {
      const double* p = field + static_cast<std::size_t>(i) * ny;
      double* row = rows.data() + static_cast<std::size_t>(i) * cy;
      for (int J = 0; J + 1 < cy; ++J) {
        double all = 0.0, above = 0.0;
        for (int j = y_begin_[J]; j < y_begin_[J + 1]; ++j) {
          all += p[j];
          above += y_share_[j] * p[j];
        }
        row[J] += all - above;
        row[J + 1] += above;
      }
    }
#pragma omp for schedule(static)
    for (int I = 0; I < cx; ++I) {
      double* sum = coarse + static_cast<std::size_t>(I) * cy;
      std::fill_n(sum, cy, 0.0);
      for (int i = x_.begin(I); i < x_.end(I); ++i) {
        const double* row = rows.data() + static_cast<std::size_t>(i) * cy;
        const double w = x_.weight(i, I);
        for (int J = 0; J < cy; ++J) sum[J] += w * row[J];
      }
    }
  }
}

void CoarseGrid::add(const double* coarse, double* field) const {
  const int nx = x_.cells, ny = y_.cells, cy = y_.coarse_cells();
#pragma omp parallel if (static_cast<std::ptrdiff_t>(nx) * ny >= min_parallel_cells)
  {
    Field row(cy);
#pragma omp for schedule(static)
    for (int i = 0; i < nx; ++i) {
      const double* from = coarse + static_cast<std::size_t>(x_.lower(i)) * cy;
      const double w0 = x_.weight(i, x_.lower(i)), w1 = 1.0 - w0;
      for (int J = 0; J < cy; ++J) row[J] = w0 * from[J] + w1 * from[J + cy];
      double* u = field + static_cast<std::size_t>(i) * ny;
      for (int J = 0; J + 1 < cy; ++J) {
        const double here = row[J], rise = row[J + 1] - row[J];
        for (int j = y_begin_[J]; j < y_begin_[J + 1]; ++j) u[j] += here + y_share_[j] * rise;
      }
    }
  }
}

}  // namespace samcontact::operators
