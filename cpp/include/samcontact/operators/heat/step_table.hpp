// SPDX-License-Identifier: GPL-3.0-or-later
// Fourier modes of a body at rest under a heat flux that has been constant for a time.
#pragma once

#include <complex>
#include <functional>
#include <vector>

namespace samcontact::operators {

/// Functions of the wavenumber, interpolated on Chebyshev panels in its logarithm: a Laplace
/// transform has to be inverted for each of their nodes only.
class StepTable {
 public:
  /// Laplace transforms of the responses to a unit pulse of flux; s: rate [1/s].
  using Modes = std::function<void(double q, std::complex<double> s, std::complex<double>* values)>;

  /// For wavenumbers between lowest and highest [1/m]; constant beyond. time: since the flux was
  /// switched on [s]. count: of the functions.
  StepTable(const Modes& modes, int count, double time, double lowest, double highest);

  void at(double q, double* values) const;

 private:
  int count_, panels_;
  double first_, width_;         // of the panels, in ln q
  std::vector<double> places_;   // of the nodes of a panel, in (-1, 1)
  std::vector<double> weights_;  // barycentric
  std::vector<double> values_;   // [panel][node][function]
};

}  // namespace samcontact::operators
