// SPDX-License-Identifier: GPL-3.0-or-later
// One wavenumber of the residual stress of layers: sweeps through each layer, and the waves between
// interfaces.
#pragma once

#include <vector>

#include "samcontact/kernels/layered_wave.hpp"

namespace samcontact::operators {

/// A symmetric tensor in the frame turned along the wavevector (1 along it, 2 across), with 13 and
/// 23 multiplied by i: then everything is real.
struct TurnedTensor {
  double t11 = 0.0, t22 = 0.0, t33 = 0.0, t12 = 0.0, t13 = 0.0, t23 = 0.0;
};

/// Scratch of one thread.
class StackSweep {
 public:
  /// layer_of: the layer of the stack that each layer of cells, `h` thick, lies in.
  StackSweep(const Stack& stack, const std::vector<int>& layer_of, double h);

  /// q >= 0 [1/m].
  void set_wavenumber(double q);
  /// Replaces the eigenstress of each layer of cells by its mean stress.
  void apply(std::vector<TurnedTensor>& tensor);

 private:
  using Vector = kernels::LayeredWave::Vector;
  /// Means and integrals over a layer of cells, x = q h.
  struct Cell {
    double x, e, mean, mean_linear, own, own_linear;
  };
  /// What leaves a layer of the stack, amplitudes in the plane and across, down at its bottom and
  /// up at its top; then the waves that interfaces send into it.
  struct Waves {
    Vector down = Vector::Zero(), up = Vector::Zero(), a = Vector::Zero(), b = Vector::Zero();
    double across_down = 0.0, across_up = 0.0, across_a = 0.0, across_b = 0.0;
  };
  void add_infinite_space(const std::vector<TurnedTensor>& source, int sign);
  void reflect();
  void add_waves();
  void add_uniform(std::vector<TurnedTensor>& tensor) const;

  kernels::LayeredWave wave_;
  std::vector<int> layer_of_;
  double h_, q_ = 0.0;
  Cell cell_{};
  std::vector<Waves> waves_;
  std::vector<TurnedTensor> stress_;
};

}  // namespace samcontact::operators
