// SPDX-License-Identifier: GPL-3.0-or-later
// Binding functions of the rooms of the core, and of parts of rooms with a file of their own.
#pragma once

#include <pybind11/pybind11.h>

namespace samcontact::bindings {

void bind_base(pybind11::module_& m);
void bind_kernels(pybind11::module_& parent);
void bind_heating(pybind11::module_& m);
void bind_operators(pybind11::module_& parent);
void bind_plasticity(pybind11::module_& m);
void bind_contact(pybind11::module_& m);
void bind_state(pybind11::module_& m);
void bind_simulation(pybind11::module_& m);
void bind_film(pybind11::module_& m);
void bind_fatigue(pybind11::module_& parent);

}  // namespace samcontact::bindings
