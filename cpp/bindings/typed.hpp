// SPDX-License-Identifier: GPL-3.0-or-later
// Python objects with the types that signatures show, for the stubs of the module
// (scripts/stubs.py).
#pragma once

#include <pybind11/pybind11.h>

#include <utility>

namespace samcontact::bindings {

namespace py = pybind11;

/// A dictionary of parts by name.
struct Content : py::dict {
  using py::dict::dict;
};

/// Python object that has already been converted from a T.
template <class T>
struct Typed : py::object {
  explicit Typed(py::object value) : py::object(std::move(value)) {}
};

}  // namespace samcontact::bindings

namespace pybind11::detail {

template <>
struct handle_type_name<samcontact::bindings::Content> {
  static constexpr auto name = const_name("dict[str, typing.Any]");
};

template <class T>
struct handle_type_name<samcontact::bindings::Typed<T>> {
  static constexpr auto name = make_caster<T>::name;
};

}  // namespace pybind11::detail
