// SPDX-License-Identifier: GPL-3.0-or-later
// Mirror planes of fields, and the stored part of a grid on one side of them.
#pragma once

#include <vector>

#include "samcontact/base/box.hpp"
#include "samcontact/contact/tangential/shear_solver.hpp"
#include "samcontact/operators/heat/heating.hpp"
#include "samcontact/operators/volume/volume_operators.hpp"

namespace samcontact::simulation {

/// Mirror planes that heat permits.
fft::Symmetry symmetry_of(const operators::HeatingPair& heating);
/// Mirror planes of a surface field, to 1e-10 of its largest value.
fft::Symmetry symmetry_of(const Field& field, const Grid& grid, kernels::Parity parity = {});
/// Mirror planes of tractions along x and y.
fft::Symmetry symmetry_of(const operators::Tractions& tractions, const Grid& grid);
/// Mirror planes of the rigid motion under partial slip.
fft::Symmetry symmetry_of(const contact::TangentialDrive& drive);
/// Mirror planes of tilts and moments.
fft::Symmetry symmetry_of(const contact::Drive& drive);
/// Mirror planes common to both.
fft::Symmetry common(fft::Symmetry a, fft::Symmetry b);
/// Grid cells on one side of the mirror planes, all layers.
Box stored_part(const Grid& grid, fft::Symmetry symmetry);
/// Whole box of a stored part.
Box whole_box(const Box& stored, const Grid& grid, fft::Symmetry symmetry);

/// Stored part of a whole box.
Box part_of(const Box& whole, const Grid& grid, fft::Symmetry symmetry);

/// Smallest stored box that represents a box, parts beyond the mirror planes included.
Box from_planes_on(const Box& box, const Grid& grid, fft::Symmetry symmetry);
/// Whole boxes of several stored ones: a box that lies off a plane has a mirror image of its own.
std::vector<Box> whole_boxes(const std::vector<Box>& stored, const Grid& grid,
                             fft::Symmetry symmetry);
/// Stored parts of several whole boxes; empty parts are omitted.
std::vector<Box> parts_of(const std::vector<Box>& whole, const Grid& grid, fft::Symmetry symmetry);

/// Copies one stored plane into a box with fewer mirror planes; odd_x, odd_y: whether the field is
/// odd about x = 0 or y = 0.
void unfold(const double* from, const Box& stored, fft::Symmetry had, bool odd_x, bool odd_y,
            double* to, const Box& box, const Grid& grid);

}  // namespace samcontact::simulation
