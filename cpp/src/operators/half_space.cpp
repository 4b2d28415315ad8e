// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/half_space.hpp"

#include <algorithm>
#include <numbers>

#include "samcontact/kernels/corners.hpp"
#include "samcontact/kernels/far_displacement.hpp"
#include "samcontact/kernels/surface_traction.hpp"
#include "samcontact/operators/cuboid_residual_stress.hpp"
#include "samcontact/operators/influence_lattice.hpp"
#include "samcontact/operators/layer_residual_stress.hpp"

namespace samcontact::operators {
namespace {

/// The edges of cells at offsets, in half cells from the centre of the source, each once.
std::vector<int> edges_of(const std::vector<int>& offsets) {
  std::vector<int> edges;
  for (const int n : offsets) edges.insert(edges.end(), {2 * n - 1, 2 * n + 1});
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Corner sums of a cell of 1 by `aspect`, each corner evaluated once however many cells share it.
template <class Corner>
Field corner_sums(const CellOffsets& offsets, double aspect, const Corner& corner) {
  const std::vector<int> at_x = edges_of(offsets.x), at_y = edges_of(offsets.y);
  Field corners;
  corners.reserve(at_x.size() * at_y.size());
  for (const int y : at_y) {
    for (const int x : at_x) corners.push_back(corner(0.5 * x, 0.5 * y * aspect));
  }
  // The upper edge follows the lower one.
  const auto lower_edges = [](const std::vector<int>& cells, const std::vector<int>& edges) {
    std::vector<std::size_t> places;
    places.reserve(cells.size());
    for (const int n : cells) {
      places.push_back(std::lower_bound(edges.begin(), edges.end(), 2 * n - 1) - edges.begin());
    }
    return places;
  };
  const auto from_x = lower_edges(offsets.x, at_x), from_y = lower_edges(offsets.y, at_y);
  Field sums;
  sums.reserve(from_x.size() * from_y.size());
  for (const std::size_t j : from_y) {
    const double *lower = corners.data() + j * at_x.size(), *upper = lower + at_x.size();
    for (const std::size_t i : from_x) {
      sums.push_back((upper[i + 1] - upper[i]) - (lower[i + 1] - lower[i]));
    }
  }
  return sums;
}

/// u_z of pressure: by its moments far away.
Field pressure_sums(const CellOffsets& offsets, double aspect) {
  const auto& [x, y] = offsets.in_metres(1.0, aspect);
  const kernels::FarDisplacement far(1.0, aspect);
  Field sums(x.size() * y.size());
  for (std::size_t j = 0; j < y.size(); ++j) {
    double* row = sums.data() + j * x.size();
    far.evaluate(x.data(), y[j], x.size(), row);
    if (y[j] >= far.begin()) continue;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (x[i] >= far.begin()) continue;
      row[i] = kernels::corner_sum_2d<1>(x[i], y[j], 0.5, 0.5 * aspect, [](double s, double t) {
        return std::array{kernels::pressure_displacement(s, t)};
      })[0];
    }
  }
  return sums;
}

kernels::Stress corner_stress(Traction traction, double x, double y, double z, double nu) {
  if (traction == Traction::pressure) return kernels::pressure_stress(x, y, z, nu);
  if (traction == Traction::shear_x) return kernels::shear_stress(x, y, z, nu);
  const auto s = kernels::shear_stress(y, x, z, nu);
  return {s[1], s[0], s[2], s[4], s[3], s[5]};
}

/// The components of the field that are asked for come first.
kernels::Stress select(kernels::Stress s, Tensor tensor) {
  if (tensor == Tensor::full) return s;
  const double mean = (s[0] + s[1] + s[2]) / 3;
  return {s[0] - mean, s[1] - mean, s[3], s[4], s[5], 0.0};
}

class HalfSpace : public Medium {
 public:
  explicit HalfSpace(const Elastic& elastic) : elastic_(elastic) {}

  bool is_rigid() const override { return elastic_.is_rigid(); }
  bool operator==(const Medium& other) const override {
    const auto* half_space = dynamic_cast<const HalfSpace*>(&other);
    return half_space != nullptr && half_space->elastic_ == elastic_;
  }

