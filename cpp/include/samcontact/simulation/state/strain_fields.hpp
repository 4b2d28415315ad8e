// SPDX-License-Identifier: GPL-3.0-or-later
// Plastic strain, hardening and strength of a state in fields and numbers.
#pragma once

#include "samcontact/simulation/state/state.hpp"

namespace samcontact::simulation {

// Fields of a body (0 or 1) at mid-depth of its layers, [component][k][i][j] or [k][i][j] in the
// body's cells, see Placement; of the grid, or over a region that may lie beside it. They throw
// std::invalid_argument for a grid without volume or a rigid body.

Field plastic_strain(const State& state, int body, Layers layers = {});
Field plastic_strain(const State& state, int body, const Box& region);
Field equivalent_plastic_strain(const State& state, int body, Layers layers = {});
Field equivalent_plastic_strain(const State& state, int body, const Box& region);
/// The eigenstrain that is given.
Field eigenstrain(const State& state, int body, Layers layers = {});
Field eigenstrain(const State& state, int body, const Box& region);
/// [term][component][k][i][j], as many terms as the material has backstresses.
Field backstress(const State& state, int body, Layers layers = {});
Field backstress(const State& state, int body, const Box& region);
/// Factor of the yield stress by its profile over depth.
Field yield_factor(const State& state, int body, const Box& region);

/// The cells with plastic strain, where fields do not have all of them; else empty. Along x only
/// what has flowed where it is: what has moved is on the track.
Box strain_beyond(const State& state, int body);
/// Cells that have yielded, wherever they lie.
std::size_t plastic_cells(const State& state, int body);
/// Largest accumulated equivalent plastic strain; 0 for a body without.
double max_equivalent_plastic_strain(const State& state, int body);
/// Largest sqrt(2/3 e:e) of the plastic strain, which flow to and fro does not raise.
double max_plastic_strain_magnitude(const State& state, int body);

}  // namespace samcontact::simulation
