// SPDX-License-Identifier: GPL-3.0-or-later
#include <pthread.h>
#include <pybind11/gil_safe_call_once.h>
#include <pybind11/stl.h>

#include <new>
#include <optional>
#include <string>
#include <utility>

#include "arrays.hpp"
#include "rooms.hpp"
#include "samcontact/base/aligned.hpp"
#include "samcontact/base/errors.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/law_parameters.hpp"
#include "samcontact/base/magnitude.hpp"
#include "samcontact/base/memory.hpp"
#include "samcontact/base/team.hpp"
#include "samcontact/fft/plan.hpp"

namespace samcontact::bindings {

namespace py = pybind11;

namespace {

/// Runs Python's signal handlers (Ctrl-C) and passes on what they raise.
void check_signals() {
  const py::gil_scoped_acquire gil;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

/// Raises MemoryError if less memory is available.
void check_memory(double bytes, const std::string& what) {
  release_kept_memory();
  const py::gil_scoped_acquire gil;
  py::module_::import("samcontact._util.memory").attr("require")(what, bytes);
}

/// Keeps the core usable in a child process forked between or during its calls.
void prepare_for_forks() {
  const auto lock = [] {
    fft::lock_plans();
    lock_memory();
  };
  const auto unlock = [] {
    unlock_memory();
    fft::unlock_plans();
  };
  const auto unlock_in_child = [] {
    unlock_memory();
    fft::unlock_plans();
    reset_team();
  };
  if (pthread_atfork(lock, unlock, unlock_in_child) != 0) throw std::bad_alloc();
}

void bind_errors(py::module_& m) {
  PYBIND11_CONSTINIT static py::gil_safe_call_once_and_store<py::object> convergence_error;
  convergence_error.call_once_and_store_result([&] {
    const py::exception<ConvergenceError> type(m, "ConvergenceError", PyExc_RuntimeError);
    type.attr("__doc__") =
        "Error of an iteration that did not reach its tolerance; see `iterations` and `residual`.\n"
        "The previous state is kept.";
    type.attr("iterations") = 0;
    type.attr("residual") = 0.0;
    return py::object(type);
  });
  PYBIND11_CONSTINIT static py::gil_safe_call_once_and_store<py::object> pull_off_error;
  pull_off_error.call_once_and_store_result([&] {
    const py::exception<PullOffError> type(m, "PullOffError", convergence_error.get_stored());
    type.attr("__doc__") =
        "Error of a load whose tension exceeds the largest tension that adhesion allows.\n"
        "`pull_off` is the largest tension reached [N]; `approach` is the approach there [m].";
    type.attr("pull_off") = 0.0;
    type.attr("approach") = 0.0;
    return py::object(type);
  });
  PYBIND11_CONSTINIT static py::gil_safe_call_once_and_store<py::object> too_small_error;
  too_small_error.call_once_and_store_result([&] {
    const py::exception<GridTooSmallError> type(m, "GridTooSmallError", PyExc_ValueError);
    type.attr("__doc__") =
        "Error of a contact that reaches the edge of the grid.\n"
        "`axes` names the directions to enlarge: x, y or xy.";
    type.attr("axes") = "";
    return py::object(type);
  });
  // NOLINTNEXTLINE(performance-unnecessary-value-param): the signature that pybind11 asks for.
  py::register_exception_translator([](std::exception_ptr p) {
    try {
      if (p) std::rethrow_exception(p);
    } catch (const std::bad_alloc&) {
      PyErr_SetString(PyExc_MemoryError, "out of memory: use fewer cells, or close other programs");
    } catch (const PullOffError& error) {
      const py::object& type = pull_off_error.get_stored();
      py::object value = type(error.what());
      value.attr("iterations") = error.iterations();
      value.attr("pull_off") = error.force();
      value.attr("approach") = error.approach();
      PyErr_SetObject(type.ptr(), value.ptr());
    } catch (const ConvergenceError& error) {
      const py::object& type = convergence_error.get_stored();
      py::object value = type(error.what());
      value.attr("iterations") = error.iterations();
      value.attr("residual") = error.residual();
      PyErr_SetObject(type.ptr(), value.ptr());
    } catch (const GridTooSmallError& error) {
      const py::object& type = too_small_error.get_stored();
      py::object value = type(error.what());
      value.attr("axes") = std::string(error.across_x() ? "x" : "") + (error.across_y() ? "y" : "");
      PyErr_SetObject(type.ptr(), value.ptr());
    }
  });
}

}  // namespace

void bind_base(py::module_& m) {
  set_interrupt_check(check_signals);
  set_memory_check(check_memory);
  fft::prepare_planner();
  prepare_for_forks();
  bind_errors(m);
  m.def(
      "magnitude_of",
      [](const Array& numbers) {
        const auto found = magnitude_of(numbers_of(numbers));
        return std::pair{found.largest, found.is_finite};
      },
      py::arg("numbers"));
  py::class_<LawParameter>(m, "LawParameter")
      .def_readonly("name", &LawParameter::name)
      .def_readonly("many", &LawParameter::many)
      .def_property_readonly("unit", [](const LawParameter& p) { return p.allowed.unit; })
      .def_property_readonly("low", [](const LawParameter& p) { return p.allowed.low; })
      .def_property_readonly("high", [](const LawParameter& p) { return p.allowed.high; })
      .def_property_readonly("above_low", [](const LawParameter& p) { return p.allowed.above_low; })
      .def_property_readonly("infinite", [](const LawParameter& p) -> std::optional<std::string> {
        if (p.allowed.infinite == nullptr) return {};
        return p.allowed.infinite;
      });
  py::class_<Grid>(m, "Grid")
      .def(py::init([](int nx, int ny, double dx, double dy, int nz, double dz, bool along_x,
                       bool along_y) {
             return Grid(nx, ny, dx, dy, nz, dz).made_periodic(along_x, along_y);
           }),
           py::arg("nx"), py::arg("ny"), py::arg("dx"), py::arg("dy"), py::arg("nz"), py::arg("dz"),
           py::arg("along_x") = false, py::arg("along_y") = false)
      .def_readonly("nx", &Grid::nx)
      .def_readonly("ny", &Grid::ny)
      .def_readonly("nz", &Grid::nz)
      .def_readonly("dx", &Grid::dx)
      .def_readonly("dy", &Grid::dy)
      .def_readonly("dz", &Grid::dz)
      .def("x", &Grid::x)
      .def("y", &Grid::y)
      .def("z", [](const Grid& grid, int layers) { return grid.z(layers); }, py::arg("layers"));
}

}  // namespace samcontact::bindings
