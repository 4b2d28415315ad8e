// SPDX-License-Identifier: GPL-3.0-or-later
#include "rooms.hpp"

PYBIND11_MODULE(_core, m) {
  m.doc() = "C++ core of samcontact; use the package samcontact instead.";
  m.attr("version") = SAMCONTACT_VERSION;
  samcontact::bindings::bind_base(m);
  samcontact::bindings::bind_kernels(m);
  samcontact::bindings::bind_plasticity(m);
  samcontact::bindings::bind_heating(m);
  samcontact::bindings::bind_operators(m);
  samcontact::bindings::bind_contact(m);
  samcontact::bindings::bind_simulation(m);
  samcontact::bindings::bind_film(m);
  samcontact::bindings::bind_fatigue(m);
}
