// SPDX-License-Identifier: GPL-3.0-or-later
// Cells that an inclusion fills, completely or partly: moduli, misfit strain and yield law that
// differ from those of the matrix, and the step from one estimate of their eigenstrain to the next.
#pragma once

#include <array>
#include <span>

#include "samcontact/plasticity/return_mapping.hpp"

namespace samcontact::plasticity {

/// Constants of a cell. In a partly filled cell without a normal they are mixed; with a normal they
/// are those of the inclusion.
struct MixedCell {
  double bulk = 1.0, shear = 1.0;  // relative to the matrix; 0 in a void
  double share = 1.0;              // of the inclusion
  Tensor misfit{};
  int material = -1;               // index of the material of the inclusion; -1: void
  std::array<double, 3> normal{};  // unit vector of the interface of a cell of two phases; else 0

  double expansion = 0.0;  // misfit strain per temperature rise [1/K]

  /// Whether both phases flow separately.
  bool has_two_phases() const { return normal != std::array<double, 3>{}; }
};

/// History and yield strength of a cell before an increment.
struct MixedHistory {
  Tensor plastic{};  // mean plastic strain of the cell; with two phases that of the inclusion
  double equivalent = 0.0;            // with two phases that of the matrix
  Tensor matrix_plastic{};            // with two phases: plastic strain of the matrix
  double inclusion_equivalent = 0.0;  // likewise: equivalent strain of the inclusion
  std::span<const Tensor> backstresses = {};
  double strength = 1.0;  // factor on the yield stress of the matrix
};

struct MixedReturn {
  Tensor eigenstrain{};  // strain that the homogeneous matrix needs to have the stress of the cell
  Tensor plastic{};      // increments of the quantities of MixedHistory
  Tensor matrix_plastic{};
  double inclusion_equivalent = 0.0;
  Tensor flow{};  // plastic strain increment of the matrix, or of the phases that flow
  double equivalent = 0.0, excess = 0.0, overshoot = 0.0;  // see Return
};

/// Law of all mixed cells of a matrix. The estimate of the eigenstrain e* is replaced by that which
/// keeps s + p C e* (s: stress, C: stiffness of the matrix). With p = 1 - Eshelby's tensor of a
/// sphere, one step solves a single sphere in uniform stress; with p = 1 it is the radial return of
/// the matrix.
class MixedLaw {
 public:
  /// The matrix must outlive this object. strong: whether moduli differ by a large factor.
  MixedLaw(const Material& matrix, bool strong);

  /// p of the deviatoric part in cells of the matrix.
  double matrix_part() const { return strong_ ? 1.0 : sphere_shear_.part; }

  /// stress: of the present estimate [Pa], six components. inclusion: material of the inclusion;
  /// null: void.
  MixedReturn step(const MixedCell& cell, const Material* inclusion, const Tensor& stress,
                   const Tensor& eigenstrain, const MixedHistory& before) const;

 private:
  MixedReturn step_of_two(const MixedCell& cell, const Material* inclusion, const Tensor& stress,
                          const Tensor& eigenstrain, const MixedHistory& before) const;
  struct Phases;
  /// Which phases of a cell flow: the matrix in parallel with a void or with an inclusion that
  /// yields; in series with an inclusion that does not.
  Phases phases(const MixedCell& cell, const Material* inclusion) const;

  /// p of the bulk or shear part, and p times 3 K or 2 G of the matrix [Pa].
  struct Kept {
    double part, stiffness;
  };
  /// p for a ratio of moduli: that of a sphere, a part of it in much stiffer cells, and 1 in
  /// softer cells if moduli differ by a large factor. With these values the iteration was found to
  /// take the fewest steps.
  Kept kept(const Kept& sphere, double ratio) const;

  const Material& matrix_;
  bool strong_;
  double bulk_modulus_, shear_modulus_;  // of the matrix [Pa]
  Kept sphere_bulk_{}, sphere_shear_{};
};

}  // namespace samcontact::plasticity
