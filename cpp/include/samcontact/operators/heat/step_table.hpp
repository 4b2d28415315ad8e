// SPDX-License-Identifier: GPL-3.0-or-later
// Fourier modes of a body, at rest or moving, under a heat flux that has been constant for a time.
#pragma once

#include <array>
#include <complex>
#include <functional>
#include <span>
#include <vector>

namespace samcontact::operators {

/// Chebyshev panels of one octave in the logarithm of the wavenumber, for interpolation.
class OctavePanels {
 public:
  static constexpr int nodes = 14;  // of a panel
  /// Panel of a wavenumber, weights of its nodes, and their sum.
  struct Shares {
    int panel;
    std::array<double, nodes> of_nodes;
    double whole;
  };

  /// For wavenumbers between lowest and highest [1/m]; constant beyond.
  OctavePanels(double lowest, double highest);

  int panels() const { return panels_; }
  /// Of the nodes, in (-1, 1).
  const std::array<double, nodes>& places() const { return places_; }
  double wavenumber(int panel, double place) const;
  Shares shares(double q) const;

 private:
  int panels_;
  double first_, width_;  // in ln q
  std::array<double, nodes> places_{}, weights_{};
};

/// Functions of the wavenumber for a body at rest, interpolated on panels: a Laplace transform has
/// to be inverted for each of their nodes only.
class StepTable {
 public:
  /// Laplace transforms of the responses to a unit pulse of flux; s: rate [1/s].
  using Modes = std::function<void(double q, std::complex<double> s, std::complex<double>* values)>;

  /// For wavenumbers between lowest and highest [1/m]; constant beyond. time: since the flux was
  /// switched on [s]. count: of the functions.
  StepTable(const Modes& modes, int count, double time, double lowest, double highest);

  void at(double q, double* values) const;

 private:
  int count_;
  OctavePanels axis_;
  std::vector<double> values_;  // [panel][node][function]
};

/// Integrals of f(age) exp(-i omega age) over the ages since the flux was switched on, with the
/// responses f to a unit pulse of flux. In panels of the wavenumber, the responses are sums of
/// decaying exponentials, whose weights are interpolated as in StepTable.
class PulseTable {
 public:
  struct Flux {
    double time;         // since it was switched on [s]
    double speed;        // of the body [m/s], > 0
    double diffusivity;  // smallest of the layers [m^2/s]
    double power;        // see fit_rates()
  };

  /// For wavenumbers between lowest and highest [1/m]; constant beyond. count: of the functions.
  PulseTable(const StepTable::Modes& modes, int count, const Flux& flux, double lowest,
             double highest);

  /// omegas: |omega| <= q speed [1/s]. values: [omega][function]. weights: work space.
  void at(double q, std::span<const double> omegas, std::vector<double>& weights,
          std::complex<double>* values) const;

 private:
  struct Panel {
    double begin = 0.0;                  // age up to which heat is young [s]
    std::vector<double> rates;           // [1/s]
    std::vector<double> at_begin, left;  // exp(-rate age) at this age and at the end
    std::vector<double> weights;         // [node][function][rate, and the young heat]
  };
  Panel made(const StepTable::Modes& modes, double bottom, double top) const;

  int count_;
  Flux flux_;
  OctavePanels axis_;
  std::vector<Panel> panels_;
};

}  // namespace samcontact::operators
