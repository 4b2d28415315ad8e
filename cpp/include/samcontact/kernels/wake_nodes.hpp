// SPDX-License-Identifier: GPL-3.0-or-later
// Quadrature over wavenumbers of modes that vary rapidly near one wavenumber, and a few points from
// which such modes are interpolated to its nodes.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace samcontact::kernels::wake {

/// Width of a panel of quadrature over the distance from the largest offset: that of many nodes
/// and of few.
inline constexpr double long_phase = 20.0, short_phase = 4.0;
/// Width of a panel over the wavenumber of a window: that of many nodes and of few.
inline constexpr double wide_panel = 0.5, narrow_panel = 0.2;
/// Smallest wavenumber times the longest length.
inline constexpr double smallest_wave = 1e-10;
/// Powers of x and y in the field of the disc of small wavenumbers.
inline constexpr int power_count = 14;

struct Node {
  double k, weight;
};

/// Gauss panels on 0 < k < highest, at most `widest` wide and halved towards zero down to `finest`;
/// few nodes in panels narrower than `narrow`.
std::vector<Node> graded_nodes(double highest, double widest, double narrow, double finest);

/// Nodes of one octave. A function without singularities closer to it than zero is interpolated
/// from a few points, where that takes fewer of its values.
struct Octave {
  std::vector<Node> nodes;
  std::vector<double> points;  // at which the function is needed
  Eigen::MatrixXd basis;       // [node][point]; empty: the points are those of the nodes
};

/// The nodes of graded_nodes() by octaves, from the highest down.
std::vector<Octave> octaves(double highest, double widest, double narrow, double finest);

/// Terms of the series of cos(k x) or sin(k x) in powers of x [offset][power], without powers of k;
/// first: 0 or 1. extent: unit of the offsets.
Eigen::MatrixXd power_table(const std::vector<double>& offsets, double extent, int first);

}  // namespace samcontact::kernels::wake
