// SPDX-License-Identifier: GPL-3.0-or-later
// Mirror planes of fields, and the part of a grid from them on.
#pragma once

#include <vector>

#include "samcontact/base/box.hpp"
#include "samcontact/contact/tangential/shear_solver.hpp"
#include "samcontact/operators/heat/heating.hpp"
#include "samcontact/operators/volume/volume_operators.hpp"

namespace samcontact::simulation {

/// Mirror planes that heat leaves.
fft::Symmetry symmetry_of(const operators::HeatingPair& heating);
/// Mirror planes of a surface field, to 1e-10 of its largest value.
fft::Symmetry symmetry_of(const Field& field, const Grid& grid, kernels::Parity parity = {});
/// Those of tractions, which are along x and y.
fft::Symmetry symmetry_of(const operators::Tractions& tractions, const Grid& grid);
/// Those that the rigid motion of bodies which stick and slip leaves.
fft::Symmetry symmetry_of(const contact::TangentialDrive& drive);
/// Those that both have.
fft::Symmetry common(fft::Symmetry a, fft::Symmetry b);
/// The cells of the grid from the mirror planes on, all layers.
Box stored_part(const Grid& grid, fft::Symmetry symmetry);
/// The whole box of which `stored` is the part from the mirror planes on.
Box whole_box(const Box& stored, const Grid& grid, fft::Symmetry symmetry);

/// The part of a whole box from the mirror planes on.
Box part_of(const Box& whole, const Grid& grid, fft::Symmetry symmetry);

/// The smallest box from the mirror planes on that holds one beyond them.
Box from_planes_on(const Box& box, const Grid& grid, fft::Symmetry symmetry);
/// The whole boxes of several: one that lies off a plane has an image beside it.
std::vector<Box> whole_boxes(const std::vector<Box>& stored, const Grid& grid,
                             fft::Symmetry symmetry);
/// The reverse; what has no cells is left out.
std::vector<Box> parts_of(const std::vector<Box>& whole, const Grid& grid, fft::Symmetry symmetry);

/// One plane, given from the mirror planes on, in a box with fewer of them; odd: so is the field
/// about x = 0 or y = 0.
void unfold(const double* from, const Box& stored, fft::Symmetry had, bool odd_x, bool odd_y,
            double* to, const Box& box, const Grid& grid);

}  // namespace samcontact::simulation
