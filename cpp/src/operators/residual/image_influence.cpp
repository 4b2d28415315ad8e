// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/residual/image_influence.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/operators/residual/layer_sweep.hpp"

namespace samcontact::operators {
namespace {

using layers::width;
using Matrix = Eigen::MatrixXd;
constexpr int tensor = 6;
constexpr int pairs = tensor * tensor;

/// Parity of the stress `out` due to the strain `in`.
kernels::Parity pair_parity(int in, int out) {
  const auto a = kernels::component_parity(in), b = kernels::component_parity(out);
  return {a.odd_x != b.odd_x, a.odd_y != b.odd_y, false};
}

/// Factor of sines and cosines for a mode in the rotated frame, where 13 and 23 contain i.
double pair_sign(int in, int out) {
  const auto rotated = [](int component) { return component == 3 || component == 4; };
  if (rotated(in) != rotated(out)) return rotated(in) ? -1.0 : 1.0;
  const auto [odd_x, odd_y, odd_z] = pair_parity(in, out);
  return odd_x && odd_y ? -1.0 : 1.0;
}

/// Indices of pairs of components, in groups of one parity: odd in neither direction, in x, in y,
/// in both.
struct Groups {
  std::array<int, pairs> place{};
  std::array<int, 5> first{};

  Groups() {
    int next = 0;
    for (int group = 0; group < 4; ++group) {
      first[group] = next;
      for (int pair = 0; pair < pairs; ++pair) {
        const auto [odd_x, odd_y, odd_z] = pair_parity(pair / tensor, pair % tensor);
        if (odd_x + 2 * odd_y == group) place[pair] = next++;
      }
    }
    first[4] = next;
  }
};

/// Stress due to Fourier modes of unit eigenstrain in each layer of cells.
class WaveInfluence {
 public:
  explicit WaveInfluence(const layers::SweptStack& stack)
      : stack_(&stack),
        nz_(stack.cells()),
        scratch_(stack, 1),
        modes_(static_cast<std::size_t>(stack.numbers()) * width),
        strain_(static_cast<std::size_t>(tensor) * nz_ * width, 0.0),
        stress_(strain_.size()) {}

  Eigen::Index layer_pairs() const { return static_cast<Eigen::Index>(nz_) * nz_; }
  const Groups& groups() const { return groups_; }

  /// For up to `width` modes, one per column: [pair of components][field layer][source layer].
  void evaluate(const double* kx, const double* ky, int count, double* values) {
    std::ranges::fill(modes_, 0.0);
    for (int n = 0; n < count; ++n) {
      stack_->fill_mode(kx[n], ky[n], 1.0, modes_.data() + n, width);
    }
    const auto component = static_cast<std::size_t>(nz_) * width;
    const layers::Layout layout{nz_, false, {}, component, width};
    std::vector<char> used(nz_);
    for (int source = 0; source < nz_; ++source) {
      used[source] = 1;
      for (int in = 0; in < tensor; ++in) {
        double* unit =
            strain_.data() + in * component + static_cast<std::ptrdiff_t>(source) * width;
        std::fill_n(unit, width, 1.0);
        layers::sweep(*stack_, 1, layout, used.data(), modes_.data(), width, strain_.data(),
                      {layout, stress_.data(), layout, nullptr}, scratch_);
        std::fill_n(unit, width, 0.0);
        take(source, in, count, values);
      }
      used[source] = 0;
    }
  }

 private:
  void take(int source, int in, int count, double* values) const {
    const auto column = static_cast<std::size_t>(pairs) * layer_pairs();
    for (int out = 0; out < tensor; ++out) {
      const double sign = pair_sign(in, out);
      double* to =
          values + static_cast<std::size_t>(groups_.place[in * tensor + out]) * layer_pairs();
      for (int field = 0; field < nz_; ++field) {
        const double* from = stress_.data() + static_cast<std::size_t>(out * nz_ + field) * width;
        const std::size_t at = static_cast<std::size_t>(field) * nz_ + source;
        for (int n = 0; n < count; ++n) to[n * column + at] = sign * from[n];
      }
    }
  }

  const layers::SweptStack* stack_;
  int nz_;
  Groups groups_;
  layers::Scratch scratch_;
  Field modes_, strain_, stress_;
};

/// Fourier modes at offsets >= 0 along one axis.
struct Trigonometric {
  Eigen::ArrayXd even, odd;

