// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/state/description.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "samcontact/base/errors.hpp"
#include "samcontact/simulation/cells/box_choice.hpp"

namespace samcontact::simulation {
namespace {

/// Maximum distance from the origin of a body [cells].
constexpr int largest_index = 1 << 30;
constexpr auto in_range = "less than 2^30 cells in magnitude";
constexpr auto no_fit = "the arrays of a plastic history do not match its zones";

void require_that(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

bool is_one_of(fft::Symmetry symmetry) {
  return symmetry >= fft::Symmetry::none && symmetry <= fft::Symmetry::xy;
}

/// Whether it is a valid box, within the range of cell indices.
bool is_box(const Box& box, const Grid& grid) {
  const auto counted = [](int first, int count) {
    return std::abs(static_cast<long>(first)) < largest_index && count >= 0 &&
           count < largest_index;
  };
  const double cells = 1.0 * box.nx * box.ny * box.nz;
  return counted(box.i0, box.nx) && counted(box.j0, box.ny) && counted(0, box.nz) &&
         cells < largest_index * 8.0 && (box.nz == 0 || grid.has_volume()) &&
         (grid.period.x == 0 || (box.i0 >= 0 && box.i0 + box.nx <= grid.nx)) &&
         (grid.period.y == 0 || (box.j0 >= 0 && box.j0 + box.ny <= grid.ny));
}

bool is_consistent(const BoxField& field, const Grid& grid) {
  return is_box(field.box, grid) && field.values.size() == field.box.volume_size();
}

void require_consistent(const PlasticIncrementGuess& flow) {
  bool fits = is_one_of(flow.symmetry) && std::isfinite(flow.load) && std::isfinite(flow.approach);
  for (const auto& body : flow.bodies) {
    const std::size_t n = body.cells.size();
    fits = fits && (body.strain.size() == 5 * n || body.strain.size() == 6 * n) &&
           std::all_of(body.cells.begin(), body.cells.end(), [&](const Cell& cell) {
             return std::abs(static_cast<long>(cell.i)) < largest_index &&
                    std::abs(static_cast<long>(cell.j)) < largest_index && cell.k >= 0;
           });
  }
  require_that(fits, "the plastic strain increment of the last increment is invalid");
}

bool is_consistent(const FarEffect& effect, const Grid& grid) {
  const auto& [first, increments, box, surface, stress, displacement] = effect;
  return is_box(box, grid) && is_box(surface, grid) &&
         std::abs(static_cast<long>(first)) < largest_index && increments > 0 && surface.nz == 1 &&
         stress.size() == 6 * box.volume_size() && displacement.size() == surface.surface_size();
}

void require_consistent(const TractionMemory* memory, const State& state, int body) {
  if (memory == nullptr) return;
  const Grid& grid = state.setup().grid;
  const std::size_t terms = state.setup().bodies[body].relaxation().terms();
  const Box& box = memory->box;
  // Along x it may extend beyond a grid that is not periodic.
  const bool free = grid.period.x == 0 && std::abs(static_cast<long>(box.i0)) < largest_index;
  const Box along{free ? 0 : box.i0, box.j0, free ? 1 : box.nx, box.ny, 1};
  require_that(terms > 0 && box.nx >= 0 && box.ny >= 0 && box.nz == 1 && memory->kinds >= 0 &&
                   memory->kinds < 8 && (box.empty() || Box::surface(grid).contains(along)) &&
                   memory->values.size() == memory->count() * (terms + 1) * box.surface_size(),
               "the traction memory of a body does not match the grid and its relaxation");
}

}  // namespace

PlasticRecord record(const PlasticState& history) {
  PlasticFields fields = history.fields(history.zones());
  return {history.symmetry(),           history.tensor(),
          history.lattice().origin,     history.box(),
          fields.zones.boxes(),         std::move(fields.strain),
          std::move(fields.equivalent), std::move(fields.backstress)};
}

std::shared_ptr<const PlasticState> from_record(const PlasticRecord& record, const Grid& grid,
                                                std::size_t backstresses) {
  const auto& [symmetry, tensor, origin, box, zones, strain, equivalent, backstress] = record;
  require(is_one_of(symmetry), "mirrored", "0, 1 or 2", static_cast<int>(symmetry));
  require(tensor == operators::Tensor::full || tensor == operators::Tensor::deviator, "tensor",
          "0 or 1", static_cast<int>(tensor));
  for (const int cell : origin) {
    require(std::abs(static_cast<long>(cell)) < largest_index, "origin", in_range, cell);
  }
  const Box part = stored_part(grid, symmetry);
  require_that(is_box(box, grid) && !box.empty() && box.nz > 0 &&
                   !is_unbounded({0, 0, 1, 1, box.nz}, grid) &&
                   (symmetry == fft::Symmetry::none || box.j0 == part.j0) &&
                   (symmetry != fft::Symmetry::xy || box.i0 == part.i0),
               "the box of a plastic history does not match the grid");
  std::size_t cells = 0;
  for (const Box& zone : zones) {
    require_that(is_box(zone, grid) && !zone.empty() && zone.nz > 0 && box.contains(zone),
                 "the zones of a plastic history must lie inside its box");
    cells += zone.volume_size();
    require_that(cells <= equivalent.size(), no_fit);
  }
  require_that(cells > 0 && equivalent.size() == cells &&
                   strain.size() == operators::count(tensor) * cells &&
                   backstress.size() == 5 * backstresses * cells,
               no_fit);
  require_that(are_disjoint(zones), "the zones of a plastic history overlap");
  return std::make_shared<const PlasticState>(
      nullptr, symmetry, tensor, PlasticFields{Zones(zones), strain, equivalent, backstress}, box,
      Lattice{origin, grid.period.x});
}

void require_consistent(const State& state) {
  using operators::ResidualMethod;
  const Grid& grid = state.setup().grid;
  const auto fits = [&](const Field& field) { return field.size() == grid.surface_size(); };
  require_that(fits(state.tractions.pressure), "the pressure does not match the grid");
  for (const Field* field : {&state.tractions.shear_x, &state.tractions.shear_y, &state.contact_gap,
                             &state.slip_power}) {
    require_that(field->empty() || fits(*field),
                 "shear, gap or slip power does not match the grid");
  }
  for (const auto& travels : {state.travel.x, state.travel.y}) {
    for (const double travel : travels) {
      require(std::fabs(travel) < largest_index, "travel", in_range, travel);
    }
  }
  require(state.method == ResidualMethod::exact || state.method == ResidualMethod::fast,
          "residual_method", "0 or 1", static_cast<int>(state.method));
  require(is_one_of(state.past_symmetry), "past_symmetry", "0, 1 or 2",
          static_cast<int>(state.past_symmetry));
  for (int b = 0; b < 2; ++b) {
    for (const Box& box : state.flow_boxes[b]) {
      require_that(is_box(box, grid) && !box.empty() && !is_unbounded(box, grid),
                   "the boxes of plastic flow are empty or too far from the grid");
    }
    require_that(are_disjoint(state.flow_boxes[b]), "the boxes of plastic flow overlap");
    require_that(
        !state.softening[b] || (is_consistent(*state.softening[b], grid) &&
                                state.softening[b]->box.contains(around(state.flow_boxes[b]))),
        "the softening of a body does not match the grid");
  }
  for (int b = 0; b < 2; ++b) require_consistent(state.memory[b].get(), state, b);
  if (state.last_flow) require_consistent(*state.last_flow);
  for (const auto& effect : state.far_effect) {
    require_that(!effect || is_consistent(*effect, grid),
                 "the effect of inclusions far from the contact does not match the grid");
  }
}

}  // namespace samcontact::simulation
