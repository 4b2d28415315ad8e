// SPDX-License-Identifier: GPL-3.0-or-later
// Part of a heat history that is so young and so fine that it stays within a few cells: large
// wavenumbers w of a body at rest (see heat_modes.hpp).
//
// For times t that are not too short, exp(-lambda t) is a smooth function of ln lambda: its values
// at a few rates determine it at all others. A few fields that decay at these rates therefore
// replace all modes, and the sums over modes are short tables that are convolved with these fields.
#pragma once

#include <array>
#include <vector>

#include "samcontact/operators/heat/heat_modes.hpp"

namespace samcontact::operators {

/// Tables [rate][i][j] of a kernel at offsets >= 0; components are added as required.
struct NearTables {
  std::array<Field, 6> components;
};

class NearHeat {
 public:
  /// Represents the part that `modes` leaves, which is zero unless modes.is_split. Keeps a
  /// reference.
  explicit NearHeat(const HeatModes& modes);

  const std::vector<double>& rates() const { return rates_; }
  /// Depth below which this part vanishes.
  double depth() const { return depth_; }

  NearTables temperature(double z) const;
  NearTables displacement() const;
  NearTables stress(double z, double nu) const;

  /// Spectra of the fields of all rates [rate][i][j] at an age.
  ComplexField spectra(const Field& fields, double age) const;
  /// plane[i][j] += sum over rates of tables * fields.
  void add(const Field& tables, bool odd_x, bool odd_y, const ComplexField& spectra,
           double* plane) const;

 private:
  template <class Symbol>
  NearTables tabulate(double z, int components, const Symbol& symbol) const;
  /// cos or sin of offset times wavenumber of the transform, [offset][wavenumber].
  static Field waves(int m, int offsets, bool odd);

  const HeatModes& modes_;
  std::vector<double> rates_;
  double depth_ = 0;
  int offsets_x_ = 0, offsets_y_ = 0;
};

}  // namespace samcontact::operators
