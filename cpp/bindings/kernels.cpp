// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <numbers>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "long_work.hpp"
#include "rooms.hpp"
#include "samcontact/kernels/corners.hpp"
#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/kernels/heat_displacement.hpp"
#include "samcontact/kernels/heat_steady.hpp"
#include "samcontact/kernels/heat_stress.hpp"
#include "samcontact/kernels/heat_temperature.hpp"
#include "samcontact/operators/periodic/cell_influence.hpp"

namespace samcontact::bindings {

namespace {

namespace k = samcontact::kernels;
constexpr double pi = std::numbers::pi;

/// out[n][point] = f(point)[n] for flat arrays of points.
template <std::size_t N, class F>
Values evaluate(const Array& X, const F& f) {
  const py::ssize_t points = X.size();
  py::array_t<double> out({static_cast<py::ssize_t>(N), points});
  double* to = out.mutable_data();
  for (py::ssize_t i = 0; i < points; ++i) {
    const auto values = f(i);
    for (std::size_t n = 0; n < N; ++n) to[n * points + i] = values[n];
  }
  return out;
}

/// Table of a heat source in units of its width 2 a; `table(source, points, unit)`.
template <class Table>
Values heat_table(const Array& x, const Array& y, double a, double b, double heated,
                  std::pair<double, double> speed, int components, double scale,
                  const Table& table) {
  const double unit = 2 * a;
  const auto scaled = [unit](const Array& array) {
    std::vector<double> values(array.data(), array.data() + array.size());
    for (double& v : values) v /= unit;
    return values;
  };
  const k::HeatSource source{0.5, b / unit, heated / (unit * unit), speed.first * unit,
                             speed.second * unit};
  const k::HeatPoints points{scaled(x), scaled(y)};
  Field values;
  {
    const LongWork work;
    values = table(source, points, unit);
    for (double& v : values) v *= scale;
  }
  const py::ssize_t nx = x.size(), ny = y.size();
  return own(std::move(values), {py::ssize_t{components}, nx, ny},
             {item * nx * ny, item * ny, item});
}

void bind_steady_heat(py::module_& m) {
  m.def(
      "steady_heat_temperature",
      [](const Array& X, const Array& Y, const Array& z, double a, double b) {
        const double unit = 2 * a;
        return evaluate<1>(X, [&](py::ssize_t i) {
          return std::array{unit *
                            k::steady_heat_temperature(X.data()[i] / unit, Y.data()[i] / unit,
                                                       z.data()[i] / unit, a / unit, b / unit)};
        });
      },
      py::arg("X"), py::arg("Y"), py::arg("z"), py::arg("a"), py::arg("b"));
  m.def(
      "steady_heat_stress",
      [](const Array& X, const Array& Y, const Array& z, double a, double b) {
        const double unit = 2 * a;
        return evaluate<3>(X, [&](py::ssize_t i) {
          auto s = k::steady_heat_stress(X.data()[i] / unit, Y.data()[i] / unit, z.data()[i] / unit,
                                         a / unit, b / unit);
          for (double& v : s) v *= unit;
          return s;
        });
      },
      py::arg("X"), py::arg("Y"), py::arg("z"), py::arg("a"), py::arg("b"));
  m.def(
      "steady_heat_displacement",
      [](const Array& X, const Array& Y, double a, double b, double r0) {
        const double unit = 2 * a;
        return evaluate<1>(X, [&](py::ssize_t i) {
          return std::array{unit * unit *
                            k::steady_heat_displacement(X.data()[i] / unit, Y.data()[i] / unit,
                                                        a / unit, b / unit, r0 / unit)};
        });
      },
      py::arg("X"), py::arg("Y"), py::arg("a"), py::arg("b"), py::arg("r0"));
}

void bind_heat(py::module_& m) {
  m.def(
      "heat_temperature",
      [](const Array& x, const Array& y, double z, double a, double b, double heated,
         std::pair<double, double> speed, double tol) {
        return heat_table(x, y, a, b, heated, speed, 1, 2 * a,
                          [&](const auto& source, const auto& points, double unit) {
                            return k::heat_temperature(source, points, z / unit, tol);
                          });
      },
      py::arg("x"), py::arg("y"), py::arg("z"), py::arg("a"), py::arg("b"), py::arg("heated"),
      py::arg("speed"), py::arg("tol"));
  m.def(
      "heat_displacement",
      [](const Array& x, const Array& y, double a, double b, double heated,
         std::pair<double, double> speed, double tol) {
        return heat_table(x, y, a, b, heated, speed, 1, 4 * a * a,
                          [&](const auto& source, const auto& points, double) {
                            return k::heat_displacement(source, points, tol);
                          });
      },
      py::arg("x"), py::arg("y"), py::arg("a"), py::arg("b"), py::arg("heated"), py::arg("speed"),
      py::arg("tol"));
  m.def(
      "heat_stress",
      [](const Array& x, const Array& y, double z, double a, double b, double nu, double heated,
         std::pair<double, double> speed, double tol) {
        return heat_table(x, y, a, b, heated, speed, 6, 2 * a,
                          [&](const auto& source, const auto& points, double unit) {
                            return k::heat_stress(source, points, z / unit, nu, tol);
                          });
      },
      py::arg("x"), py::arg("y"), py::arg("z"), py::arg("a"), py::arg("b"), py::arg("nu"),
      py::arg("heated"), py::arg("speed"), py::arg("tol"));
}

/// Axes and tractions are 0, 1, 2 along x, y, z; the traction along z is the pressure.
operators::Axis axis_of(int axis) { return static_cast<operators::Axis>(axis); }

void bind_tractions(py::module_& m) {
  m.def(
      "traction_displacement",
      [](int traction, int axis, const Array& X, const Array& Y, double a, double b, double E,
         double nu) {
        const double unit = 2 * a;
        const auto load = operators::traction_along(axis_of(traction));
        const double factor =
            operators::compliance_factor({E, nu}, load, axis_of(axis)) / pi * unit;
        return evaluate<1>(X, [&](py::ssize_t i) {
          auto sum = k::corner_sum_2d<1>(
              X.data()[i] / unit, Y.data()[i] / unit, a / unit, b / unit, [&](double x, double y) {
                return std::array{operators::compliance_corner(load, axis_of(axis), x, y, nu)};
              });
          sum[0] *= factor;
          return sum;
        });
      },
      py::arg("traction"), py::arg("axis"), py::arg("X"), py::arg("Y"), py::arg("a"), py::arg("b"),
      py::arg("E"), py::arg("nu"));
  m.def(
      "traction_stress",
      [](int traction, const Array& X, const Array& Y, const Array& z, double a, double b,
         double nu) {
        const double unit = 2 * a;
        const auto load = operators::traction_along(axis_of(traction));
        return evaluate<6>(X, [&](py::ssize_t i) {
          auto sum = k::corner_sum_2d<6>(
              X.data()[i] / unit, Y.data()[i] / unit, a / unit, b / unit, [&](double x, double y) {
                return operators::stress_corner(load, x, y, z.data()[i] / unit, nu);
              });
          for (double& v : sum) v /= 2 * pi;
          return sum;
        });
      },
      py::arg("traction"), py::arg("X"), py::arg("Y"), py::arg("z"), py::arg("a"), py::arg("b"),
      py::arg("nu"));
}

void bind_eigenstrain(py::module_& m) {
  m.def(
      "eigenstrain_displacement",
      [](int axis, const Array& X, const Array& Y, double zc, double a, double b, double c,
         double nu) {
        const double unit = 2 * a;
        return evaluate<6>(X, [&](py::ssize_t i) {
          auto sum =
              k::corner_sum_3d<6>(X.data()[i] / unit, Y.data()[i] / unit, zc / unit, a / unit,
                                  b / unit, c / unit, [&](double x, double y, double z) {
                                    return operators::residual_corner(axis_of(axis), x, y, z, nu);
                                  });
          for (double& v : sum) v *= unit / (2 * pi);
          return sum;
        });
      },
      py::arg("axis"), py::arg("X"), py::arg("Y"), py::arg("zc"), py::arg("a"), py::arg("b"),
      py::arg("c"), py::arg("nu"));
  m.def(
      "eigenstrain_stress",
      [](const Array& X, const Array& Y, const Array& z, double zc, double a, double b, double c,
         double E, double nu) {
        return evaluate<36>(X, [&](py::ssize_t i) {
          const auto stress =
              k::eigenstrain_stress(X.data()[i], Y.data()[i], z.data()[i], zc, a, b, c, E, nu);
          std::array<double, 36> flat{};
          for (int n = 0; n < 36; ++n) flat[n] = stress[n / 6][n % 6];
          return flat;
        });
      },
      py::arg("X"), py::arg("Y"), py::arg("z"), py::arg("zc"), py::arg("a"), py::arg("b"),
      py::arg("c"), py::arg("E"), py::arg("nu"));
}

}  // namespace

// Arguments: flat arrays of equal length; results: (N, points). Lengths are scaled by the width of
// the source so that logarithms of lengths cost no digits.
void bind_kernels(py::module_& parent) {
  auto m = parent.def_submodule("kernels");
  bind_tractions(m);
  bind_eigenstrain(m);
  bind_steady_heat(m);
  bind_heat(m);
}

}  // namespace samcontact::bindings
