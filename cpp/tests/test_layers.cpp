// SPDX-License-Identifier: GPL-3.0-or-later
// Layers on a substrate, against Hankel integrals of their Fourier modes and homogeneous
// half-spaces.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "samcontact/kernels/gauss.hpp"
#include "samcontact/kernels/layered_wave.hpp"
#include "samcontact/operators/medium/half_space.hpp"
#include "samcontact/operators/medium/layered_half_space.hpp"
#include "samcontact/operators/medium/layered_influence.hpp"
#include "samcontact/operators/residual/layer_residual_stress.hpp"

using namespace samcontact;
using namespace samcontact::operators;

namespace {

constexpr double pi = std::numbers::pi;
constexpr Elastic soft{1.0, 0.3}, stiff{4.0, 0.25};

double largest(const Field& field) {
  double found = 0.0;
  for (const double v : field) found = std::max(found, std::fabs(v));
  return found;
}

double difference(const Field& a, const Field& b) {
  double found = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n) found = std::max(found, std::fabs(a[n] - b[n]));
  return found;
}

/// Nodes from 0 to `end`, in panels that grow from a small one at 0 [1/m].
std::vector<kernels::QuadratureNode> wavenumbers(double end, double first, double widest) {
  std::vector<kernels::QuadratureNode> nodes;
  for (double at = 0.0, step = first; at < end; at += step, step = std::min(1.4 * step, widest)) {
    for (const auto& node : kernels::gauss_legendre(10)) {
      nodes.push_back({at + node.at * step, node.weight * step});
    }
  }
  return nodes;
}

/// u_z due to a unit force at a distance on the surface, less that of a homogeneous body of the top
/// layer: due to pressure, and due to shear towards the point.
std::array<double, 2> rest_of_force(const Stack& stack, double r,
                                    const std::vector<kernels::QuadratureNode>& nodes) {
  const auto near = kernels::wave_compliance(stack.elastic(0));
  kernels::LayeredWave wave(stack);
  std::array<double, 2> u{};
  for (const auto& [q, weight] : nodes) {
    wave.set_wavenumber(q);
    const auto own = wave.compliance();
    u[0] += weight / (2 * pi) * (own.down - near.down) * std::cyl_bessel_j(0, q * r);
    u[1] += weight / (2 * pi) * (own.coupling - near.coupling) * std::cyl_bessel_j(1, q * r);
  }
  return u;
}

/// Numbers in [-1, 1], of a deviator if requested.
Field random_strain(std::size_t size, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  Field strain(size);
  for (double& value : strain) value = number(generator);
  return strain;
}

Field residual_of(const ResidualStress& operation, const VolumeTransform& transform,
                  const Grid& grid, Tensor tensor, const Field& strain) {
  VolumeSpectrum spectrum(transform, grid.nz, tensor);
  forward(transform, strain.data(), spectrum);
  operation.apply(spectrum);
  Field stress(strain.size());
  inverse(transform, spectrum, stress.data());
  return stress;
}

}  // namespace

TEST_CASE("coefficients of layers agree with Hankel integrals") {
  const Stack stack = Stack::of({{stiff, 1.5}, {soft, 0.5}}, {2.0, 0.4});
  const Grid grid(1, 1, 1.0, 1.0);
  const CellOffsets offsets{{0, 4, 1}, {2, 0}};
  const Field down = layered_compliance(stack, Traction::pressure, Axis::z, grid, offsets);
  const Field side = layered_compliance(stack, Traction::shear_x, Axis::z, grid, offsets);
  const auto nodes = wavenumbers(20.0, 0.01, 0.7);
  const auto points = kernels::gauss_legendre(6);
  const double scale = largest(down);
  std::size_t at = 0;
  for (const int j : offsets.y) {
    for (const int i : offsets.x) {
      const CellOffsets one{{i}, {j}};
      double pressed = cell_compliance(stiff, Traction::pressure, Axis::z, grid, one)[0];
      double sheared = cell_compliance(stiff, Traction::shear_x, Axis::z, grid, one)[0];
      for (const auto& s : points) {
        for (const auto& t : points) {
          const double x = i + s.at - 0.5, y = j + t.at - 0.5, r = std::hypot(x, y);
          const auto [u, v] = rest_of_force(stack, r, nodes);
          pressed += s.weight * t.weight * u;
          sheared += s.weight * t.weight * v * x / r;
        }
      }
      CHECK(std::fabs(down[at] - pressed) < 1e-7 * scale);
      CHECK(std::fabs(side[at] - sheared) < 1e-7 * scale);
      ++at;
    }
  }
}

