// SPDX-License-Identifier: GPL-3.0-or-later
// Plastic strain, hardening and yield strength of a state, as fields and scalars.
#pragma once

#include "samcontact/simulation/state/state.hpp"

namespace samcontact::simulation {

// Fields of a body (0 or 1) at mid-depth of its layers, [component][k][i][j] or [k][i][j] on the
// cells of the body, see Placement; over the grid, or over a region that may extend beyond it. They
// throw std::invalid_argument for a grid without layers or a rigid body.

Field plastic_strain(const State& state, int body, Layers layers = {});
Field plastic_strain(const State& state, int body, const Box& region);
/// Plastic strain of the matrix and of the inclusion in cells of two phases; elsewhere that of the
/// cell.
Field matrix_plastic_strain(const State& state, int body, Layers layers = {});
Field inclusion_plastic_strain(const State& state, int body, Layers layers = {});
/// Likewise the accumulated equivalent strain of the inclusion.
Field inclusion_equivalent_strain(const State& state, int body, Layers layers = {});
Field equivalent_plastic_strain(const State& state, int body, Layers layers = {});
Field equivalent_plastic_strain(const State& state, int body, const Box& region);
/// Prescribed eigenstrain [-]; of a body with inclusions in addition the strain that its matrix,
/// filling the whole body, needs to have the same stress: plastic strain, misfit and mismatch.
Field eigenstrain(const State& state, int body, Layers layers = {});
Field eigenstrain(const State& state, int body, const Box& region);
/// [term][component][k][i][j] [Pa], one term for each backstress of the material.
Field backstress(const State& state, int body, Layers layers = {});
Field backstress(const State& state, int body, const Box& region);
/// Factor of the yield stress due to its depth profile [-].
Field yield_factor(const State& state, int body, const Box& region);

/// Box of the cells with plastic strain if the fields do not contain all of them; else empty. Along
/// x only strain that arose at its present position counts: strain that has moved belongs to the
/// track.
Box strain_beyond(const State& state, int body);
/// Number of cells that have yielded, inside and outside the grid.
std::size_t plastic_cells(const State& state, int body);
/// Maximum accumulated equivalent plastic strain [-], without cells that inclusions fill partly; 0
/// for an elastic body.
double max_equivalent_plastic_strain(const State& state, int body);
/// Maximum sqrt(2/3 e:e) of the plastic strain [-], non-cumulative: alternating plastic flow does
/// not increase it.
double max_plastic_strain_magnitude(const State& state, int body);

}  // namespace samcontact::simulation
