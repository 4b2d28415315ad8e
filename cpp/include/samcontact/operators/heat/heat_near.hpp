// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a heat history that is so young and so fine that it stays within a few cells: large
// wavenumbers w of a body at rest (see heat_modes.hpp).
//
// exp(-lambda t), t not too short, is a smooth function of ln lambda: its values at a few rates
// give it at all others. So a few fields that decay at these rates replace all modes, and the
// modes' sums are short tables that are convolved with them.
#pragma once

#include <array>
#include <vector>

#include "samcontact/operators/heat/heat_modes.hpp"

namespace samcontact::operators {

/// Tables [rate][i][j] of a kernel's offsets >= 0; components as they are filled.
struct NearTables {
  std::array<Field, 6> components;
};

class NearHeat {
 public:
  /// Of what `modes` split off; nothing unless they are split. Keeps a reference.
  explicit NearHeat(const HeatModes& modes);

  const std::vector<double>& rates() const { return rates_; }
  /// From this depth on nothing is left.
  double depth() const { return depth_; }

  NearTables temperature(double z) const;
  NearTables displacement() const;
  NearTables stress(double z, double nu) const;

  /// Spectra of all rates' fields [rate][i][j] at an age.
  ComplexField spectra(const Field& fields, double age) const;
  /// plane[i][j] += sum over rates of tables * fields.
  void add(const Field& tables, bool odd_x, bool odd_y, const ComplexField& spectra,
           double* plane) const;

 private:
  template <class Symbol>
  NearTables tabulate(double z, int components, const Symbol& symbol) const;
  /// cos or sin of offset times wavenumber of the transform, [offset][number].
  static Field waves(int m, int offsets, bool odd);

  const HeatModes& modes_;
  std::vector<double> rates_;
  double depth_ = 0;
  int offsets_x_ = 0, offsets_y_ = 0;
};

}  // namespace samcontact::operators
