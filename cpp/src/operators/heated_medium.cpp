// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heated_medium.hpp"

#include <array>
#include <cassert>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/operators/heat_stress.hpp"
#include "samcontact/operators/volume_medium.hpp"

namespace samcontact::operators {
namespace {

/// Offsets of a table that is kept; of a moving source it takes long.
constexpr std::size_t most_kept = 20000;
/// Lattices of zones grow a little at a time.
std::size_t rounded(std::size_t offsets) { return (offsets + 7) / 8 * 8; }

class HeatedMedium : public VolumeMedium {
 public:
  using VolumeMedium::stress;

  HeatedMedium(SharedMedium medium, const Heating& heating, double shear)
      : medium_(std::move(medium)), heating_(heating), shear_(heating.is_moving() ? shear : 1.0) {
    assert(heating.speed_y == 0);
  }

  bool is_rigid() const override { return medium_->is_rigid(); }
  bool operator==(const Medium& other) const override {
    const auto* heated = dynamic_cast<const HeatedMedium*>(&other);
    return heated != nullptr && *heated->medium_ == *medium_ && heated->heating_ == heating_ &&
           heated->shear_ == shear_;
  }

  Field stress(Traction traction, const Grid& grid, const CellOffsets& offsets, double z,
               Tensor tensor) const override {
    Field sum = medium_->stress(traction, grid, offsets, z, tensor);
    if (traction == Traction::shear_y) return sum;
    const bool odd = traction == Traction::shear_x;
    if (odd) {
      for (double& s : sum) s *= shear_;
    }
    const auto table = tables(grid, offsets, z);
    const std::size_t nx = offsets.x.size(), ny = offsets.y.size(), width = table->at.x.size();
    double* to = sum.data();
    for (const ParityParts& part : parts_of(table->stress, tensor)) {
      const Field& more = part[odd ? 1 : 0];
      for (std::size_t j = 0; j < ny; ++j, to += nx) {
        if (more.empty()) continue;
        for (std::size_t i = 0; i < nx; ++i) to[i] += more[j * width + i];
      }
    }
    return sum;
  }
  Field residual_displacement(Axis axis, const Grid& grid, const CellOffsets& offsets,
                              int layer) const override {
    return medium_->residual_displacement(axis, grid, offsets, layer);
  }
  std::unique_ptr<ResidualStress> residual_stress(const Grid& grid,
                                                  const VolumeTransform& transform,
                                                  const ResidualSettings& settings) const override {
    return medium_->residual_stress(grid, transform, settings);
  }
  std::unique_ptr<ResidualDisplacement> residual_displacement(
      Axis axis, const Grid& grid, const VolumeTransform& transform, Tensor tensor,
      const ResidualDisplacement* shallower) const override {
    return medium_->residual_displacement(axis, grid, transform, tensor, shallower);
  }

 private:
  struct Table {
    std::mutex mutex;
    Offsets at;
    std::array<ParityParts, 6> stress;
  };
  using Key = std::tuple<double, int, std::size_t, std::size_t>;

  /// Of these offsets, evenly spaced from 0, and maybe more.
  std::shared_ptr<const Table> tables(const Grid& grid, const CellOffsets& offsets,
                                      double z) const {
    const Uninterrupted quiet;  // layers are built in parallel
    const int step = offsets.x.size() > 1 ? offsets.x[1] : 1;
    const std::size_t nx = rounded(offsets.x.size()), ny = rounded(offsets.y.size());
    const auto table = place({z, step, nx, ny}, nx * ny <= most_kept);
    const std::lock_guard lock(table->mutex);
    if (table->at.x.empty()) {
      table->at = Offsets::lattice(step * grid.dx, step * grid.dy, static_cast<int>(nx),
                                   static_cast<int>(ny));
      table->stress = medium_->heat_stress(heating_, grid.dx, grid.dy, z, table->at);
    }
    return table;
  }
  std::shared_ptr<Table> place(const Key& key, bool keeps) const {
    if (!keeps) return std::make_shared<Table>();
    const std::lock_guard lock(mutex_);
    auto& table = kept_[key];
    if (!table) table = std::make_shared<Table>();
    return table;
  }

  SharedMedium medium_;
  Heating heating_;
  double shear_;  // over what takes the place of s_x
  mutable std::mutex mutex_;
  mutable std::map<Key, std::shared_ptr<Table>> kept_;
};

}  // namespace

SharedMedium heated(const SharedMedium& medium, const Heating& heating, double shear) {
  return heating.is_on() ? std::make_shared<const HeatedMedium>(medium, heating, shear) : medium;
}

Tractions tractions_on_heated(const Tractions& tractions, const Heating& heating) {
  if (!heating.is_moving()) return tractions;
  return {tractions.pressure, tractions.pressure, {}};
}

}  // namespace samcontact::operators
