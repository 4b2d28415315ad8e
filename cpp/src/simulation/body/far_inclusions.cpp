// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/body/far_inclusions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "samcontact/base/deviator.hpp"
#include "samcontact/fft/rows.hpp"
#include "samcontact/simulation/body/cell_history.hpp"
#include "samcontact/simulation/cells/tensor_fields.hpp"
#include "samcontact/simulation/cells/traction_window.hpp"
#include "samcontact/simulation/strain/acting_strain.hpp"

namespace samcontact::simulation {

using operators::Tensor;

namespace {

/// Extent of the near box beyond the tractions and its depth, relative to their smaller width.
constexpr double margin_of_width = 0.25, depth_of_width = 0.75;
/// Cells of the wake are at the yield stress: less than this excess is an error of the single step.
constexpr double yield_excess = 0.02;
/// Number of increments of a motion from one renewal of far inclusions to the next.
constexpr int increments_of_effect = 2;
/// Largest length of this motion, relative to the box near the contact.
constexpr double length_of_width = 0.125;

/// Stress of the cells of a box and displacement of its surface.
struct Response {
  Field stress, displacement;  // [component][k][i][j] [Pa] and [i][j] [m]

  /// tractions: on the box. rows: of the box in which the stress is needed.
  Response(const operators::VolumeOperators& operators, const Box& box, const Field& strain,
           const operators::Tractions& tractions, double shear_sign,
           const std::vector<fft::RowRun>& rows)
      : stress(6 * box.volume_size()), displacement(box.surface_size()) {
    operators::VolumeSpectrum spectrum = operators.make_spectrum();
    operators::forward(operators.transform(), strain.data(), spectrum);
    operators.residual_displacement(operators::Axis::z).apply(spectrum, displacement.data());
    const std::size_t plane = box.surface_size();
    operators.for_each_layer(
        spectrum, strain.data(), &tractions, shear_sign,
        [&](int k, const double* layer) {
          for (std::size_t c = 0; c < 6; ++c) {
            std::copy_n(layer + c * plane, plane, stress.data() + (c * box.nz + k) * plane);
          }
        },
        box.nz, [&](int) { return std::span<const fft::RowRun>(rows); });
  }
};

Box layer_of(Box box) {
  box.nz = 1;
  return box;
}

/// Stress, strain and history of the cells of a box around all inclusions.
class FarStep {
 public:
  FarStep(const State& from, int body, const PlasticState& history, const FarReach& reach,
          const Sources& sources)
      : from_(from),
        setup_(from.setup()),
        body_(body),
        near_(reach.box),
        surface_(reach.surface),
        around_(acting_box(history, surface_.united(near_), setup_.reach)),
        zones_({around_}),
        fields_(history.fields(zones_)),
        cells_(setup_.bodies[body],
               MixedCells(setup_, body, from.placement().first[body], fft::Symmetry::none,
                          {from.inclusions_flow[body], from.matrix_flow[body]})) {
    cells_.take(zones_, fields_.equivalent, fields_.backstress, setup_.strength(body, from.travel));
    const Box seen = near_.united({0, near_.j0, setup_.grid.nx, 1, 1});
    Response all = response(around_, seen, fields_.strain);
    find_effect(all, history);
    stress_ = std::move(all.stress);
    sources.stress(body, around_, Tensor::full, stress_);
  }

  /// Effect of the present strain outside the near box.
  std::shared_ptr<const FarEffect> take_effect() {
    return std::make_shared<const FarEffect>(std::move(effect_));
  }

  /// Renews the strain of far cells; returns a box around those that flow.
  Box renew() {
    const CellHistory::Limits limits = cells_.first_limits();
    Box yielding;
    for (std::uint32_t n = 0; n < zones_.cells(); ++n) {
      const Cell cell = zones_.cell(n);
      if (cell.i < 0 || cell.i >= setup_.grid.nx || is_near(cell)) continue;
      const bool flows = cells_.mixed().at(n) != nullptr ? !renew(n) : yields(n, limits);
      if (flows) yielding = yielding.united({cell.i, cell.j, 1, 1, cell.k + 1});
    }
    return yielding;
  }

  /// History with the renewed strain in the grid.
  std::shared_ptr<const PlasticState> history(const PlasticState& before) const {
    const Box grid{0, around_.j0, setup_.grid.nx, around_.ny, around_.nz};
    const Zones stored({around_.intersected(grid)});
    const auto part = [&](const Field& field) {
      const std::size_t count = field.size() / zones_.cells();
      Field out(count * stored.cells());
      for (std::size_t c = 0; c < count; ++c) {
        copy_common(field.data() + c * zones_.cells(), zones_, out.data() + c * stored.cells(),
                    stored);
      }
      return out;
    };
    const PlasticFields fields{stored, part(fields_.strain), part(fields_.equivalent),
                               part(fields_.backstress)};
    return std::make_shared<const PlasticState>(&before, fft::Symmetry::none, Tensor::full, fields);
  }

