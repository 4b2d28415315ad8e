// SPDX-License-Identifier: GPL-3.0-or-later
// Temperature rise in a half-space due to a rectangle of uniform heat flux, for any heating time
// and velocity.
#pragma once

#include "samcontact/base/aligned.hpp"
#include "samcontact/kernels/heat_source.hpp"

namespace samcontact::kernels {

/// k T / q [length] at depth z, table [i][j]; T the temperature rise [K], q the flux into the body
/// [W/m^2], k the conductivity [W/(m K)]. Green's function of a point source, integrated in closed
/// form over the rectangle: Carslaw & Jaeger (1959), sections 10.4 and 10.7. The error is about tol
/// times the largest value.
Field heat_temperature(const HeatSource& source, const HeatPoints& points, double z, double tol);

}  // namespace samcontact::kernels