  Field compliance(Traction traction, Axis axis, double dx, double dy,
                   const CellOffsets& offsets) const override {
    if (is_rigid()) return Field(offsets.x.size() * offsets.y.size(), 0.0);
    const double aspect = dy / dx;
    double factor = 0.0;
    Field table;
    if (traction == Traction::pressure && axis == Axis::z) {
      table = pressure_sums(offsets, aspect);
      factor = elastic_.normal_compliance();
    } else if (traction == Traction::pressure || axis == Axis::z) {
      const bool along_x = traction == Traction::shear_x || axis == Axis::x;
      table = corner_sums(offsets, aspect, [along_x](double x, double y) {
        return along_x ? kernels::shear_displacement(x, y) : kernels::shear_displacement(y, x);
      });
      // Betti: what pressure does to the side is what shear does downwards, seen from the other.
      factor = (axis == Axis::z ? 0.5 : -0.5) * elastic_.coupling_compliance();
    } else {
      const double nu = elastic_.nu;
      const bool across = (traction == Traction::shear_x) != (axis == Axis::x);
      const bool along_x = traction == Traction::shear_x;
      table = corner_sums(offsets, aspect, [nu, across, along_x](double x, double y) {
        if (across) return kernels::cross_displacement(x, y, nu);
        return along_x ? kernels::along_displacement(x, y, nu)
                       : kernels::along_displacement(y, x, nu);
      });
      factor = 0.5 / elastic_.shear_modulus();
    }
    factor *= dx / std::numbers::pi;
    for (double& value : table) value *= factor;
    return table;
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

  Field stress(Traction traction, const Grid& grid, double z, Tensor tensor) const override {
    const CornerLattice lattice{grid.nx, grid.ny, grid.dy / grid.dx};
    const std::size_t plane = grid.surface_size();
    Field corners(6 * lattice.size()), table(count(tensor) * plane);
    lattice.evaluate<6>(
        [&](double x, double y) {
          auto s = select(corner_stress(traction, x, y, z / grid.dx, elastic_.nu), tensor);
          for (double& v : s) v /= 2 * std::numbers::pi;
          return s;
        },
        corners.data());
    for (int c = 0; c < count(tensor); ++c) {
      lattice.corner_sums(corners.data() + c * lattice.size(), table.data() + c * plane, grid.nx,
                          grid.ny);
    }
    return table;
  }

  std::unique_ptr<ResidualStress> residual_stress(const Grid& grid,
                                                  const VolumeTransform& transform,
                                                  ResidualMethod method,
                                                  double image_tol) const override {
    if (method == ResidualMethod::exact) {
      return std::make_unique<CuboidResidualStress>(grid, transform, elastic_);
    }
    return std::make_unique<LayerResidualStress>(grid, transform, elastic_, image_tol);
  }
  std::unique_ptr<ResidualDisplacement> residual_displacement(const Grid& grid,
                                                              const VolumeTransform& transform,
                                                              Tensor tensor) const override {
    return std::make_unique<ResidualDisplacement>(grid, transform, elastic_.nu, tensor);
  }

  ParityParts heat_displacement(const Heating& heating, double dx, double dy,
                                const Offsets& offsets) const override {
    return operators::heat_displacement(heating, elastic_.nu, dx, dy, offsets);
  }
  std::array<ParityParts, 6> heat_stress(const Heating& heating, double dx, double dy, double z,
                                         const Offsets& offsets) const override {
    return operators::heat_stress(heating, elastic_, dx, dy, z, offsets);
  }
  HeatHistory heat_history(const Grid& grid, const Heating& heating,
                           const HeatHistorySettings& settings) const override {
    return {grid, heating.thermal, elastic_, heating.speed_x, heating.speed_y, settings};
  }

 private:
  Elastic elastic_;
};

}  // namespace

SharedMedium half_space(const Elastic& elastic) {
  return std::make_shared<const HalfSpace>(elastic);
}

}  // namespace samcontact::operators