 private:
  /// seen: contains the rows in which the stress is needed.
  Response response(const Box& box, const Box& seen, const Field& strain) const {
    const auto& cache = setup_.cache;
    const auto operators = box == around_ ? cache.volume_of_motion(body_, box, from_.method)
                                          : cache.volume(body_, box, Tensor::full, from_.method,
                                                         fft::Symmetry::none, {});
    std::vector<char> used(box.nx, 0);
    for (int i = std::max(box.i0, seen.i0); i < std::min(box.i0 + box.nx, seen.i0 + seen.nx); ++i) {
      used[i - box.i0] = 1;
    }
    return {*operators,
            box,
            strain,
            window(from_.tractions, setup_.grid, box),
            operators::shear_sign(body_),
            fft::runs_of(used)};
  }
  /// What remains of the response to all strain without that in the near box.
  void find_effect(const Response& all, const PlasticState& history) {
    const Response own = response(near_, near_, history.strain(near_));
    Field stress = cut(all.stress, around_, near_);
    for (std::size_t i = 0; i < stress.size(); ++i) stress[i] -= own.stress[i];
    const Box surface{surface_.i0, around_.j0, surface_.nx, around_.ny, 1};
    Field of_near(around_.surface_size(), 0.0), rest = all.displacement;
    copy_common(own.displacement.data(), layer_of(near_), of_near.data(), layer_of(around_));
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= of_near[i];
    Field displacement(surface.surface_size());
    extract(rest.data(), layer_of(around_), displacement.data(), surface);
    const int first = from_.placement().first[body_];
    effect_ = {first, 1, near_, surface, std::move(stress), std::move(displacement)};
  }
  bool is_near(const Cell& cell) const {
    return cell.k < near_.nz && cell.i >= near_.i0 && cell.i < near_.i0 + near_.nx &&
           cell.j >= near_.j0 && cell.j < near_.j0 + near_.ny;
  }
  plasticity::Tensor of(const Field& field, std::uint32_t n) const {
    plasticity::Tensor t;
    for (std::size_t c = 0; c < 6; ++c) t[c] = field[c * zones_.cells() + n];
    return t;
  }
  /// Whether a mixed cell does not flow: its strain is then renewed.
  bool renew(std::uint32_t n) {
    plasticity::Tensors place;
    const plasticity::MixedReturn step =
        cells_.mixed().step(n, of(stress_, n), of(fields_.strain, n), cells_.before(n, place));
    if (step.overshoot > yield_excess) return false;
    for (std::size_t c = 0; c < 6; ++c) {
      fields_.strain[c * zones_.cells() + n] = step.eigenstrain[c];
    }
    return true;
  }
  bool yields(std::uint32_t n, const CellHistory::Limits& limits) const {
    const plasticity::Tensor s = of(stress_, n);
    const double mean = (s[0] + s[1] + s[2]) / 3;
    std::array<double, 5> effective{s[0] - mean, s[1] - mean, s[3], s[4], s[5]};
    if (cells_.has_backstress()) {
      const auto centre = cells_.centre(n);
      for (int c = 0; c < 5; ++c) effective[c] -= centre[c];
    }
    const double second =
        second_invariant(effective[0], effective[1], effective[2], effective[3], effective[4]);
    return second > (1 + yield_excess) * (1 + yield_excess) * cells_.limit(n, second, limits);
  }

  const State& from_;
  const Setup& setup_;
  int body_;
  Box near_, surface_, around_;
  Zones zones_;
  PlasticFields fields_;
  CellHistory cells_;
  FarEffect effect_;
  Field stress_;
};

}  // namespace

Box box_near_tractions(const State& from) {
  const Grid& grid = from.setup().grid;
  Box near = window_of(from.tractions, grid);
  if (near.empty()) return {};
  const double width = std::min(near.nx * grid.dx, near.ny * grid.dy);
  const int more_x = static_cast<int>(std::ceil(margin_of_width * width / grid.dx)),
            more_y = static_cast<int>(std::ceil(margin_of_width * width / grid.dy));
  near.nz = static_cast<int>(std::ceil(depth_of_width * width / grid.dz));
  return {near.i0 - more_x, near.j0 - more_y, near.nx + 2 * more_x, near.ny + 2 * more_y, near.nz};
}

FarReach reach_of_motion(const State& from, int body, const Box& near) {
  const double by = from.advance.x[body];
  const int length = (increments_of_effect - 1) * static_cast<int>(std::lround(std::fabs(by)));
  const bool pays = by == std::round(by) && length <= length_of_width * near.nx;
  const int more = pays ? length : 0, before = by > 0 ? more : 0;
  const auto widened = [&](Box box) {
    box.i0 -= before;
    box.nx += more;
    return box;
  };
  return {widened(near), widened({0, 0, from.setup().grid.nx, 1, 1})};
}

std::shared_ptr<const FarEffect> kept_effect(const State& from, int body, const Box& required) {
  const auto& last = from.far_effect[body];
  if (!last || last->increments >= increments_of_effect) return nullptr;
  const int first = from.placement().first[body], by = last->first - first;
  const Grid& grid = from.setup().grid;
  const Box box = last->box.moved(by, 0), surface = last->surface.moved(by, 0);
  const bool inside = box.i0 >= 0 && box.i0 + box.nx <= grid.nx;
  if (!inside || !box.contains(required) || surface.i0 > 0 || surface.i0 + surface.nx < grid.nx) {
    return nullptr;
  }
  auto effect = std::make_shared<FarEffect>(*last);
  effect->first = first;
  ++effect->increments;
  effect->box = box;
  effect->surface = surface;
  return effect;
}

OutsideStrain outside_of(const FarEffect& effect) {
  OutsideStrain outside{.surface = effect.surface, .stress = {effect.stress}};
  outside.displacement[static_cast<int>(operators::Axis::z)] = effect.displacement;
  return outside;
}

FarInclusions renew_far_inclusions(const State& from, int body, const PlasticState& history,
                                   const FarReach& reach, const Sources& sources) {
  FarStep step(from, body, history, reach, sources);
  const Box yielding = step.renew();
  return {step.history(history), step.take_effect(), yielding};
}

}  // namespace samcontact::simulation
