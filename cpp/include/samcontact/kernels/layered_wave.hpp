// SPDX-License-Identifier: GPL-3.0-or-later
// Transfer functions of layers on a substrate for Fourier modes of surface traction exp(i (kx x +
// ky y)): impedances and reflections from the bottom up, without growing exponentials
// (docs/theory/layers.md).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "samcontact/base/stack.hpp"
#include "samcontact/kernels/surface_traction.hpp"

namespace samcontact::kernels {

/// Surface displacement times the wavenumber [1/Pa]: along the wavevector due to shear along it;
/// along the wavevector due to pressure (equal to the downward displacement due to shear);
/// downwards due to pressure; and across the wavevector due to shear across. All are > 0 except the
/// second.
struct WaveCompliance {
  double along, coupling, down, across;
};
/// Compliance of a homogeneous half-space, independent of the wavenumber.
WaveCompliance wave_compliance(const Elastic& elastic);

/// exp(-y) and y exp(-y) at a depth of y wavelengths / (2 pi), or their means over depths.
struct WaveDecay {
  double e, ye;
  static WaveDecay at(double y);
  static WaveDecay mean(double y0, double y1);
};

/// Work space of one thread; set_wavenumber() must be called first.
class LayeredWave {
 public:
  explicit LayeredWave(const Stack& stack);

  using Matrix = Eigen::Matrix2d;
  using Vector = Eigen::Vector2d;
  /// Matrices of one layer: (T, N) and (q U, q W) from amplitudes (P, F) at the top for modes that
  /// decay downwards, and at the bottom for modes that decay upwards.
  struct Layer {
    Matrix traction_down, traction_up, displacement_down, displacement_up;
    double nu, softness, thickness, top;
    // For the present wavenumber: decay through the layer; upward modes at the bottom due to
    // downward modes there, and due to a unit free displacement of the material below; downward
    // modes due to tractions at the top, and displacement there.
    Matrix decay = Matrix::Zero(), reflection = Matrix::Zero(), of_below = Matrix::Zero(),
           to_amplitude = Matrix::Zero(), compliance = Matrix::Zero();
    // Counterparts for modes across the wavevector.
    double across_decay = 0.0, across_reflection = 0.0, across_of_below = 0.0,
           across_to_amplitude = 0.0, across_compliance = 0.0;
  };

  /// From the surface down, the substrate last unless it is rigid.
  const std::vector<Layer>& layers() const { return layers_; }

  /// q > 0 [1/m].
  void set_wavenumber(double q);
  WaveCompliance compliance() const;

  /// exp(-y) and y exp(-y) in one layer, of modes that decay from its top and from its bottom: at a
  /// depth, or their means over z0 < z < z1.
  struct Decays {
    WaveDecay down, up;
  };
  Decays at(int layer, double z) const;
  Decays mean(int layer, double z0, double z1) const;
  /// Stress xx, yy, zz, yz, xz, xy [-] due to unit pressure and due to unit shear along x, the real
  /// factors of kernels/wave.hpp, for the given direction of the wavevector.
  Stress under_pressure(int layer, const Decays& decays, double cos, double sin) const;
  Stress under_shear_x(int layer, const Decays& decays, double cos, double sin) const;

 private:
  /// Amplitudes of modes that decay from the top (a) and from the bottom (b) of a layer, in the
  /// plane of the wavevector and across it.
  struct Amplitudes {
    Vector a, b;
    double across_a, across_b;
  };
  /// Amplitudes for tractions (T, N) and T_2 on the surface.
  Amplitudes amplitudes(int layer, Vector traction, double across) const;
  /// Stress in the frame of the wavevector.
  struct Rotated;
  Rotated rotated(int layer, const Decays& decays, const Vector& traction, double across) const;

  std::vector<Layer> layers_;
  bool on_rigid_;
  double q_ = 0.0;
  WaveCompliance compliance_{};
};

}  // namespace samcontact::kernels
