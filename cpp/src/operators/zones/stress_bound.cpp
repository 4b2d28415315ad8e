// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/zones/stress_bound.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "samcontact/base/deviator.hpp"
#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/multiversion.hpp"
#include "samcontact/base/team.hpp"

namespace samcontact::operators {
namespace {

/// Number of depths whose spectra are computed together.
constexpr std::size_t together = 8;
constexpr int parts = 5;

/// From the five components of a deviator, `step` apart.
double von_mises(const double* s, std::size_t step) {
  const double xx = s[0], yy = s[step], yz = s[2 * step], xz = s[3 * step], xy = s[4 * step];
  return std::sqrt(3 * second_invariant(xx, yy, yz, xz, xy));
}

SAMCONTACT_MULTIVERSION
void put_von_mises(const double* s, std::size_t plane, double* out) {
  for (std::size_t n = 0; n < plane; ++n) out[n] = von_mises(s + n, plane);
}

/// Adds the von Mises stress of a table [component][j][i] at each offset.
void add_norm(const Field& table, Field& sum) {
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += von_mises(table.data() + n, sum.size());
}

/// Von Mises stress near a cell due to a unit traction on it [j][i]: of components with equal
/// parities together, and the sum over parities.
Field near_norm(const ZoneTables& tables, Traction kind, double depth, const Grid& around,
                const KernelOffsets& offsets) {
  Field table = tables.medium(Band::near)->stress(kind, around, offsets, depth, Tensor::deviator);
  Field norm(static_cast<std::size_t>(offsets.nx) * offsets.ny, 0.0);
  const auto& heat = tables.heat(Band::near);
  if (heat && kind == Traction::pressure) {
    const auto heated = parts_of(heat->at(depth, around, offsets), Tensor::deviator);
    for (int part = 0; part < 4; ++part) {
      Field of_part(table.size(), 0.0);
      Field& sum = part == 0 ? table : of_part;
      for (int c = 0; c < parts; ++c) {
        const Field& more = heated[c][part];
        for (std::size_t n = 0; n < more.size(); ++n) sum[c * norm.size() + n] += more[n];
      }
      if (part > 0) add_norm(of_part, norm);
    }
  }
  add_norm(table, norm);
  return norm;
}

NodePlanes middle_planes(const ZoneTables& tables) {
  // The corners of the last blocks are one cell further.
  Box cells = Box::surface(tables.grid());
  cells.nx += tables.split().middle_spacing;
  cells.ny += tables.split().middle_spacing;
  return tables.middle_planes(cells, 0);
}

}  // namespace

struct StressBound::Group {
  int first;  // index of its first depth
  std::vector<double> depths;
  bool has_middle;
  TractionStress middle, far;

