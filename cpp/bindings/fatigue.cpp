// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "arrays.hpp"
#include "long_work.hpp"
#include "rooms.hpp"
#include "samcontact/fatigue/critical_plane.hpp"
#include "samcontact/fatigue/deviators.hpp"

namespace samcontact::bindings {
namespace {

namespace f = samcontact::fatigue;

/// Paths of an array (moments, 6, cells), whose shape the Python layer has checked.
f::Paths to_paths(const Array& stress) {
  return {stress.data(), static_cast<std::size_t>(stress.shape(0)),
          static_cast<std::size_t>(stress.shape(2))};
}

Values flat(Field field) {
  const auto size = static_cast<py::ssize_t>(field.size());
  return own(std::move(field), {size}, {item});
}

template <class Criterion>
auto field_of(const Criterion& criterion) {
  return [criterion](const Array& stress, double slope) {
    const f::Paths paths = to_paths(stress);
    Field field;
    {
      const LongWork work;
      field = criterion(paths, slope);
    }
    return flat(std::move(field));
  };
}

template <class Criterion>
std::pair<Values, Values> plane_of(const Criterion& criterion) {
  f::CriticalPlane found;
  {
    const LongWork work;
    found = criterion();
  }
  const auto cells = static_cast<py::ssize_t>(found.value.size());
  Values normal = own(std::move(found.normal), {py::ssize_t{3}, cells}, {item * cells, item});
  return {flat(std::move(found.value)), std::move(normal)};
}

}  // namespace

void bind_fatigue(py::module_& parent) {
  py::module_ m = parent.def_submodule("fatigue");
  m.def("dang_van", field_of(&f::dang_van), py::arg("stress"), py::arg("slope"));
  m.def("crossland", field_of(&f::crossland), py::arg("stress"), py::arg("slope"));
  m.def(
      "findley",
      [](const Array& stress, double k) {
        const f::Paths paths = to_paths(stress);
        return plane_of([&] { return f::findley(paths, k); });
      },
      py::arg("stress"), py::arg("k"));
  m.def(
      "fatemi_socie",
      [](const Array& shear, const Array& stress, double k) {
        const f::Paths strained = to_paths(shear), stressed = to_paths(stress);
        return plane_of([&] { return f::fatemi_socie(strained, stressed, k); });
      },
      py::arg("shear"), py::arg("stress"), py::arg("k"));
}

}  // namespace samcontact::bindings
