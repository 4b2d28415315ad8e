// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include "arrays.hpp"
#include "rooms.hpp"
#include "samcontact/base/elastic.hpp"
#include "samcontact/kernels/corners.hpp"
#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/kernels/surface_traction.hpp"

namespace samcontact::bindings {

namespace {

namespace k = samcontact::kernels;
constexpr double pi = std::numbers::pi;

/// out[n][point] = f(point)[n] for flat arrays of points.
template <std::size_t N, class F>
py::array evaluate(const Array& X, const F& f) {
  const py::ssize_t points = X.size();
  py::array_t<double> out({static_cast<py::ssize_t>(N), points});
  double* to = out.mutable_data();
  for (py::ssize_t i = 0; i < points; ++i) {
    const auto values = f(i);
    for (std::size_t n = 0; n < N; ++n) to[n * points + i] = values[n];
  }
  return out;
}

}  // namespace

// Flat arrays of equal length in, (N, points) out; lengths are scaled by the source's width so that
// logarithms of lengths cost no digits.
void bind_kernels(py::module_& parent) {
  auto m = parent.def_submodule("kernels");
  m.def(
      "pressure_displacement",
      [](const Array& X, const Array& Y, double a, double b, double E, double nu) {
        const double unit = 2 * a;
        const double factor = Elastic{E, nu}.normal_compliance() / pi * unit;
        return evaluate<1>(X, [&](py::ssize_t i) {
          auto sum = k::corner_sum_2d<1>(
              X.data()[i] / unit, Y.data()[i] / unit, a / unit, b / unit,
              [](double x, double y) { return std::array{k::pressure_displacement(x, y)}; });
          sum[0] *= factor;
          return sum;
        });
      },
      py::arg("X"), py::arg("Y"), py::arg("a"), py::arg("b"), py::arg("E"), py::arg("nu"));
  m.def(
      "shear_displacement",
      [](const Array& X, const Array& Y, double a, double b, double E, double nu) {
        const double unit = 2 * a;
        const double factor = Elastic{E, nu}.coupling_compliance() / (2 * pi) * unit;
        return evaluate<1>(X, [&](py::ssize_t i) {
          auto sum = k::corner_sum_2d<1>(
              X.data()[i] / unit, Y.data()[i] / unit, a / unit, b / unit,
              [](double x, double y) { return std::array{k::shear_displacement(x, y)}; });
          sum[0] *= factor;
          return sum;
        });
      },
      py::arg("X"), py::arg("Y"), py::arg("a"), py::arg("b"), py::arg("E"), py::arg("nu"));
  const auto bind_stress = [&](const char* name, auto corner) {
    m.def(
        name,
        [corner](const Array& X, const Array& Y, const Array& z, double a, double b, double nu) {
          const double unit = 2 * a;
          return evaluate<6>(X, [&](py::ssize_t i) {
            auto sum = k::corner_sum_2d<6>(
                X.data()[i] / unit, Y.data()[i] / unit, a / unit, b / unit,
                [&](double x, double y) { return corner(x, y, z.data()[i] / unit, nu); });
            for (double& v : sum) v /= 2 * pi;
            return sum;
          });
        },
        py::arg("X"), py::arg("Y"), py::arg("z"), py::arg("a"), py::arg("b"), py::arg("nu"));
  };
  bind_stress("pressure_stress", k::pressure_stress);
  bind_stress("shear_stress", k::shear_stress);
  m.def(
      "eigenstrain_displacement",
      [](const Array& X, const Array& Y, double zc, double a, double b, double c, double nu) {
        const double unit = 2 * a;
        return evaluate<6>(X, [&](py::ssize_t i) {
          auto sum =
              k::corner_sum_3d<6>(X.data()[i] / unit, Y.data()[i] / unit, zc / unit, a / unit,
                                  b / unit, c / unit, [&](double x, double y, double z) {
                                    return k::eigenstrain_displacement(x, y, z, nu);
                                  });
          for (double& v : sum) v *= unit / (2 * pi);
          return sum;
        });
      },
      py::arg("X"), py::arg("Y"), py::arg("zc"), py::arg("a"), py::arg("b"), py::arg("c"),
      py::arg("nu"));
  m.def(
      "eigenstrain_stress",
      [](const Array& X, const Array& Y, const Array& z, double zc, double a, double b, double c,
         double E, double nu) {
        return evaluate<36>(X, [&](py::ssize_t i) {
          const auto stress =
              k::eigenstrain_stress(X.data()[i], Y.data()[i], z.data()[i], zc, a, b, c, E, nu);
          std::array<double, 36> flat;
          for (int n = 0; n < 36; ++n) flat[n] = stress[n / 6][n % 6];
          return flat;
        });
      },
      py::arg("X"), py::arg("Y"), py::arg("z"), py::arg("zc"), py::arg("a"), py::arg("b"),
      py::arg("c"), py::arg("E"), py::arg("nu"));
}

}  // namespace samcontact::bindings
