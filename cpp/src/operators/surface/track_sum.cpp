// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface/track_sum.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "samcontact/kernels/gauss.hpp"

namespace samcontact::operators {
namespace {

/// Panels of at most `listed` cells are summed cell by cell. In longer ones K is interpolated from
/// `nodes` cells: it is analytic but for the loaded cell, one length of the panel away, which
/// leaves an error of 6^-16. Panels of more than `counted` cells are integrals; the error of a sum
/// of such smooth values is 1/(24 counted^2).
constexpr double listed = 128, counted = 65536;
constexpr int nodes = 16;
/// Exponent at which the track is forgotten, and distance that no track exceeds [cells].
constexpr double forgotten = 45, longest = 1e15;
/// Offsets beyond which K follows from its asymptote: 1/x, or ln(x) if rows repeat along y.
constexpr int furthest = 1 << 28, furthest_in_rows = 4096;
/// Distance in periods along y beyond which rows act like strips.
constexpr int uniform_from = 8;

struct Panel {
  double begin, end;         // cells begin <= n < end
  std::vector<double> at;    // nodes
  std::vector<double> bary;  // barycentric weights of the nodes; empty: every cell is a node

  Panel(double begin_, double end_) : begin(begin_), end(end_) {
    const double length = end - begin;
    if (length <= listed) {
      for (double n = begin; n < end; ++n) at.push_back(n);
      return;
    }
    for (int k = nodes; k-- > 0;) {
      const double c = std::cos(std::numbers::pi * (k + 0.5) / nodes);
      at.push_back(std::round(begin + 0.5 * (length - 1) * (1 + c)));
    }
    for (int k = 0; k < nodes; ++k) {
      double product = 1.0;
      for (int l = 0; l < nodes; ++l) {
        if (l != k) product *= (at[k] - at[l]) / (0.25 * length);
      }
      bary.push_back(1 / product);
    }
  }

  /// Adds `amount` times the values of the interpolating polynomials at n.
  void interpolate(double n, double amount, std::vector<double>& weights) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < at.size(); ++k) {
      if (n == at[k]) {
        weights[k] += amount;
        return;
      }
      sum += bary[k] / (n - at[k]);
    }
    for (std::size_t k = 0; k < at.size(); ++k) weights[k] += amount * bary[k] / (n - at[k]) / sum;
  }

  /// Weights of the nodes in the sum of exp(-decay (n - origin)) K(n).
  std::vector<double> weights(double decay, double origin) const {
    std::vector<double> sums(at.size(), 0.0);
    const auto kept = [&](double n) { return n == origin ? 1.0 : std::exp(-decay * (n - origin)); };
    if (bary.empty()) {
      for (std::size_t k = 0; k < at.size(); ++k) sums[k] = kept(at[k]);
    } else if (end - begin <= counted) {
      for (double n = begin; n < end; ++n) interpolate(n, kept(n), sums);
    } else {
      static const auto quadrature = kernels::gauss_legendre(24);
      constexpr int parts = 4;
      const double length = (end - begin) / parts;
      for (int part = 0; part < parts; ++part) {
        for (const auto& [where, weight] : quadrature) {
          const double n = begin - 0.5 + (part + where) * length;
          interpolate(n, length * weight * kept(n), sums);
        }
      }
    }
    return sums;
  }
};

std::vector<Panel> panels_of(double first, const std::vector<double>& decays) {
  std::vector<Panel> panels;
  const double slowest = *std::min_element(decays.begin(), decays.end());
  for (double begin = first; begin < longest; begin *= 2) {
    if (begin > first && (begin - first) * slowest > forgotten) break;
    panels.emplace_back(begin, 2 * begin);
  }
  return panels;
}

/// K at any distance along x.
class FarKernel {
 public:
  FarKernel(const Medium& medium, Traction kind, Axis axis, const Grid& grid, int ny,
            const std::vector<Panel>& panels, int first)
      : in_rows_(grid.period.y > 0), ny_(ny) {
    const double rows = uniform_from * grid.period.y * grid.dy / grid.dx;
    limit_ = in_rows_ ? std::max({8.0 * first, 1.0 * furthest_in_rows, std::ceil(rows)}) : furthest;
    CellOffsets offsets;
    for (const Panel& panel : panels) {
      for (const double n : panel.at) {
        if (n < limit_) offsets.x.push_back(static_cast<int>(n));
      }
    }
    known_ = offsets.x.size();
    offsets.x.push_back(static_cast<int>(limit_) / 2);
    offsets.x.push_back(static_cast<int>(limit_));
    for (int j = 0; j < ny; ++j) offsets.y.push_back(j);
    columns_ = offsets.x.size();
    table_ = medium.compliance(kind, axis, grid, offsets);
  }

  /// Value at a node, which is the n-th of all nodes.
  double operator()(std::size_t n, double x, int j) const {
    const double* row = table_.data() + j * columns_;
    if (n < known_) return row[n];
    const double last = row[columns_ - 1], middle = row[columns_ - 2];
    if (!in_rows_) return last * limit_ / x;
    return last + (last - middle) * std::log(x / limit_) / std::numbers::ln2;
  }

  int rows() const { return ny_; }

 private:
  bool in_rows_;
  int ny_;
  double limit_;
  std::size_t known_, columns_;
  Field table_;
};

}  // namespace

std::vector<Field> track_sums(const Medium& medium, Traction kind, Axis axis, const Grid& grid,
                              const KernelOffsets& offsets, const std::vector<double>& decays) {
  std::vector<Field> sums(decays.size(), Field(offsets.ny, 0.0));
  if (decays.empty()) return sums;
  const std::vector<Panel> panels = panels_of(offsets.nx, decays);
  const FarKernel kernel(medium, kind, axis, grid, offsets.ny, panels, offsets.nx);
  for (std::size_t t = 0; t < decays.size(); ++t) {
    std::size_t node = 0;
    for (const Panel& panel : panels) {
      const bool counts =
          panel.begin == offsets.nx || (panel.begin - offsets.nx) * decays[t] <= forgotten;
      if (!counts) break;
      const std::vector<double> weights = panel.weights(decays[t], offsets.nx);
      for (std::size_t k = 0; k < panel.at.size(); ++k, ++node) {
        for (int j = 0; j < offsets.ny; ++j) {
          sums[t][j] += weights[k] * kernel(node, panel.at[k], j);
        }
      }
    }
  }
  return sums;
}

}  // namespace samcontact::operators
