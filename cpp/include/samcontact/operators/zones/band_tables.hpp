// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of the coefficients of a medium, split into bands: docs/theory/zones.md.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <vector>

#include "samcontact/base/cells_over.hpp"
#include "samcontact/operators/zones/band_split.hpp"
#include "samcontact/operators/zones/node_spread.hpp"
#include "samcontact/operators/zones/repeated_cells.hpp"
#include "samcontact/operators/zones/smooth_continuation.hpp"

namespace samcontact::operators {

/// Tables of all bands of one medium. Thread-safe.
class BandTables {
 public:
  BandTables(SharedMedium medium, const Grid& cells, const BandSplit& bands)
      : medium_(std::move(medium)),
        cells_(cells),
        bands_(bands),
        window_(bands.window_width),
        near_(bands.middle_spacing, bands.near_range, bands.passband_fraction,
              bands.middle_spacing),
        middle_(bands.far_spacing, bands.middle_range, bands.passband_fraction,
                bands.middle_spacing) {
    cells_.period = {};
    if (cells.period.is_on())
      repeated_ = std::make_unique<RepeatedCells>(medium_, cells, bands.far_spacing);
  }

  const SharedMedium& medium() const { return medium_; }
  const BandSplit& bands() const { return bands_; }
  /// Factor of a Fourier mode along one axis after spreading and gathering, wavenumber in 1/cell.
  double window_gain(Band band, double k) const;
  /// Weight of a band in the residual stress of a Fourier mode, wavenumbers in 1/cell: the three
  /// weights add up to 1.
  double share(Band band, double kx, double ky) const;

  /// Number of layers in which strain has a surface displacement by a band: below, it has decreased
  /// to 1e-4.
  int strained_layers(Band band, const Grid& grid) const {
    return layers(band, grid, bands_.near_displacement_depth, bands_.middle_displacement_depth);
  }
  /// Number of layers in which tractions cause stress by a band: below, it has decreased to 1e-5.
  int stressed_layers(Band band, const Grid& grid) const {
    return layers(band, grid, bands_.near_stress_depth, bands_.middle_stress_depth);
  }

  /// Stress [component][j][i] at nodes 0..offsets - 1 of the band.
  Field stress(Band band, Traction traction, const KernelOffsets& offsets, double z,
               Tensor tensor) const {
    const Key key{What::stress, traction, z, tensor};
    return tables(band, key, offsets, parities(traction, tensor), [&](const CellOffsets& at) {
      return medium_->stress(traction, cells_, at, z, tensor);
    });
  }

  /// Thermal stress, in the form of Medium::heat_stress.
  std::array<ParityParts, 6> heat_stress(Band band, const Heating& heating,
                                         const KernelOffsets& offsets, double z) const;

  Field residual_displacement(Band band, Axis axis, const KernelOffsets& offsets, int layer) const {
    const Traction along = traction_along(axis);
    const Key key{What::displacement, along, static_cast<double>(layer), Tensor::full};
    return tables(band, key, offsets, parities(along, Tensor::full), [&](const CellOffsets& at) {
      return medium_->residual_displacement(axis, cells_, at, layer);
    });
  }

 private:
  /// Kind of table; its key also has the depth or layer.
  enum class What { stress, heat, displacement };
  using Key = std::tuple<What, Traction, double, Tensor>;
  using Exact = std::function<Field(const CellOffsets& offsets)>;
  using Parities = std::vector<kernels::Parity>;
  static Parities parities(Traction traction, Tensor tensor) {
    Parities parities;
    for (const int c : components(tensor)) parities.push_back(stress_parity(traction, c));
    return parities;
  }
  /// [component][j][i]: short tables of near and middle nodes, and inner part of the far table.
  struct Split {
    Field near, middle, far;
    /// Periodic surfaces: `far` less the exact table, and for all even components the sum
    /// represented by near and middle nodes, per far node.
    Field less;
    std::vector<double> held;
  };

  /// Number of layers of a grid down to a depth in cells; all for the far band.
  int layers(Band band, const Grid& grid, double near, double middle) const {
    if (band == Band::far) return grid.nz;
    const double depth = (band == Band::near ? near : middle) * std::max(cells_.dx, cells_.dy);
    return std::min(grid.nz, cells_over(depth, grid.dz));
  }
  std::shared_ptr<const Split> split(const Key& key, const Parities& parities,
                                     const Exact& exact) const;
  Field tables(Band band, const Key& key, const KernelOffsets& offsets, const Parities& parities,
               const Exact& exact) const;
  Field far_tables(const Split& split, const KernelOffsets& offsets, const Parities& parities,
                   const Exact& exact) const;
  Field periodic_far_tables(const Split& split, const KernelOffsets& offsets,
                            const Parities& parities, const Key& key) const;
  void compare(const Parities& parities, const Field& whole, Split& split) const;
  void sharpen(Band band, const KernelOffsets& offsets, int mx, int my, const Parities& parities,
               Field& tables) const;

  SharedMedium medium_;
  Grid cells_;
  BandSplit bands_;
  WindowTransform window_;
  SmoothContinuation near_, middle_;
  std::unique_ptr<const RepeatedCells> repeated_;  // on a periodic surface
  mutable std::mutex mutex_;
  mutable std::map<Key, std::shared_ptr<const Split>> kept_;
};

}  // namespace samcontact::operators
