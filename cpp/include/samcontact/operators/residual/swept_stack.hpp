// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of a body as the sweeps of the fast residual stress meet them, and the numbers that a
// wavenumber has for them.
#pragma once

#include <cmath>
#include <vector>

#include "samcontact/base/stack.hpp"

namespace samcontact::operators::layers {

/// A layer of the body with cells of equal thickness, or with none.
struct SweptLayer {
  Elastic elastic;
  double thickness;  // [m], infinite that of the substrate
  int cells;
  double cell;  // thickness of one [m]
};

/// What a wavenumber q has of numbers for cells, x = q h with their thickness h, means over a cell.
enum Coefficient {
  direction_x,    // kx / q
  direction_y,    // ky / q
  thickness,      // x
  decay,          // exp(-x)
  own,            // (q/2) exp(-q r) over the half of the own cell above or below
  own_linear,     // the same of q r exp(-q r)
  other,          // (q/2) exp(-q r) over a neighbouring cell
  other_shift,    // what q r exp(-q r) lacks of distance in cells times x, in units of other
  leaving,        // (q/2) exp(-q r) at the face of a cell
  leaving_shift,  // what q r exp(-q r) has there, in units of leaving
  share,          // what the stress is multiplied by
  coefficient_count
};

/// Those of a body with cells dz thick down to a depth of nz of them; what lies below is a layer of
/// its own. Throws std::invalid_argument where an interface lies inside one.
std::vector<SweptLayer> swept_layers(const Stack& body, int nz, double dz);

class SweptStack {
 public:
  /// on_rigid: what the last layer lies on; else it is without end.
  SweptStack(const std::vector<SweptLayer>& layers, bool on_rigid);
  SweptStack(const Stack& body, int nz, double dz)
      : SweptStack(swept_layers(body, nz, dz), body.substrate.is_rigid()) {}

  /// How many numbers are kept of each wavenumber.
  int numbers() const { return numbers_; }
  /// Writes them, `step` apart. kx, ky: the wavevector [1/m].
  void fill_mode(double kx, double ky, double weight, double* mode, int step) const;

  struct Layer {
    int first, last;      // of its cells
    double nu, lame, mu;  // [-], [Pa], [Pa]
    double depth;         // its thickness [m]
    double over_cell;     // the same over that of its cells
    int mode;             // the first coefficient of its cells
    int through;          // the place of exp(-q depth)
    bool is_endless() const { return std::isinf(depth); }
  };
  /// From the surface down.
  const std::vector<Layer>& layers() const { return layers_; }
  int cells() const { return layers_.back().last; }

 private:
  std::vector<Layer> layers_;
  std::vector<double> thicknesses_;  // of cells: each has coefficients
  int numbers_ = 0;
};

}  // namespace samcontact::operators::layers
