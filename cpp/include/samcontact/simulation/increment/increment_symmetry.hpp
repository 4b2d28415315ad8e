// SPDX-License-Identifier: GPL-3.0-or-later
// Mirror planes of an increment, in the grid and between the bodies.
#pragma once

#include "samcontact/simulation/increment/increment_task.hpp"

namespace samcontact::simulation {

/// Mirror planes of the increment: those of the scene, of the target, and of what happened before.
/// tractions: that are prescribed.
fft::Symmetry symmetry_of(const IncrementTask& task, const operators::Tractions& tractions,
                          const Sources& sources);
/// Whether both bodies are made of the same, and have gone and go through the same.
bool has_twins(const IncrementTask& task, const Sources& sources);

}  // namespace samcontact::simulation
