// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/medium/half_space.hpp"

#include <array>
#include <stdexcept>

#include "samcontact/operators/periodic/cell_influence.hpp"
#include "samcontact/operators/residual/cuboid_residual_stress.hpp"
#include "samcontact/operators/residual/layer_residual_stress.hpp"

namespace samcontact::operators {
namespace {

class HalfSpace : public Medium {
 public:
  explicit HalfSpace(const Elastic& elastic)
      : elastic_(elastic), heat_(heated_body({{}, elastic})) {}

  bool is_rigid() const override { return elastic_.is_rigid(); }
  bool operator==(const Medium& other) const override {
    const auto* half_space = dynamic_cast<const HalfSpace*>(&other);
    return half_space != nullptr && half_space->elastic_ == elastic_;
  }

  Field compliance(Traction traction, Axis axis, const Grid& grid,
                   const CellOffsets& offsets) const override {
    if (is_rigid()) return Field(offsets.x.size() * offsets.y.size(), 0.0);
    if (!grid.period.is_on()) return cell_compliance(elastic_, traction, axis, grid, offsets);
    const auto cell = [&](const Grid& own, bool rotated) {
      return rotated ? compliance_of_cell(elastic_, exchanged(traction), exchanged(axis), own)
                     : compliance_of_cell(elastic_, traction, axis, own);
    };
    const int name = 3 * static_cast<int>(traction) + static_cast<int>(axis);
    return sums_.sum(grid, offsets, cell, std::array{0}, name);
  }

  double wave_compliance(double wavenumber) const override {
    return 2 * elastic_.normal_compliance() / wavenumber;
  }

  std::optional<double> normal_ratio(Traction traction, const Medium& other) const override {
    const auto* half_space = dynamic_cast<const HalfSpace*>(&other);
    if (half_space == nullptr || half_space->is_rigid()) return std::nullopt;
    const auto factor = [traction](const Elastic& e) {
      return traction == Traction::pressure ? e.normal_compliance() : e.coupling_compliance();
    };
    return factor(elastic_) / factor(half_space->elastic_);
  }

  Field stress(Traction traction, const Grid& grid, const KernelOffsets& offsets, double z,
               Tensor tensor) const override {
    const auto [nx, ny] = offsets;
    const CellOffsets lattice = CellOffsets::lattice(nx, ny);
    if (!grid.period.is_on()) return stress(traction, grid, lattice, z, tensor);
    const auto cell = [&](const Grid& own, bool rotated) {
      return stress_influence(rotated ? exchanged(traction) : traction, own, z);
    };
    return selected(sums_.sum(grid, lattice, cell, exchanged_components), tensor);
  }

  Field stress(Traction traction, const Grid& grid, const CellOffsets& offsets, double z,
               Tensor tensor) const override {
    return cell_stress(elastic_.nu, traction, grid, offsets, z, tensor);
  }
  Field residual_displacement(Axis axis, const Grid& grid, const CellOffsets& offsets,
                              int layer) const override {
    return cell_residual_displacement(elastic_.nu, axis, grid, offsets, layer);
  }

  CellInfluence stress_influence(Traction traction, const Grid& cell, double z) const override {
    return stress_of_cell(elastic_.nu, traction, cell, z);
  }
  CellInfluence residual_influence(Axis axis, const Grid& cell, int layer) const override {
    return residual_of_cell(elastic_.nu, axis, cell, layer);
  }

  std::unique_ptr<ResidualStress> residual_stress(const Grid& grid,
                                                  const VolumeTransform& transform,
                                                  const ResidualSettings& settings) const override {
    if (settings.method == ResidualMethod::exact) {
      if (grid.period.is_on()) {
        throw std::invalid_argument(
            "residual_stress must be \"fast\" on a periodic grid, got \"exact\": the exact kernels "
            "have no closed-form lattice sums");
      }
      return std::make_unique<CuboidResidualStress>(grid, transform, elastic_);
    }
    return std::make_unique<LayerResidualStress>(grid, transform, Stack{{}, elastic_}, settings);
  }
  std::unique_ptr<ResidualDisplacement> residual_displacement(
      Axis axis, const Grid& grid, const VolumeTransform& transform, Tensor tensor,
      const ResidualDisplacement* shallower) const override {
    const double nu = elastic_.nu;
    if (!grid.period.is_on()) {
      return std::make_unique<ResidualDisplacement>(grid, transform, nu, axis, tensor, shallower);
    }
    const KernelOffsets offsets(grid, transform.mx(), transform.my());
    const auto layer = [this, axis, grid, offsets](int k) {
      const auto cell = [&](const Grid& own, bool rotated) {
        return residual_influence(rotated ? exchanged(axis) : axis, own, grid.k0 + k);
      };
      return sums_.sum(grid, CellOffsets::lattice(offsets.nx, offsets.ny), cell,
                       exchanged_components);
    };
    return std::make_unique<ResidualDisplacement>(grid, transform, axis, layer, grid.nz, tensor,
                                                  shallower);
  }

  SharedHeatMedium heat() const override { return heat_; }

 private:
  Elastic elastic_;
  SharedHeatMedium heat_;
  PeriodicSums sums_;
};

}  // namespace

SharedMedium half_space(const Elastic& elastic) {
  return std::make_shared<const HalfSpace>(elastic);
}

}  // namespace samcontact::operators
