// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/medium/scaled_medium.hpp"

#include <stdexcept>
#include <utility>

namespace samcontact::operators {
namespace {

[[noreturn]] void refuse() {
  throw std::logic_error("a scaled medium has surface displacements only");
}

class ScaledMedium : public Medium {
 public:
  ScaledMedium(SharedMedium of, double factor) : of_(std::move(of)), factor_(factor) {}

  bool is_rigid() const override { return of_->is_rigid(); }
  bool operator==(const Medium& other) const override {
    const auto* scaled = dynamic_cast<const ScaledMedium*>(&other);
    return scaled != nullptr && scaled->factor_ == factor_ && *scaled->of_ == *of_;
  }

  Field compliance(Traction traction, Axis axis, const Grid& grid,
                   const CellOffsets& offsets) const override {
    Field table = of_->compliance(traction, axis, grid, offsets);
    for (double& u : table) u *= factor_;
    return table;
  }
  double wave_compliance(double wavenumber) const override {
    return factor_ * of_->wave_compliance(wavenumber);
  }
  SharedHeatMedium heat() const override { return of_->heat(); }
  std::optional<double> normal_ratio(Traction traction, const Medium& other) const override {
    const auto* scaled = dynamic_cast<const ScaledMedium*>(&other);
    auto ratio = of_->normal_ratio(traction, scaled != nullptr ? *scaled->of_ : other);
    if (ratio) *ratio *= factor_ / (scaled != nullptr ? scaled->factor_ : 1.0);
    return ratio;
  }

  Field stress(Traction, const Grid&, const KernelOffsets&, double, Tensor) const override {
    refuse();
  }
  Field stress(Traction, const Grid&, const CellOffsets&, double, Tensor) const override {
    refuse();
  }
  Field residual_displacement(Axis, const Grid&, const CellOffsets&, int) const override {
    refuse();
  }
  std::unique_ptr<ResidualStress> residual_stress(const Grid&, const VolumeTransform&,
                                                  const ResidualSettings&) const override {
    refuse();
  }
  std::unique_ptr<ResidualDisplacement> residual_displacement(
      Axis, const Grid&, const VolumeTransform&, Tensor,
      const ResidualDisplacement*) const override {
    refuse();
  }

 private:
  SharedMedium of_;
  double factor_;
};

}  // namespace

SharedMedium scaled_medium(const SharedMedium& medium, double compliance) {
  if (compliance == 1.0 || medium->is_rigid()) return medium;
  return std::make_shared<const ScaledMedium>(medium, compliance);
}

}  // namespace samcontact::operators
