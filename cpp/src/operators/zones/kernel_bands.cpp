// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/zones/kernel_bands.hpp"

#include <memory>
#include <unordered_map>
#include <utility>

#include "samcontact/operators/medium/volume_medium.hpp"
#include "samcontact/operators/residual/scaled_images.hpp"
#include "samcontact/operators/zones/band_tables.hpp"

namespace samcontact::operators {
namespace {

class BandMedium : public VolumeMedium {
 public:
  using VolumeMedium::residual_displacement;
  using VolumeMedium::stress;

  BandMedium(Band band, std::shared_ptr<const BandTables> tables)
      : band_(band), tables_(std::move(tables)) {}

  bool is_rigid() const override { return tables_->medium()->is_rigid(); }
  bool operator==(const Medium& other) const override { return this == &other; }

  Field stress(Traction traction, const Grid&, const KernelOffsets& offsets, double z,
               Tensor tensor) const override {
    return tables_->stress(band_, traction, offsets, z, tensor);
  }
  int stressed_layers(const Grid& grid) const override {
    return tables_->stressed_layers(band_, grid);
  }
  std::unique_ptr<ResidualStress> residual_stress(const Grid& grid,
                                                  const VolumeTransform& transform,
                                                  const ResidualSettings& settings) const override {
    const double step = tables_->bands().spacing(band_), dx = grid.dx / step, dy = grid.dy / step;
    // A node represents the strain of its cells.
    const auto gain = [tables = tables_, band = band_,
                       known = std::make_shared<std::unordered_map<double, double>>()](double k) {
      const auto [at, is_new] = known->try_emplace(k, 0.0);
      if (is_new) at->second = tables->window_gain(band, k);
      return at->second;
    };
    const auto own = [tables = tables_, band = band_, gain, dx, dy, step](double kx, double ky) {
      return tables->share(band, kx * dx, ky * dy) / (gain(kx * dx) * gain(ky * dy) * step * step);
    };
    ResidualSettings of_band = settings;
    of_band.share = own;
    of_band.blends = band_ == Band::near;
    auto whole = tables_->medium()->residual_stress(grid, transform, of_band);
    if (band_ != Band::far) return whole;
    return std::make_unique<ScaledImages>(std::move(whole), own(0.0, 0.0));
  }
  std::unique_ptr<ResidualDisplacement> residual_displacement(
      Axis axis, const Grid& grid, const VolumeTransform& transform, Tensor tensor,
      const ResidualDisplacement* shallower) const override {
    const KernelOffsets offsets(grid, transform.mx(), transform.my());
    const auto layer = [tables = tables_, band = band_, axis, offsets](int k) {
      return tables->residual_displacement(band, axis, offsets, k);
    };
    return std::make_unique<ResidualDisplacement>(
        grid, transform, axis, layer, tables_->strained_layers(band_, grid), tensor, shallower);
  }

 private:
  Band band_;
  std::shared_ptr<const BandTables> tables_;
};

class BandHeat : public ThermalStress {
 public:
  BandHeat(Band band, std::shared_ptr<const BandTables> tables)
      : band_(band), tables_(std::move(tables)) {}

  std::array<ParityParts, 6> stress(const Heating& heating, double, double, double z,
                                    const Offsets& offsets) const override {
    const KernelOffsets count(static_cast<int>(offsets.x.size()),
                              static_cast<int>(offsets.y.size()));
    return tables_->heat_stress(band_, heating, count, z);
  }
  bool is_fast(const Heating& heating) const override { return heating.is_steady_at_rest(); }

 private:
  Band band_;
  std::shared_ptr<const BandTables> tables_;
};

}  // namespace

std::array<MediumBand, 3> bands_of(const SharedMedium& medium, const Grid& cells,
                                   const BandSplit& split) {
  const auto tables = std::make_shared<const BandTables>(medium, cells, split);
  const auto of = [&tables](Band band) {
    return MediumBand{std::make_shared<const BandMedium>(band, tables),
                      std::make_shared<const BandHeat>(band, tables)};
  };
  return {of(Band::near), of(Band::middle), of(Band::far)};
}

}  // namespace samcontact::operators
