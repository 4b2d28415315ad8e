// SPDX-License-Identifier: GPL-3.0-or-later
// Increments of bodies that stick and slip: shear is an unknown of the contact as pressure is, and
// what the plastic strain does along the surface enters its condition of stick.
#include "samcontact/simulation/plastic_increment.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "samcontact/operators/surface_displacement.hpp"

namespace samcontact::simulation {
namespace {

/// How far both bodies move on, on the mean [m].
double way_of(const State& state) {
  return 0.5 * (state.advance[0] + state.advance[1]) * state.scene().grid.dx;
}

/// Tractions where they were on the surface of a body that has moved on by some cells.
operators::Tractions taken_along(const operators::Tractions& tractions, const Grid& grid,
                                 int cells) {
  return {moved(tractions.pressure, grid, cells), moved(tractions.shear_x, grid, cells),
          moved(tractions.shear_y, grid, cells)};
}

/// How what body 1 moves on by more cells than body 2 carries its displacement along.
Field carried_apart(const Scene& scene, const operators::Tractions& of_body2, int more) {
  const Grid& grid = scene.grid;
  operators::Tractions difference = taken_along(of_body2, grid, more);
  const auto subtract = [](const Field& from, Field& to) {
    for (std::size_t i = 0; i < from.size(); ++i) to[i] -= from[i];
  };
  subtract(of_body2.pressure, difference.pressure);
  subtract(of_body2.shear_x, difference.shear_x);
  subtract(of_body2.shear_y, difference.shear_y);
  Field slip;
  for (const auto axis : {operators::Axis::x, operators::Axis::y}) {
    const Field u = operators::surface_displacement(grid, *scene.media[0], {}, difference,
                                                    operators::shear_sign(0), axis);
    for (const double v : u) slip.push_back(-v);
  }
  return slip;
}

}  // namespace

contact::ContactHistory PlasticIncrement::contact_before() const {
  const Grid& grid = scene_.grid;
  const Travel& by = from_.advance;
  contact::ContactHistory before;
  before.approach = from_.approach;
  if (by == Travel{}) {
    before.pressure = from_.tractions.pressure;
    before.shear = shear_vectors(from_.tractions);
    before.gap = from_.gap();
  } else {
    // Tractions of a moved state lie where its contact does, not where its cells came to.
    const Placement then = scene_.placement(advanced(from_.travel, {-by[0], -by[1]}));
    const Placement now = from_.placement();
    const int followed = std::max(scene_.followed(), 0);
    const int cells = then.first[followed] - now.first[followed] -
                      static_cast<int>(std::lround(now.origin - then.origin));
    const auto carried = taken_along(from_.tractions, grid, cells);
    before.has_moved = true;
    before.pressure = carried.pressure;
    before.shear = shear_vectors(carried);
    const int more = static_cast<int>(std::lround(by[0] - by[1]));
    const auto& media = scene_.media;
    if (more != 0 && !media[1 - followed]->is_rigid()) {
      before.free_slip = carried_apart(scene_, carried, more);
    }
  }
  before.shear.resize(2 * grid.surface_size(), 0.0);
  return before;
}

contact::TangentialDrive PlasticIncrement::tangential_drive() const {
  contact::TangentialDrive drive = target_.tangential;
  if (!drive[0].is_force()) {
    drive[0].value += (from_.advance[0] - from_.advance[1]) * scene_.grid.dx;
  }
  // The turn slips where particles are on their way.
  if (!drive[1].is_force()) drive[1].value -= contact::spin_lead * way_of(from_) * drive[2].value;
  return drive;
}

bool PlasticIncrement::rests() const {
  if (!scene_.coulomb) return true;
  const auto drive = tangential_drive();
  const auto is_zero = [](double v) { return v == 0; };
  return !scene_.coulomb->is_coupled() &&
         std::all_of(drive.begin(), drive.end(),
                     [](const contact::Given& given) { return given.value == 0; }) &&
         std::all_of(from_.tractions.shear_x.begin(), from_.tractions.shear_x.end(), is_zero) &&
         std::all_of(from_.tractions.shear_y.begin(), from_.tractions.shear_y.end(), is_zero);
}

contact::Solution PlasticIncrement::stick_and_slip(const Field& gap,
                                                   const contact::ContactSettings& settings) {
  const contact::CoulombStart start{tractions_.pressure, shear_.shear, shear_.sticking,
                                    shear_.motion};
  contact::CoulombSolution found = scene_.coulomb->solve(
      gap, target_.drive.normal, tangential_drive(), before_, start, settings);
  shear_ = std::move(found.tangential);
  contact::Solution solution = std::move(found.normal);
  solution.iterations += shear_.iterations;
  const auto middle = shear_.shear.begin() + static_cast<std::ptrdiff_t>(gap.size());
  solution.tractions.shear_x.assign(shear_.shear.begin(), middle);
  solution.tractions.shear_y.assign(middle, shear_.shear.end());
  return solution;
}

void PlasticIncrement::remember_slip(State& state) const {
  if (!scene_.coulomb) return;
  if (target_.is_prescribed()) {
    state.slip.clear();
    state.shear_symmetry = common(state.shear_symmetry, symmetry_of(tractions_, scene_.grid));
    return;
  }
  state.slip = shear_.slip;
  const auto& motion = shear_.motion;
  state.motion[0] += motion[0];
  state.motion[1] += motion[1] + contact::spin_lead * way_of(from_) * motion[2];
  state.motion[2] += motion[2];
  state.friction_work += shear_.friction_work;
  state.shear_symmetry = common(state.shear_symmetry, symmetry_of(tangential_drive()));
}

}  // namespace samcontact::simulation
