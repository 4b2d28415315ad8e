// SPDX-License-Identifier: GPL-3.0-or-later
// Temperature, thermal stress and surface displacement of layers on a substrate for Fourier modes
// of heat flux exp(i (kx x + ky y)): admittances and reflections without growing exponentials, and
// without resonance (docs/theory/heat.md).
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <cstddef>
#include <vector>

#include "samcontact/base/thermal_stack.hpp"
#include "samcontact/kernels/layered_wave.hpp"

namespace samcontact::kernels {

/// Temperature of a mode of unit flux into the body. Scalar: double for real rates, or
/// std::complex<double>. Work space of one thread; set() must be called first.
template <class Scalar>
class HeatWave {
 public:
  struct Layer {
    double conductivity = 0.0, diffusivity = 0.0, thickness = 0.0;
    // For the present mode: exp(-m y) with m^2 = q^2 + rate/diffusivity, and m - q; amplitudes of
    // the waves from the top and from the bottom; decay through the layer.
    Scalar m{}, excess{}, down{}, up{}, decay{}, reflection{};
  };

  explicit HeatWave(const ThermalStack& stack);

  /// Wavenumber q > 0 [1/m]. rate: of change in the frame of the body [1/s]; 0 in a steady state at
  /// rest, i k.V if the body moves with V.
  void set(double q, Scalar rate);
  const std::vector<Layer>& layers() const { return layers_; }
  /// At y below the top of a layer, times [W/(m^2 K)]^-1.
  Scalar temperature(int layer, double y) const;

 private:
  std::vector<Layer> layers_;  // the substrate last
};

/// Counterpart with displacement and stress. A rigid substrate conducts heat, without displacement
/// and known stress.
template <class Scalar>
class HeatedWave {
 public:
  explicit HeatedWave(const HeatedStack& stack);

  void set(double q, Scalar rate);
  /// u_z of the free surface, positive into the body.
  Scalar displacement() const { return free_[1] / q_; }
  /// The same for a body that is laterally held, at wavenumber 0.
  Scalar held_displacement() const;
  /// In the frame of the wavevector: 1 along it, 2 across, 3 = z; shear: i s_13.
  struct Field {
    Scalar temperature, s11, s22, s33, shear;
  };
  Field at(int layer, double z) const;

 private:
  using Vector = Eigen::Matrix<Scalar, 2, 1>;
  /// Potential of Goodier over (1 + nu)/(1 - nu) alpha, and its derivative.
  struct Potential {
    Scalar value, slope;
  };
  /// (T, N) and (q U, q W) of the potential.
  struct Particular {
    Vector traction, displacement;
  };
  /// At the top and at the bottom of a layer.
  std::array<Potential, 2> potentials(std::size_t layer) const;
  Particular particular(std::size_t layer, const Potential& potential) const;
  void find_waves();

  LayeredWave elastic_;
  HeatWave<Scalar> heat_;
  std::vector<double> eigenstrain_, modulus_;  // be, and 2 G be, of each layer
  double q_ = 1.0;
  Vector free_ = Vector::Zero();   // (q U, q W) of the free surface
  std::vector<Vector> down_, up_;  // amplitudes of elastic waves of each layer
  std::vector<Vector> sent_;       // upward waves at the bottom, without downward waves
};

extern template class HeatWave<double>;
extern template class HeatWave<std::complex<double>>;
extern template class HeatedWave<double>;
extern template class HeatedWave<std::complex<double>>;

}  // namespace samcontact::kernels
