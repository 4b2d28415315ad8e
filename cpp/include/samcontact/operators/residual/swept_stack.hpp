// SPDX-License-Identifier: GPL-3.0-or-later
// Layers of a body for the sweeps of the fast residual stress, and their coefficients for a
// wavenumber.
#pragma once

#include <cmath>
#include <vector>

#include "samcontact/base/stack.hpp"

namespace samcontact::operators::layers {

/// Layer of the body with cells of equal thickness, or without cells.
struct SweptLayer {
  Elastic elastic;
  double thickness;  // [m], infinite for the substrate
  int cells;
  double cell;  // thickness of one cell [m]
};

/// Coefficients of a wavenumber q for cells of thickness h, x = q h, as means over a cell.
enum Coefficient {
  direction_x,    // kx / q
  direction_y,    // ky / q
  thickness,      // x
  decay,          // exp(-x)
  own,            // (q/2) exp(-q r) over the half of the own cell above or below
  own_linear,     // likewise for q r exp(-q r)
  other,          // (q/2) exp(-q r) over a neighbouring cell
  other_shift,    // missing distance of q r exp(-q r) in cells times x, in units of `other`
  leaving,        // (q/2) exp(-q r) at the face of a cell
  leaving_shift,  // likewise for q r exp(-q r), in units of `leaving`
  share,          // factor of the stress
  coefficient_count
};

/// Layers of a body with nz cells of thickness dz, below k0 layers without cells; the parts above
/// and below the cells are layers of their own. Throws std::invalid_argument if an interface lies
/// inside a cell.
std::vector<SweptLayer> swept_layers(const Stack& body, int k0, int nz, double dz);

class SweptStack {
 public:
  /// on_rigid: whether the last layer lies on a rigid base; otherwise it is infinite.
  SweptStack(const std::vector<SweptLayer>& layers, bool on_rigid);
  SweptStack(const Stack& body, int k0, int nz, double dz)
      : SweptStack(swept_layers(body, k0, nz, dz), body.substrate.is_rigid()) {}

  /// Number of coefficients of each wavenumber.
  int numbers() const { return numbers_; }
  /// Writes the coefficients, `step` apart. kx, ky: wavevector [1/m].
  void fill_mode(double kx, double ky, double weight, double* mode, int step) const;

  struct Layer {
    int first, last;      // of its cells
    double nu, lame, mu;  // [-], [Pa], [Pa]
    double depth;         // its thickness [m]
    double over_cell;     // ratio of its thickness to that of its cells
    int mode;             // index of the first coefficient of its cells
    int through;          // index of exp(-q depth)
    bool is_endless() const { return std::isinf(depth); }
  };
  /// From the surface down.
  const std::vector<Layer>& layers() const { return layers_; }
  int cells() const { return layers_.back().last; }

 private:
  std::vector<Layer> layers_;
  std::vector<double> thicknesses_;  // of cells: each has its own coefficients
  int numbers_ = 0;
};

}  // namespace samcontact::operators::layers
