// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/typing.h>

#include <memory>
#include <stdexcept>

#include "arrays.hpp"
#include "samcontact/simulation/simulation.hpp"

namespace samcontact::bindings {

/// Factor of the yield stress as a function of the temperature rise [K], shape (nx, ny, nz).
using SofteningFunction = py::typing::Callable<Array(Values)>;

/// A SofteningFunction, called with the GIL. A law may refer to its simulation, and Python's
/// garbage collector cannot see references held by the core: Python's simulation therefore owns
/// the law, and the core has a weak reference.
inline simulation::Softening softening_law(const py::object& law, const Grid& grid) {
  // The last owner may release it on any thread.
  const std::shared_ptr<py::weakref> known(new py::weakref(law), [](py::weakref* p) {
    const py::gil_scoped_acquire gil;
    std::default_delete<py::weakref>()(p);
  });
  return [known, grid](const Field& rise, const Box& box) {
    const py::gil_scoped_acquire gil;
    const py::object own = (*known)();
    if (own.is_none()) throw std::logic_error("the softening law must outlive its simulation");
    const py::array factor = own(volume_array(rise, box.grid(grid), box.nz));
    return to_field(factor.cast<Array>());
  };
}

}  // namespace samcontact::bindings