TEST_CASE("layers of identical material are a half-space") {
  const Stack uniform = Stack::of({{stiff, 0.3}, {stiff, 2.0}}, stiff);
  CHECK(*medium_of(uniform) == *half_space(stiff));
  const auto steel = half_space(stiff);
  const Grid grid(1, 1, 1.0, 0.7, 4, 0.25);
  const auto offsets = CellOffsets::lattice(9, 7);
  for (const Traction traction : all_tractions) {
    for (const Axis axis : all_axes) {
      const Field exact = steel->compliance(traction, axis, grid, offsets);
      const double scale = largest(steel->compliance(traction, axis, grid, offsets));
      CHECK(difference(layered_compliance(uniform, traction, axis, grid, offsets), exact) <
            1e-12 * scale);
    }
    for (const double z : {0.0, 0.1, 0.3, 1.0, 5.0}) {
      const Field exact = steel->stress(traction, grid, offsets, z, Tensor::deviator);
      CHECK(difference(layered_stress(uniform, traction, grid, offsets, z, Tensor::deviator),
                       exact) < 1e-11);
    }
  }
}

TEST_CASE("the stress in layers satisfies equilibrium, bonding and the surface load") {
  const Stack stack = Stack::of({{stiff, 0.6}, {soft, 1.1}}, {10.0, 0.1});
  const Grid grid(1, 1, 1.0, 0.8);
  const auto offsets = CellOffsets::lattice(5, 4);
  const std::size_t plane = 20;
  for (const Traction traction : all_tractions) {
    const int own = traction == Traction::pressure ? 2 : traction == Traction::shear_x ? 4 : 3;
    const Field top = layered_stress(stack, traction, grid, offsets, 0.0, Tensor::full);
    for (const int c : {2, 3, 4}) {
      for (std::size_t n = 0; n < plane; ++n) {
        const double exact = c == own && n == 0 ? -1.0 : 0.0;
        CHECK(std::fabs(top[c * plane + n] - exact) < 1e-9);
      }
    }
    for (const double z : {0.6, stack.thickness()}) {
      const Field below = layered_stress(stack, traction, grid, offsets, z, Tensor::full);
      const Field above =
          layered_stress(stack, traction, grid, offsets, std::nextafter(z, 0.0), Tensor::full);
      for (std::size_t n = 0; n < 6 * plane; ++n) {
        const auto c = n / plane;
        if (c >= 2 && c <= 4) CHECK(std::fabs(above[n] - below[n]) < 1e-8);
      }
      CHECK(difference(above, below) > 1e-2);
    }
    if (traction != Traction::pressure) continue;
    // The force on a plane equals that on the surface.
    const auto wide = CellOffsets::lattice(60, 75);
    const Field deep = layered_stress(stack, traction, grid, wide, 0.9, Tensor::full);
    double total = 0.0;
    for (std::size_t n = 0; n < 60 * 75; ++n) {
      const double multiplicity = (n % 60 > 0 ? 2 : 1) * (n >= 60 ? 2 : 1);
      total += multiplicity * deep[own * 60 * 75 + n];
    }
    CHECK(total == doctest::Approx(-1.0).epsilon(1e-4));
  }
}

TEST_CASE("the stress of eigenstrain in layers of identical material is that of a half-space") {
  for (const double dz : {0.4, 1e-5}) {
    const Grid grid(10, 8, 1.0, 1.3, 7, dz);
    // Interfaces between cells, and below them.
    const Stack uniform = Stack::of({{stiff, 2 * dz}, {stiff, dz}, {stiff, 9 * dz}}, stiff);
    for (const Symmetry symmetry : {Symmetry::none, Symmetry::y, Symmetry::xy}) {
      for (const Tensor tensor : {Tensor::full, Tensor::deviator}) {
        const VolumeTransform transform(grid, symmetry);
        const Field strain = random_strain(count(tensor) * grid.nz * transform.plane_size(),
                                           3 + static_cast<unsigned>(symmetry));
        const ResidualSettings settings{.method = ResidualMethod::fast};
        const LayerResidualStress plain(grid, transform, {{}, stiff}, settings);
        const LayerResidualStress layered(grid, transform, uniform, settings);
        const Field exact = residual_of(plain, transform, grid, tensor, strain);
        const Field found = residual_of(layered, transform, grid, tensor, strain);
        CHECK(difference(found, exact) < 1e-12 * largest(exact));
      }
    }
  }
}

