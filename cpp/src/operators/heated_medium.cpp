// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heated_medium.hpp"

#include <cassert>
#include <stdexcept>
#include <utility>

#include "samcontact/operators/heat_stress.hpp"

namespace samcontact::operators {
namespace {

class HeatedMedium : public Medium {
 public:
  HeatedMedium(SharedMedium medium, const Heating& heating)
      : medium_(std::move(medium)), heating_(heating) {
    assert(!heating.is_moving());
  }

  bool is_rigid() const override { return medium_->is_rigid(); }
  bool operator==(const Medium& other) const override {
    const auto* heated = dynamic_cast<const HeatedMedium*>(&other);
    return heated != nullptr && *heated->medium_ == *medium_ && heated->heating_ == heating_;
  }

  Field stress(Traction traction, const Grid& grid, const CellOffsets& offsets, double z,
               Tensor tensor) const override {
    Field sum = medium_->stress(traction, grid, offsets, z, tensor);
    if (traction != Traction::pressure) return sum;
    Offsets at;
    for (const int i : offsets.x) at.x.push_back(i * grid.dx);
    for (const int j : offsets.y) at.y.push_back(j * grid.dy);
    double* to = sum.data();
    for (const ParityParts& part :
         parts_of(medium_->heat_stress(heating_, grid.dx, grid.dy, z, at), tensor)) {
      for (std::size_t n = 0; n < part[0].size(); ++n) to[n] += part[0][n];
      to += at.x.size() * at.y.size();
    }
    return sum;
  }
  Field residual_displacement(const Grid& grid, const CellOffsets& offsets,
                              int layer) const override {
    return medium_->residual_displacement(grid, offsets, layer);
  }
  std::unique_ptr<ResidualStress> residual_stress(const Grid& grid,
                                                  const VolumeTransform& transform,
                                                  const ResidualSettings& settings) const override {
    return medium_->residual_stress(grid, transform, settings);
  }
  std::unique_ptr<ResidualDisplacement> residual_displacement(const Grid& grid,
                                                              const VolumeTransform& transform,
                                                              Tensor tensor) const override {
    return medium_->residual_displacement(grid, transform, tensor);
  }

  Field compliance(Traction, Axis, const Grid&, const CellOffsets&) const override { fail(); }
  double wave_compliance(double) const override { fail(); }
  Field stress(Traction, const Grid&, const KernelOffsets&, double, Tensor) const override {
    fail();
  }
  ParityParts heat_displacement(const Heating&, double, double, const Offsets&) const override {
    fail();
  }
  std::array<ParityParts, 6> heat_stress(const Heating&, double, double, double,
                                         const Offsets&) const override {
    fail();
  }
  HeatHistory heat_history(const Grid&, const Heating&, const HeatHistorySettings&) const override {
    fail();
  }

 private:
  [[noreturn]] static void fail() {
    throw std::logic_error("a heated medium knows its volume only");
  }

  SharedMedium medium_;
  Heating heating_;
};

}  // namespace

SharedMedium heated(const SharedMedium& medium, const Heating& heating) {
  return heating.is_on() ? std::make_shared<const HeatedMedium>(medium, heating) : medium;
}

}  // namespace samcontact::operators
