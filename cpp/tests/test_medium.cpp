// SPDX-License-Identifier: GPL-3.0-or-later
// Coefficients of a half-space against point forces, and contact on any linear operator.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "samcontact/contact/normal/polonsky_keer.hpp"
#include "samcontact/kernels/gauss.hpp"
#include "samcontact/operators/medium/half_space.hpp"
#include "samcontact/operators/surface/surface_influence.hpp"

using namespace samcontact;
using namespace samcontact::operators;

namespace {

constexpr double E = 210e9, nu = 0.3, G = E / (2 * (1 + nu)), pi = std::numbers::pi;

/// Displacement along x, y, z at (x, y) of the surface due to a unit force at the origin:
/// Boussinesq and Cerruti, Johnson (1985), sections 3.2 and 3.6.
std::array<double, 3> point_force(Traction traction, double x, double y) {
  const double r = std::hypot(x, y), near = 1 / (2 * pi * G * r), side = (0.5 - nu) * near / r;
  if (traction == Traction::pressure) return {-side * x, -side * y, (1 - nu) * near};
  if (traction == Traction::shear_y) {
    const auto [across, along, down] = point_force(Traction::shear_x, y, x);
    return {along, across, down};
  }
  return {near * (1 - nu + nu * x * x / (r * r)), near * nu * x * y / (r * r), side * x};
}

double by_quadrature(Traction traction, Axis axis, double x, double y, double dx, double dy) {
  static const auto nodes = kernels::gauss_legendre(40);
  double sum = 0.0;
  for (const auto& s : nodes) {
    for (const auto& t : nodes) {
      const auto u = point_force(traction, x - dx * (s.at - 0.5), y - dy * (t.at - 0.5));
      sum += s.weight * t.weight * u[static_cast<std::size_t>(axis)];
    }
  }
  return dx * dy * sum;
}

/// Independent springs: no cell displaces another.
class Springs : public NormalDisplacement {
 public:
  explicit Springs(Field compliance) : compliance_(std::move(compliance)) {}
  void apply(const double* pressure, double* displacement, ComplexField&) const override {
    for (std::size_t i = 0; i < compliance_.size(); ++i) {
      displacement[i] = compliance_[i] * pressure[i];
    }
  }
  double self_influence() const override { return compliance_[0]; }
  double cost() const override { return 1.0; }

 private:
  Field compliance_;
};

}  // namespace

TEST_CASE("the nine compliances of a half-space agree with point forces") {
  const auto steel = half_space({E, nu});
  const double dx = 2e-6, dy = 3e-6;
  const Grid grid(1, 1, dx, dy);
  const CellOffsets offsets{{1, 7, 2, 30}, {3, 1, 12}};
  const double scale =
      steel->compliance(Traction::pressure, Axis::z, grid, CellOffsets::lattice(1, 1))[0];
  for (const Traction traction : all_tractions) {
    for (const Axis axis : all_axes) {
      const Field table = steel->compliance(traction, axis, grid, offsets);
      std::size_t at = 0;
      for (const int j : offsets.y) {
        for (const int i : offsets.x) {
          const double exact = by_quadrature(traction, axis, i * dx, j * dy, dx, dy);
          CHECK(std::fabs(table[at++] - exact) < 1e-12 * scale);
        }
      }
    }
  }
}

TEST_CASE("nine cells displace their centre like one cell of three times their size") {
  const auto steel = half_space({E, nu});
  const double dx = 2e-6, dy = 3e-6;
  const Grid grid(1, 1, dx, dy);
  for (const Traction traction : all_tractions) {
    for (const Axis axis : all_axes) {
      const Field c = steel->compliance(traction, axis, grid, CellOffsets::lattice(2, 2));
      const double one = steel->compliance(traction, axis, Grid(1, 1, 3 * dx, 3 * dy),
                                           CellOffsets::lattice(1, 1))[0];
      const auto parity = compliance_parity(traction, axis);
      const double both_x = parity.odd_x ? 0 : 2, both_y = parity.odd_y ? 0 : 2;
      const double nine = c[0] + both_x * c[1] + both_y * c[2] + both_x * both_y * c[3];
      CHECK(std::fabs(nine - one) < 1e-13 * dx / G);
    }
  }
}