TEST_CASE("a spectrum of fewer layers gives the stress of one padded with zeros") {
  const Grid grid(6, 5, 1.0, 1.0, 7, 0.5), shallow(6, 5, 1.0, 1.0, 4, 0.5);
  const VolumeTransform transform(grid, Symmetry::none);
  const std::size_t plane = transform.plane_size();
  const Field few = random_strain(6 * shallow.nz * plane, 7);
  Field all(6 * grid.nz * plane, 0.0);
  for (int c = 0; c < 6; ++c) {
    std::copy_n(&few[c * shallow.nz * plane], shallow.nz * plane, &all[c * grid.nz * plane]);
  }
  for (const Stack& body : {Stack{{}, stiff}, Stack::of({{soft, 1.0}, {stiff, 2.0}}, soft)}) {
    const LayerResidualStress operation(grid, transform, body, {.method = ResidualMethod::fast});
    const Field exact = residual_of(operation, transform, grid, Tensor::full, all);
    const Field found = residual_of(operation, transform, shallow, Tensor::full, few);
    for (int c = 0; c < 6; ++c) {
      for (std::size_t n = 0; n < shallow.nz * plane; ++n) {
        CHECK(std::fabs(found[c * shallow.nz * plane + n] - exact[c * grid.nz * plane + n]) <
              1e-13 * largest(exact));
      }
    }
  }
}

TEST_CASE(
    "the eigenstrain operator of layers is symmetric and dissipative, and has the right limits") {
  const Grid grid(6, 6, 1.0, 1.0, 6, 0.5);
  const VolumeTransform transform(grid, Symmetry::none);
  const ResidualSettings settings{.method = ResidualMethod::fast};
  const auto stress_of = [&](const Stack& stack, const Field& strain) {
    return residual_of(LayerResidualStress(grid, transform, stack, settings), transform, grid,
                       Tensor::full, strain);
  };
  const auto work = [&](const Field& strain, const Field& stress) {
    double sum = 0.0;
    const std::size_t component = grid.nz * transform.plane_size();
    for (std::size_t n = 0; n < strain.size(); ++n) {
      sum += (n < 3 * component ? 1 : 2) * strain[n] * stress[n];
    }
    return sum;
  };
  const Field one = random_strain(6 * grid.nz * transform.plane_size(), 1);
  const Field two = random_strain(one.size(), 2);
  for (const Stack& stack : {Stack::of({{stiff, 1.0}, {soft, 0.5}}, {9.0, 0.1}),
                             Stack::of({{soft, 1.5}, {stiff, 4.0}}, Elastic::rigid())}) {
    const Field s1 = stress_of(stack, one), s2 = stress_of(stack, two);
    const double scale = work(one, s1);
    CHECK(scale < 0);
    CHECK(work(one, s2) == doctest::Approx(work(two, s1)).epsilon(1e-11));
  }
  // Under a coating of negligible stiffness the substrate is a half-space of its own.
  const Stack bare = Stack::of({{{1e-9, 0.3}, 1.0}}, stiff);
  Field below = one;
  const std::size_t plane = transform.plane_size();
  for (std::size_t n = 0; n < one.size(); ++n) {
    if (n / plane % grid.nz < 2) below[n] = 0.0;
  }
  const Grid rest(6, 6, 1.0, 1.0, 4, 0.5);
  Field moved(6 * rest.nz * plane);
  for (int c = 0; c < 6; ++c) {
    for (std::size_t n = 0; n < rest.nz * plane; ++n) {
      moved[c * rest.nz * plane + n] = below[(c * grid.nz + 2) * plane + n];
    }
  }
  const Field found = stress_of(bare, below);
  const Field exact = residual_of(LayerResidualStress(rest, transform, {{}, stiff}, settings),
                                  transform, rest, Tensor::full, moved);
  double worst = 0.0;
  for (int c = 0; c < 6; ++c) {
    for (std::size_t n = 0; n < rest.nz * plane; ++n) {
      worst = std::max(
          worst, std::fabs(found[(c * grid.nz + 2) * plane + n] - exact[c * rest.nz * plane + n]));
    }
  }
  CHECK(worst < 1e-7 * largest(exact));
  CHECK_THROWS_WITH_AS(
      LayerResidualStress(grid, transform, Stack::of({{stiff, 0.7}}, soft), settings),
      doctest::Contains("bottom of layers[0]"), std::invalid_argument);
  CHECK_THROWS_WITH_AS(
      LayerResidualStress(grid, transform, Stack::of({{stiff, 1.0}}, Elastic::rigid()), settings),
      doctest::Contains("above the rigid substrate"), std::invalid_argument);
}

