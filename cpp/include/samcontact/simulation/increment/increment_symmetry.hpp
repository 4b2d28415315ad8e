// SPDX-License-Identifier: GPL-3.0-or-later
// Mirror planes of an increment, in the grid and between the bodies.
#pragma once

#include "samcontact/simulation/increment/increment_task.hpp"

namespace samcontact::simulation {

/// Mirror planes of the increment: those of the grid and bodies, of the target, and of the loading
/// history. tractions: prescribed tractions.
fft::Symmetry symmetry_of(const IncrementTask& task, const operators::Tractions& tractions,
                          const Sources& sources);
/// Whether the two bodies are mirror images: equal materials, histories and loads.
bool bodies_are_mirror_images(const IncrementTask& task, const Sources& sources);

}  // namespace samcontact::simulation
