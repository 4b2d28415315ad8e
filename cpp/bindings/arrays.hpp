// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion of arrays between NumPy and the core.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/grid.hpp"

namespace samcontact::bindings {

namespace py = pybind11;

/// C-contiguous float64 only; the Python layer converts and checks the shape.
using Array = py::array_t<double, py::array::c_style>;
using MaybeArray = std::optional<Array>;
/// Results of the core: float64 in any memory order.
using Values = py::array_t<double>;

inline Field to_field(const Array& array) {
  return Field(array.data(), array.data() + array.size());
}

/// The numbers of an array, without a copy.
inline std::span<const double> numbers_of(const Array& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

/// None becomes an empty field.
inline Field to_field_or_empty(const MaybeArray& array) {
  return array ? to_field(*array) : Field{};
}

/// Hands a field's memory to NumPy.
inline Values own(Field field, py::array::ShapeContainer shape,
                  py::array::StridesContainer strides) {
  auto kept = std::make_unique<Field>(std::move(field));
  const double* values = kept->data();
  const py::capsule owner(kept.get(),
                          [](void* p) { std::default_delete<Field>()(static_cast<Field*>(p)); });
  // NumPy owns it now.
  static_cast<void>(kept.release());  // NOLINT(bugprone-unused-return-value)
  return Values(std::move(shape), std::move(strides), values, owner);
}

constexpr py::ssize_t item = sizeof(double);

inline Values surface_array(Field field, const Grid& grid) {
  return own(std::move(field), {grid.nx, grid.ny}, {item * grid.ny, item});
}

/// [component][i][j] of a vector of the surface.
template <int Components = 2>
Values vector_array(Field field, const Grid& grid) {
  const auto plane = static_cast<py::ssize_t>(grid.surface_size());
  return own(std::move(field),
             {py::ssize_t{Components}, py::ssize_t{grid.nx}, py::ssize_t{grid.ny}},
             {item * plane, item * grid.ny, item});
}

/// Depth-major [k][i][j] seen as (nx, ny, layers).
inline Values volume_array(Field field, const Grid& grid, py::ssize_t layers) {
  const auto plane = static_cast<py::ssize_t>(grid.surface_size());
  return own(std::move(field), {py::ssize_t{grid.nx}, py::ssize_t{grid.ny}, layers},
             {item * grid.ny, item, item * plane});
}

/// Depth-major [component][k][i][j] seen as (6, nx, ny, layers).
inline Values tensor_array(Field field, const Grid& grid, py::ssize_t layers) {
  const auto plane = static_cast<py::ssize_t>(grid.surface_size());
  return own(std::move(field), {py::ssize_t{6}, py::ssize_t{grid.nx}, py::ssize_t{grid.ny}, layers},
             {item * plane * layers, item * grid.ny, item, item * plane});
}

/// Depth-major [term][component][k][i][j] seen as (terms, 6, nx, ny, layers).
inline Values tensors_array(Field field, const Grid& grid, py::ssize_t layers) {
  const auto plane = static_cast<py::ssize_t>(grid.surface_size());
  const auto terms = static_cast<py::ssize_t>(field.size()) / (6 * plane * layers);
  return own(
      std::move(field), {terms, py::ssize_t{6}, py::ssize_t{grid.nx}, py::ssize_t{grid.ny}, layers},
      {6 * item * plane * layers, item * plane * layers, item * grid.ny, item, item * plane});
}

}  // namespace samcontact::bindings