TEST_CASE("tables of square cells equal the values of single offsets") {
  const Grid square(4, 4, 1e-6, 1e-6, 3, 0.7e-6);
  const auto steel = half_space({E, nu});
  const CellOffsets offsets{{0, 1, 4, 9}, {0, 3, 5, 9, 12}};
  for (const auto& table : std::vector<std::function<Field(const CellOffsets&)>>{
           [&](const CellOffsets& at) {
             return steel->stress(Traction::pressure, square, at, 0.6e-6, Tensor::deviator);
           },
           [&](const CellOffsets& at) {
             return steel->stress(Traction::pressure, square, at, 0.6e-6, Tensor::full);
           },
           [&](const CellOffsets& at) {
             return steel->residual_displacement(Axis::z, square, at, 1);
           }}) {
    const Field together = table(offsets);
    const double scale = std::fabs(together[0]);
    const std::size_t nx = offsets.x.size(), ny = offsets.y.size();
    for (std::size_t n = 0; n < together.size(); ++n) {
      const std::size_t c = n / (nx * ny), j = n / nx % ny, i = n % nx;
      const Field alone = table({{offsets.x[i]}, {offsets.y[j]}});
      REQUIRE(std::fabs(together[n] - alone[c]) < 1e-13 * scale);
    }
  }
}

TEST_CASE("media are equal if their coefficients are equal") {
  const auto steel = half_space({E, nu}), rigid = half_space(Elastic::rigid());
  const Grid square(2, 2, 1.0, 1.0);
  CHECK(*steel == *half_space({E, nu}));
  CHECK(*steel != *half_space({E, 0.29}));
  CHECK(rigid->is_rigid());
  CHECK(rigid->compliance(Traction::shear_x, Axis::z, square, CellOffsets::lattice(2, 2)) ==
        Field(4, 0.0));
  SurfaceInfluence equal, unequal;
  for (const double shear : {-0.3, 0.3}) {
    equal.add(half_space({E, nu}), shear);
    unequal.add(half_space({shear < 0 ? E : 0.5 * E, nu}), shear);
  }
  CHECK(equal.rest(square, {square, 4, 4}).empty());
  CHECK(unequal.rest(square, {square, 4, 4}).size() == 1);
  // One table for both bodies gives the same sum as one table for each.
  const auto offsets = CellOffsets::lattice(3, 2);
  const Field both = unequal.elastic(square, offsets);
  const Field first = steel->compliance(Traction::pressure, Axis::z, square, offsets);
  const Field second =
      half_space({0.5 * E, nu})->compliance(Traction::pressure, Axis::z, square, offsets);
  for (std::size_t n = 0; n < both.size(); ++n) {
    CHECK(both[n] == doctest::Approx(first[n] + second[n]).epsilon(1e-14));
  }
  // u_z = 2 p/(E* q) of a Fourier mode.
  CHECK(steel->wave_compliance(3.0) == doctest::Approx(2 * (1 - nu * nu) / (E * 3.0)));
}

TEST_CASE("contact on independent springs has a pressure proportional to the penetration") {
  const Field gap{0.0, 1e-6, 2e-6, 5e-6}, compliance{1e-15, 2e-15, 1e-15, 3e-15};
  const double approach = 3e-6;
  const auto found = contact::polonsky_keer(
      Springs(compliance), gap,
      contact::RigidModes(contact::Drive::approach(approach), Grid(4, 1, 1.0, 1.0)), Field(4, 0.0),
      1e-12, 200);
  REQUIRE(found.converged);
  for (std::size_t i = 0; i < 4; ++i) {
    const double exact = std::fmax(approach - gap[i], 0.0) / compliance[i];
    CHECK(std::fabs(found.tractions.pressure[i] - exact) < 1e-10 * 3e9);
  }
}