  Group(const StressBound& of, int first_, const std::vector<double>& depths_, bool has_middle_)
      : first(first_),
        depths(depths_),
        has_middle(has_middle_),
        middle(of.middle_.lattice(), of.middle_transform_, of.tables_->medium(Band::middle),
               of.tables_->heat(Band::middle), depths, Tensor::deviator),
        far(of.far_.lattice(), of.far_transform_, of.tables_->medium(Band::far),
            of.tables_->heat(Band::far), depths, Tensor::deviator) {}
};

struct StressBound::Loads {
  const Tractions& cells;
  Tractions middle, far;
};

StressBound::StressBound(std::shared_ptr<const ZoneTables> tables,
                         const std::vector<double>& depths)
    : tables_(std::move(tables)),
      middle_(middle_planes(*tables_)),
      far_(tables_->far_planes(middle_, 0)),
      middle_transform_(middle_.lattice(), Symmetry::none),
      far_transform_(far_.lattice(), Symmetry::none) {
  const Grid& grid = tables_->grid();
  const double ends = tables_->split().middle_bound_depth * std::min(grid.dx, grid.dy);
  for (std::size_t n = 0; n < depths.size();) {
    std::size_t end = std::min(n + together, depths.size());
    const bool has_middle = depths[n] < ends;
    while (has_middle && depths[end - 1] >= ends) --end;
    const std::vector<double> some(depths.begin() + static_cast<std::ptrdiff_t>(n),
                                   depths.begin() + static_cast<std::ptrdiff_t>(end));
    groups_.push_back(std::make_unique<const Group>(*this, static_cast<int>(n), some, has_middle));
    n = end;
  }
}

StressBound::~StressBound() = default;

int StressBound::blocks_x() const { return (tables_->grid().nx + block() - 1) / block(); }
int StressBound::blocks_y() const { return (tables_->grid().ny + block() - 1) / block(); }

Field StressBound::at_corners(const Field& nodes, const std::array<double, 3>& start,
                              const double* more, std::size_t step) const {
  const Grid& grid = tables_->grid();
  const int nx = blocks_x() + 1, ny = blocks_y() + 1;
  const std::size_t plane = static_cast<std::size_t>(nx) * ny;
  Field values(parts * plane);
  const std::array<double, parts> uniform{start[0], start[1], 0.0, 0.0, start[2]};
  for (int c = 0; c < parts; ++c) {
    double* to = values.data() + c * plane;
    std::fill_n(to, plane, uniform[c]);
    middle_.nodes().gather_first(nodes.data() + c * middle_.nodes().box().surface_size(), nx, ny,
                                 to);
    if (more == nullptr) continue;
    for (int i = 0; i < nx; ++i) {
      for (int j = 0; j < ny; ++j, ++to) {
        const int x = std::min(i * block(), grid.nx - 1), y = std::min(j * block(), grid.ny - 1);
        *to += more[c * step + static_cast<std::size_t>(x) * grid.ny + y];
      }
    }
  }
  Field out(plane);
  put_von_mises(values.data(), plane, out.data());
  return out;
}

Field StressBound::near_part(double depth, const Tractions& tractions) const {
  const Grid& grid = tables_->grid();
  const int reach = tables_->split().near_range;
  const bool periodic = tables_->is_periodic();
  if (depth >= tables_->split().near_bound_depth * std::min(grid.dx, grid.dy)) return {};
  Field sum(grid.surface_size(), 0.0);
  Grid around(2 * reach, 2 * reach, grid.dx, grid.dy);
  around.period = {2 * reach, 2 * reach, 0.0};
  const KernelOffsets offsets(around, 2 * reach, 2 * reach);
  for (const Traction kind : all_tractions) {
    const Field& field = tractions.of(kind);
    if (field.empty()) continue;
    const Field norm = near_norm(*tables_, kind, depth, around, offsets);
    for (int i = 0; i < grid.nx; ++i) {
      for (int j = 0; j < grid.ny; ++j) {
        const double load = std::fabs(field[static_cast<std::size_t>(i) * grid.ny + j]);
        if (load == 0) continue;
        for (int x = i - reach + 1; x < i + reach; ++x) {
          if (!periodic && (x < 0 || x >= grid.nx)) continue;
          const double* row = norm.data() + std::abs(x - i);
          double* to = sum.data() + static_cast<std::size_t>((x + grid.nx) % grid.nx) * grid.ny;
          if (periodic && (j < reach - 1 || j + reach > grid.ny)) {
            for (int y = j - reach + 1; y < j + reach; ++y) {
              to[(y + grid.ny) % grid.ny] +=
                  load * row[static_cast<std::ptrdiff_t>(std::abs(y - j)) * offsets.nx];
            }
            continue;
          }
          for (int y = std::max(0, j - reach + 1); y < std::min(grid.ny, j + reach); ++y) {
            to[y] += load * row[static_cast<std::ptrdiff_t>(std::abs(y - j)) * offsets.nx];
          }
        }
      }
    }
  }
  return sum;
}

void StressBound::evaluate(const Group& group, const Loads& loads, double shear_sign,
                           const Given& given, const Use& use) const {
  const Grid& grid = tables_->grid();
  const int count = static_cast<int>(group.depths.size());
  const auto spectrum_of = [&](const VolumeTransform& transform, const TractionStress& stress,
                               const Tractions& tractions) {
    VolumeSpectrum spectrum = tables_->borrow_spectrum(transform, count, Tensor::deviator);
    std::fill(spectrum.data.begin(), spectrum.data.end(), 0.0);
    stress.add(tractions, shear_sign, spectrum);
    return spectrum;
  };
  VolumeSpectrum far = spectrum_of(far_transform_, group.far, loads.far);
  VolumeSpectrum middle = group.has_middle
                              ? spectrum_of(middle_transform_, group.middle, loads.middle)
                              : VolumeSpectrum(middle_transform_, 0, Tensor::deviator);
  check_interrupt();
  const Field more = given.more ? given.more(group.depths) : Field{};
  const Box rows = middle_.nodes().box();
  const std::size_t far_plane = far_transform_.plane_size();
  const std::size_t middle_plane = middle_transform_.plane_size();
#pragma omp parallel for schedule(dynamic)
  for (int k = 0; k < count; ++k) {
    const Uninterrupted quiet;
    const SingleThread alone;
    Field far_layer(parts * far_plane), nodes(parts * rows.surface_size(), 0.0), room;
    inverse(far_transform_, far, k, far_layer.data());
    if (group.has_middle) {
      Field layer(parts * middle_plane);
      inverse(middle_transform_, middle, k, layer.data());
      for (int c = 0; c < parts; ++c) {
        extract(middle_.sheet_of(layer.data() + c * middle_plane, room), middle_.sheet(),
                nodes.data() + c * rows.surface_size(), rows);
      }
    }
    for (int c = 0; c < parts; ++c) {
      far_.nodes().gather(far_.sheet_of(far_layer.data() + c * far_plane, room), far_.sheet(), rows,
                          nodes.data() + c * rows.surface_size());
    }
    const Field corners = at_corners(nodes, given.start[group.first + k],
                                     more.empty() ? nullptr : more.data() + k * grid.surface_size(),
                                     count * grid.surface_size());
    const Field near = near_part(group.depths[k], loads.cells);
    const int nx = blocks_x(), ny = blocks_y(), block = this->block();
    Field bound(static_cast<std::size_t>(nx) * ny);
    for (int i = 0; i < nx; ++i) {
      const double* row = corners.data() + static_cast<std::size_t>(i) * (ny + 1);
      for (int j = 0; j < ny; ++j) {
        double near_max = 0.0;
        for (int x = i * block; !near.empty() && x < std::min(grid.nx, (i + 1) * block); ++x) {
          for (int y = j * block; y < std::min(grid.ny, (j + 1) * block); ++y) {
            near_max = std::max(near_max, near[static_cast<std::size_t>(x) * grid.ny + y]);
          }
        }
        bound[static_cast<std::size_t>(i) * ny + j] =
            near_max + std::max({row[j], row[j + 1], row[ny + 1 + j], row[ny + 2 + j]});
      }
    }
    use(group.first + k, bound.data());
  }
  tables_->give_back(std::move(far.data));
  if (group.has_middle) tables_->give_back(std::move(middle.data));
}

void StressBound::for_each_depth(const Tractions& tractions, double shear_sign, const Given& given,
                                 const Use& use) const {
  const Grid& grid = tables_->grid();
  Loads loads{tractions, spread(tractions, Box::surface(grid), grid.ny, middle_), {}};
  loads.far = spread(loads.middle, middle_.own(), middle_.pitch(), far_);
  for (const auto& group : groups_) evaluate(*group, loads, shear_sign, given, use);
}

std::size_t StressBound::bytes() const {
  std::size_t bytes = 0;
  for (const auto& group : groups_) bytes += group->middle.bytes() + group->far.bytes();
  return bytes;
}

}  // namespace samcontact::operators
