// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/state/state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "samcontact/base/reduce.hpp"
#include "samcontact/simulation/cells/traction_window.hpp"
#include "samcontact/simulation/state/contact_fields.hpp"
#include "samcontact/simulation/state/surface_fields.hpp"

namespace samcontact::simulation {

namespace {

/// Initial state of surfaces with attraction: separated, just before contact under the maximum
/// tension; if the attraction decreases with the gap, so far that it is negligible.
void part(State& state) {
  const Setup& setup = state.setup();
  if (setup.contact_law->varies()) {
    state.approach -= setup.contact_law->reach();
    return;
  }
  const Field pull = contact::attraction(*setup.contact_law, setup.initial_gap);
  contact::add_scaled(-1.0, pull, state.tractions.pressure);
  state.load =
      -setup.grid.cell_area() * ordered_sum(pull.size(), [&](std::size_t i) { return pull[i]; });
  const Field attracted = gap(state);
  state.approach += *std::min_element(attracted.begin(), attracted.end());
}

}  // namespace

State::State(std::shared_ptr<const Setup> setup, operators::ResidualMethod method_)
    : method(method_), setup_(std::move(setup)) {
  tractions.pressure.assign(setup_->grid.surface_size(), 0.0);
  approach = *std::min_element(setup_->initial_gap.begin(), setup_->initial_gap.end());
  if (setup_->contact_law->attracts()) part(*this);
}

PastHeat State::heat_so_far() const {
  PastHeat so_far = past;
  if (!setup_->transient_heating.is_on() || time == 0) return so_far;
  for (int b = 0; b < 2; ++b) {
    if (b == 1 && heating[0] == heating[1] && past[0] == past[1] &&
        setup_->media[0] == setup_->media[1]) {
      so_far[1] = so_far[0];
      continue;
    }
    if (!past[b] && heating[b].factor == 0) continue;
    auto history = std::make_shared<operators::HeatHistory>(
        past[b] ? *past[b] : setup_->heat_history(b, heating[b]));
    Field flux = heating[b].is_of_slip() ? slip_power : tractions.pressure;
    flux.resize(tractions.pressure.size(), 0.0);
    for (double& q : flux) q *= heating[b].factor;
    history->add(flux.data(), duration,
                 setup_->transient_heating.follows()
                     ? operators::PlaneVector{heating[b].speed_x, heating[b].speed_y}
                     : operators::PlaneVector{});
    so_far[b] = std::move(history);
  }
  return so_far;
}

PastHeat State::heat_so_far(const Travel& by) const {
  PastHeat moved = heat_so_far();
  if (!setup_->transient_heating.follows()) return moved;
  const bool shared = moved[0] == moved[1] && by.x[0] == by.x[1] && by.y[0] == by.y[1];
  for (int b = 0; b < 2; ++b) {
    if (!moved[b] || !by.moves(b)) continue;
    if (b == 1 && shared) {
      moved[1] = moved[0];
      continue;
    }
    auto history = std::make_shared<operators::HeatHistory>(*moved[b]);
    const Grid& grid = setup_->grid;
    history->move({by.x[b], by.y[b] * grid.dy / grid.dx});
    moved[b] = std::move(history);
  }
  return moved;
}

fft::Symmetry State::heat_symmetry_so_far() const {
  if (!heating[0].is_on() && !heating[1].is_on()) return past_symmetry;
  const fft::Symmetry flux = symmetry_of(tractions.pressure, setup_->grid);
  return common(past_symmetry, common(flux, symmetry_of(heating)));
}

std::array<double, 3> State::tangential_force() const {
  const Field both = shear_vectors(tractions);
  return both.empty() ? std::array<double, 3>{} : contact::forces(setup_->grid, both);
}

contact::AboutAxes State::moment() const {
  return contact::moments(setup_->grid, tractions.pressure);
}

State State::moved(const Travel& to) const {
  State state = *this;
  state.travel = to;
  state.advance = {{to.x[0] - travel.x[0], to.x[1] - travel.x[1]},
                   {to.y[0] - travel.y[0], to.y[1] - travel.y[1]}};
  const Grid& grid = setup_->grid;
  const Placement from = placement(), place = state.placement();
  const Cells cells{static_cast<int>(std::lround(place.origin - from.origin)), 0};
  state.tractions.pressure = simulation::moved(tractions.pressure, grid, cells);
  state.tractions.shear_x = simulation::moved(tractions.shear_x, grid, cells);
  state.tractions.shear_y = simulation::moved(tractions.shear_y, grid, cells);
  state.slip_rate = simulation::moved(slip_rate, grid, cells);
  state.plastic_slip = simulation::moved(plastic_slip, grid, cells);
  state.contact_gap.clear();
  require_followed(eigenstrain, *setup_, to);
  for (int b = 0; b < 2; ++b) {
    const int by = from.first[b] - place.first[b], across = from.first_y[b] - place.first_y[b];
    state.memory[b] = simulation::moved(memory[b], grid, by);
    if (eigenstrain[b]) state.eigenstrain[b] = eigenstrain[b]->moved(by, across);
    for (auto* flow : {&state.inclusions_flow[b], &state.matrix_flow[b]}) {
      if (!*flow) continue;
      const auto own = common((*flow)->symmetry(), fft::Symmetry::y);
      *flow = unfolded(*flow, grid, own)->moved(by, 0);
    }
    if (!plastic[b]) continue;
    if (b == 1 && plastic[0] == plastic[1] && by == from.first[0] - place.first[0] &&
        across == from.first_y[0] - place.first_y[0]) {
      state.plastic[1] = state.plastic[0];
      continue;
    }
    const auto symmetry =
        common(plastic[b]->symmetry(), across == 0 ? fft::Symmetry::y : fft::Symmetry::none);
    state.plastic[b] = unfolded(plastic[b], grid, symmetry)->moved(by, across);
  }
  return state;
}

std::array<TrackTractions, 2> State::delayed() const {
  std::array<TrackTractions, 2> delayed;
  for (int b = 0; b < 2; ++b) {
    if (!memory[b]) continue;
    delayed[b] = equivalent(*memory[b], RelaxingBody(*setup_, b));
    delayed[b].add(-1.0, tractions, setup_->grid, false);
  }
  return delayed;
}

operators::Tractions State::equivalent_tractions(int body) const {
  if (!memory[body]) return tractions;
  const TrackTractions track = equivalent(*memory[body], RelaxingBody(*setup_, body));
  return track.of_box(Box::surface(setup_->grid));
}

double State::viscous_work(int body) const {
  if (!memory[body]) return 0.0;
  const double stored = stored_energy(*memory[body], RelaxingBody(*setup_, body));
  const double lost = memory[body]->supplied - stored;
  // Rounding of the difference must not appear as a gain of energy.
  return std::fabs(lost) <= 1e-12 * stored ? std::max(lost, 0.0) : lost;
}

operators::Tractions State::tractions_on(int body) const {
  return seen_from_body(tractions, setup_->grid, placement().offset[body]);
}

int State::layers() const {
  Box box = setup_->volume_below(repulsion(*this));
  if (setup_->grid.nz > 0) return box.nz;
  for (const auto* strains : {&plastic, &eigenstrain}) {
    for (const auto& strain : *strains) {
      if (strain) box.nz = std::max(box.nz, strain->box().nz);
    }
  }
  return box.nz;
}

Box State::below(Layers layers) const {
  const Grid& grid = setup_->grid;
  return {0, 0, grid.nx, grid.ny, layers ? *layers : this->layers()};
}

}  // namespace samcontact::simulation
