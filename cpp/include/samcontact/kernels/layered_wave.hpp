// SPDX-License-Identifier: GPL-3.0-or-later
// Answer of layers on a substrate to a wave of surface traction exp(i (kx x + ky y)): impedances
// and reflections from the bottom up, without growing exponentials (docs/theory/layers.md).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "samcontact/base/stack.hpp"
#include "samcontact/kernels/surface_traction.hpp"

namespace samcontact::kernels {

/// Displacement of the surface in the frame of the wave, times its wavenumber [1/Pa]: along it
/// under shear along it, along it under pressure (and down under shear), down under pressure, and
/// across under shear across. All > 0 but the second.
struct WaveCompliance {
  double along, coupling, down, across;
};
/// Of a homogeneous half-space: the same for all waves.
WaveCompliance wave_compliance(const Elastic& elastic);

/// exp(-y) and y exp(-y) at a depth y times the wavelength over 2 pi, or their means over depths.
struct WaveDecay {
  double e, ye;
  static WaveDecay at(double y);
  static WaveDecay mean(double y0, double y1);
};

/// Scratch for one thread: set_wavenumber() comes before all else.
class LayeredWave {
 public:
  explicit LayeredWave(const Stack& stack);

  using Matrix = Eigen::Matrix2d;
  using Vector = Eigen::Vector2d;
  /// What the waves of one layer are made of: (T, N) and (q U, q W) of amplitudes (P, F) at the top
  /// of those that decay downwards, and at the bottom of those that decay upwards.
  struct Layer {
    Matrix traction_down, traction_up, displacement_down, displacement_up;
    double nu, softness, thickness, top;
    // Of the wavenumber: through the layer, up-waves at the bottom of down-waves there, and of a
    // unit displacement that what lies below has of itself; down-waves of tractions at the top,
    // and displacement there.
    Matrix decay = Matrix::Zero(), reflection = Matrix::Zero(), of_below = Matrix::Zero(),
           to_amplitude = Matrix::Zero(), compliance = Matrix::Zero();
    // The same of waves across.
    double across_decay = 0.0, across_reflection = 0.0, across_of_below = 0.0,
           across_to_amplitude = 0.0, across_compliance = 0.0;
  };

  /// From the surface down, the substrate last where it is not rigid.
  const std::vector<Layer>& layers() const { return layers_; }

  /// q > 0 [1/m].
  void set_wavenumber(double q);
  WaveCompliance compliance() const;

  /// In one layer, exp(-y) and y exp(-y) of what decays from its top and from its bottom: at a
  /// depth, or their means over z0 < z < z1.
  struct Decays {
    WaveDecay down, up;
  };
  Decays at(int layer, double z) const;
  Decays mean(int layer, double z0, double z1) const;
  /// Stress xx, yy, zz, yz, xz, xy [-] there under unit pressure and under unit shear along x, the
  /// real factors of kernels/wave.hpp, with the direction of the wave.
  Stress under_pressure(int layer, const Decays& decays, double cos, double sin) const;
  Stress under_shear_x(int layer, const Decays& decays, double cos, double sin) const;

 private:
  /// Waves that decay from the top (a) and from the bottom (b) of a layer, in the plane and across.
  struct Amplitudes {
    Vector a, b;
    double across_a, across_b;
  };
  /// Under tractions (T, N) and T_2 on the surface.
  Amplitudes amplitudes(int layer, Vector traction, double across) const;
  /// Stress in the frame of the wave.
  struct Turned;
  Turned turned(int layer, const Decays& decays, const Vector& traction, double across) const;

  std::vector<Layer> layers_;
  bool on_rigid_;
  double q_ = 0.0;
  WaveCompliance compliance_{};
};

}  // namespace samcontact::kernels
