// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/medium/layered_half_space.hpp"

#include <utility>

#include "samcontact/kernels/layered_wave.hpp"
#include "samcontact/operators/medium/half_space.hpp"
#include "samcontact/operators/medium/layered_influence.hpp"
#include "samcontact/operators/residual/layer_residual_stress.hpp"

namespace samcontact::operators {
namespace {

class LayeredHalfSpace : public Medium {
 public:
  explicit LayeredHalfSpace(Stack stack) : stack_(std::move(stack)), heat_(heated_body(stack_)) {}

  bool is_rigid() const override { return false; }
  bool operator==(const Medium& other) const override {
    const auto* layered = dynamic_cast<const LayeredHalfSpace*>(&other);
    return layered != nullptr && layered->stack_ == stack_;
  }

  Field compliance(Traction traction, Axis axis, const Grid& grid,
                   const CellOffsets& offsets) const override {
    if (!grid.period.is_on()) return layered_compliance(stack_, traction, axis, grid, offsets);
    const auto cell = [&](const Grid& own, bool rotated) {
      return rotated ? layered_compliance_of_cell(stack_, exchanged(traction), exchanged(axis), own)
                     : layered_compliance_of_cell(stack_, traction, axis, own);
    };
    const int name = 3 * static_cast<int>(traction) + static_cast<int>(axis);
    return sums_.sum(grid, offsets, cell, std::array{0}, name);
  }
  double wave_compliance(double wavenumber) const override {
    kernels::LayeredWave wave(stack_);
    wave.set_wavenumber(wavenumber);
    return wave.compliance().down / wavenumber;
  }

  Field stress(Traction traction, const Grid& grid, const KernelOffsets& offsets, double z,
               Tensor tensor) const override {
    const auto lattice = CellOffsets::lattice(offsets.nx, offsets.ny);
    if (!grid.period.is_on() || is_rigid_at(z)) return stress(traction, grid, lattice, z, tensor);
    const auto cell = [&](const Grid& own, bool rotated) {
      return layered_stress_of_cell(stack_, rotated ? exchanged(traction) : traction, own, z);
    };
    return selected(sums_.sum(grid, lattice, cell, exchanged_components), tensor);
  }
  Field stress(Traction traction, const Grid& grid, const CellOffsets& offsets, double z,
               Tensor tensor) const override {
    if (is_rigid_at(z)) return Field(count(tensor) * offsets.x.size() * offsets.y.size(), 0.0);
    return layered_stress(stack_, traction, grid, offsets, z, tensor);
  }
  Field residual_displacement(Axis axis, const Grid& grid, const CellOffsets& offsets,
                              int layer) const override {
    return layered_residual_displacement(stack_, axis, grid, offsets, layer);
  }

  std::unique_ptr<ResidualStress> residual_stress(const Grid& grid,
                                                  const VolumeTransform& transform,
                                                  const ResidualSettings& settings) const override {
    return std::make_unique<LayerResidualStress>(grid, transform, stack_, settings);
  }
  std::unique_ptr<ResidualDisplacement> residual_displacement(
      Axis axis, const Grid& grid, const VolumeTransform& transform, Tensor tensor,
      const ResidualDisplacement* shallower) const override {
    const KernelOffsets offsets(grid, transform.mx(), transform.my());
    const auto lattice = CellOffsets::lattice(offsets.nx, offsets.ny);
    const auto layer = [this, axis, grid, lattice](int k) {
      if (!grid.period.is_on()) {
        return layered_residual_displacement(stack_, axis, grid, lattice, grid.k0 + k);
      }
      const auto cell = [&](const Grid& own, bool rotated) {
        return layered_residual_of_cell(stack_, rotated ? exchanged(axis) : axis, own, grid.k0 + k);
      };
      return sums_.sum(grid, lattice, cell, exchanged_components);
    };
    return std::make_unique<ResidualDisplacement>(grid, transform, axis, layer, grid.nz, tensor,
                                                  shallower);
  }

  SharedHeatMedium heat() const override { return heat_; }

 private:
  /// Whether the material at a depth is rigid, without deformation and known stress.
  bool is_rigid_at(double z) const { return stack_.elastic(stack_.layer_at(z)).is_rigid(); }

  Stack stack_;
  SharedHeatMedium heat_;
  PeriodicSums sums_;
};

}  // namespace

SharedMedium medium_of(const Stack& stack) {
  Stack merged = stack.merged();
  if (merged.layers.empty()) return half_space(merged.substrate);
  return std::make_shared<const LayeredHalfSpace>(std::move(merged));
}

}  // namespace samcontact::operators