TEST_CASE("images of layers are within the tolerance for one strain in a small and a wide box" *
          doctest::test_suite("accuracy")) {
  const int n = 14, wide = 5 * n, from = (wide - n) / 2, nz = 9;
  const Grid small(n, n, 1.0, 1.0, nz, 0.5), large(wide, wide, 1.0, 1.0, nz, 0.5);
  const VolumeTransform here(small, Symmetry::none), there(large, Symmetry::none);
  const auto box_of = [&](const Grid& grid) { return grid.volume_size(); };
  // Smooth, so that only images differ.
  Field strain(6 * box_of(small)), embedded(6 * box_of(large), 0.0);
  const Field amplitude = random_strain(6, 5);
  const auto at = [&](const Grid& grid, int c, int k, int i, int j) {
    return ((static_cast<std::size_t>(c) * nz + k) * grid.nx + i) * grid.ny + j;
  };
  const auto off = [](int i, int count) { return (2.0 * i + 1) / count - 1; };
  for (int c = 0; c < 6; ++c) {
    for (int k = 0; k < nz; ++k) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const double x = off(i, n), y = off(j, n), z = off(k, nz);
          const double inside = std::max(1 - x * x - y * y - z * z, 0.0);
          strain[at(small, c, k, i, j)] = amplitude[c] * std::pow(inside, 4);
          embedded[at(large, c, k, from + i, from + j)] = strain[at(small, c, k, i, j)];
        }
      }
    }
  }
  const auto stress_of = [&](const Grid& grid, const VolumeTransform& transform, const Stack& body,
                             const Field& given, double tol) {
    const LayerResidualStress operation(grid, transform, body,
                                        {.method = ResidualMethod::fast, .image_tol = tol});
    Field stress = residual_of(operation, transform, grid, Tensor::full, given);
    const Field far = operation.far_field(Tensor::full, given.data());
    const std::size_t plane = transform.plane_size();
    Field layer(6 * plane);
    for (int k = 0; k < nz; ++k) {
      for (int c = 0; c < 6; ++c)
        std::copy_n(&stress[(c * nz + k) * plane], plane, &layer[c * plane]);
      operation.correct(Tensor::full, far, k, layer.data());
      for (int c = 0; c < 6; ++c)
        std::copy_n(&layer[c * plane], plane, &stress[(c * nz + k) * plane]);
    }
    return stress;
  };
  for (const Stack& body :
       {Stack{{}, stiff}, Stack::of({{soft, 1.0}}, stiff),
        Stack::of({{{0.02, 0.3}, 3.0}}, {1.0, 0.3}), Stack::of({{{50.0, 0.2}, 1.0}}, soft),
        Stack::of({{stiff, 0.5}, {{0.1, 0.45}, 0.5}}, stiff),
        Stack::of({{soft, 1.0}, {stiff, 9.0}}, Elastic::rigid()),
        Stack::of({{soft, 9.0}}, stiff)}) {
    const Field exact = stress_of(large, there, body, embedded, 1e-4);
    for (const double tol : {1e-2, 1e-3, 1e-5}) {
      const Field found = stress_of(small, here, body, strain, tol);
      double worst = 0.0;
      for (int c = 0; c < 6; ++c) {
        for (int k = 0; k < nz; ++k) {
          for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n; ++j) {
              worst = std::max(worst, std::fabs(found[at(small, c, k, i, j)] -
                                                exact[at(large, c, k, from + i, from + j)]));
            }
          }
        }
      }
      CHECK(worst < tol * largest(exact));
    }
  }
}