  Trigonometric(const LatticeAxis& axis, double k) : even(axis.cells), odd(axis.cells) {
    for (int i = 0; i < axis.cells; ++i) {
      even[i] = std::cos(k * i * axis.d);
      odd[i] = std::sin(k * i * axis.d);
    }
  }
};

/// Adds modes, one per row, to the sums at offsets x + cells of x times y.
void add_waves(const WaveInfluence& influence, const Matrix& waves, const LatticeModes& modes,
               std::size_t first, const LatticeAxis& x, const LatticeAxis& y, Matrix& sums) {
  const Eigen::Index count = waves.cols();
  Matrix at_offsets[4];
  for (Matrix& matrix : at_offsets) matrix.resize(count, sums.cols());
  for (Eigen::Index n = 0; n < count; ++n) {
    const Trigonometric along_x(x, modes.kx[first + n]), along_y(y, modes.ky[first + n]);
    for (int group = 0; group < 4; ++group) {
      const auto& a = group % 2 == 1 ? along_x.odd : along_x.even;
      const auto& b = group > 1 ? along_y.odd : along_y.even;
      for (Eigen::Index j = 0; j < y.cells; ++j) {
        at_offsets[group].row(n).segment(j * x.cells, x.cells) =
            (modes.weight[first + n] * b[j] * a).matrix().transpose();
      }
    }
  }
  const auto& places = influence.groups().first;
  for (int group = 0; group < 4; ++group) {
    const Eigen::Index from = places[group] * influence.layer_pairs();
    const Eigen::Index rows = places[group + 1] * influence.layer_pairs() - from;
    sums.middleRows(from, rows).noalias() += waves.middleRows(from, rows) * at_offsets[group];
  }
}

/// Values at all offsets, from sums at offsets >= 0.
Field at_all_offsets(const WaveInfluence& influence, const Matrix& sums, int cx, int cy) {
  const std::ptrdiff_t wide = 2 * cx - 1, offsets = wide * (2 * cy - 1);
  const Eigen::Index layer_pairs = influence.layer_pairs();
  Field found(static_cast<std::size_t>(layer_pairs) * offsets * tensor * image_row, 0.0);
  for (int pair = 0; pair < pairs; ++pair) {
    const int in = pair / tensor, out = pair % tensor;
    const auto [odd_x, odd_y, odd_z] = pair_parity(in, out);
    const Eigen::Index row = influence.groups().place[pair] * layer_pairs;
    for (Eigen::Index layer = 0; layer < layer_pairs; ++layer) {
      for (int y = 1 - cy; y < cy; ++y) {
        for (int x = 1 - cx; x < cx; ++x) {
          const bool negative = (odd_x && x < 0) != (odd_y && y < 0);
          const double value = sums(row + layer, std::abs(y) * cx + std::abs(x));
          const Eigen::Index at = layer * offsets + (y + cy - 1) * wide + x + cx - 1;
          found[(at * tensor + in) * image_row + out] = negative ? -value : value;
        }
      }
    }
  }
  return found;
}

}  // namespace

Field image_influence(const layers::SweptStack& coarse, const LatticeAxis& x, const LatticeAxis& y,
                      double tol) {
  WaveInfluence influence(coarse);
  const auto modes = LatticeModes::of_cells(x, y, LatticeWindow::within(tol));
  const Eigen::Index rows = static_cast<Eigen::Index>(pairs) * influence.layer_pairs();
  Matrix sums = Matrix::Zero(rows, static_cast<Eigen::Index>(x.cells) * y.cells);
  // A uniform eigenstrain acts like a plate.
  Matrix uniform(rows, 1);
  const double none = 0.0;
  influence.evaluate(&none, &none, 1, uniform.data());
  const Eigen::Index even = influence.groups().first[1] * influence.layer_pairs();
  sums.topRows(even).colwise() += (x.d * y.d / (x.period * y.period)) * uniform.col(0).head(even);
  constexpr std::size_t together = std::size_t{16} * width;
  for (std::size_t first = 0; first < modes.kx.size(); first += together) {
    const std::size_t count = std::min(together, modes.kx.size() - first);
    Matrix waves(rows, static_cast<Eigen::Index>(count));
    for (std::size_t n = 0; n < count; n += width) {
      influence.evaluate(modes.kx.data() + first + n, modes.ky.data() + first + n,
                         static_cast<int>(std::min<std::size_t>(width, count - n)),
                         waves.col(static_cast<Eigen::Index>(n)).data());
    }
    add_waves(influence, waves, modes, first, x, y, sums);
  }
  return at_all_offsets(influence, sums, x.cells, y.cells);
}

}  // namespace samcontact::operators
