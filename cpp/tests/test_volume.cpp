// SPDX-License-Identifier: GPL-3.0-or-later
// Transforms of mirrored planes, operators on them, and boxes.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <tuple>
#include <vector>

#include "samcontact/base/box.hpp"
#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/operators/medium/half_space.hpp"
#include "samcontact/operators/medium/layered_half_space.hpp"
#include "samcontact/operators/volume/volume_operators.hpp"

using namespace samcontact;
using namespace samcontact::operators;

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

double number(std::size_t n) { return std::sin(1.7 * static_cast<double>(n) + 0.3); }

/// Strain with the mirror planes of `symmetry`, on the whole box [component][k][i][j].
Field symmetric_strain(const Grid& grid, Symmetry symmetry, Tensor tensor) {
  Field strain(count(tensor) * grid.volume_size());
  const auto places = components(tensor);
  for (int c = 0; c < count(tensor); ++c) {
    const auto parity = kernels::component_parity(places[c]);
    for (int k = 0; k < grid.nz; ++k) {
      for (int i = 0; i < grid.nx; ++i) {
        for (int j = 0; j < grid.ny; ++j) {
          int x = 2 * i - grid.nx + 1, y = 2 * j - grid.ny + 1;
          double sign = 1.0;
          if (symmetry != Symmetry::none && parity.odd_y) sign *= y > 0 ? 1 : (y < 0 ? -1 : 0);
          if (symmetry == Symmetry::xy && parity.odd_x) sign *= x > 0 ? 1 : (x < 0 ? -1 : 0);
          if (symmetry != Symmetry::none) y = std::abs(y);
          if (symmetry == Symmetry::xy) x = std::abs(x);
          const std::size_t at = ((c * 7 + k) * 101 + x + 50) * 103 + y + 50;
          strain[((static_cast<std::size_t>(c) * grid.nz + k) * grid.nx + i) * grid.ny + j] =
              1e-3 * sign * number(at);
        }
      }
    }
  }
  return strain;
}

/// Stored part of planes [n][i][j].
Field stored(const Field& whole, const Grid& grid, const VolumeTransform& transform) {
  const std::size_t planes = whole.size() / grid.surface_size();
  const int i0 = grid.nx - transform.nx(), j0 = grid.ny - transform.ny();
  Field part;
  for (std::size_t n = 0; n < planes; ++n) {
    for (int i = i0; i < grid.nx; ++i) {
      for (int j = j0; j < grid.ny; ++j) {
        part.push_back(whole[(n * grid.nx + i) * grid.ny + j]);
      }
    }
  }
  return part;
}

double largest_difference(const Field& a, const Field& b) {
  REQUIRE(a.size() == b.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::fabs(a[i] - b[i]));
  return largest;
}

}  // namespace

TEST_CASE("mirrored operators give the stored part of the whole result" *
          doctest::test_suite("accuracy")) {
  constexpr double E = 210e9;
  const SharedMedium steel = half_space({E, 0.3});
  for (const auto& [nx, ny] : {std::array{12, 9}, std::array{9, 12}}) {
    const Grid grid(nx, ny, 1.0, 1.3, 5, 0.8);
    for (const Tensor tensor : {Tensor::full, Tensor::deviator}) {
      const VolumeOperators whole(grid, steel,
                                  {tensor, Symmetry::none, ResidualMethod::fast, 1e-5});
      for (const Symmetry symmetry : {Symmetry::y, Symmetry::xy}) {
        const VolumeOperators part(grid, steel, {tensor, symmetry, ResidualMethod::fast, 1e-5});
        const Field strain = symmetric_strain(grid, symmetry, tensor);
        const Field half = stored(strain, grid, part.transform());

        // Pressure with both mirror planes, from a component that has them.
        Tractions tractions, traction_part;
        tractions.pressure.assign(strain.begin(), strain.begin() + grid.surface_size());
        traction_part.pressure = stored(tractions.pressure, grid, part.transform());
        // Shear with both mirror planes, from xz and yz.
        const auto plane_of = [&](int component) {
          const std::size_t place = component - (tensor == Tensor::deviator);
          const auto first = strain.begin() + place * grid.volume_size();
          return Field(first, first + grid.surface_size());
        };
        tractions.shear_x = plane_of(4);
        tractions.shear_y = plane_of(3);
        traction_part.shear_x = stored(tractions.shear_x, grid, part.transform());
        traction_part.shear_y = stored(tractions.shear_y, grid, part.transform());
        const Field expected =
            stored(whole.stress(strain.data(), &tractions, 1.0), grid, part.transform());
        const Field found = part.stress(half.data(), &traction_part, 1.0);
        // On the mirror plane the interpolated images of the whole are not exactly odd.
        CHECK(largest_difference(found, expected) < 1e-7 * E * 1e-3);

        const auto displacement = [](const VolumeOperators& operators, const Field& field,
                                     Axis axis) {
          VolumeSpectrum spectrum = operators.make_spectrum();
          forward(operators.transform(), field.data(), spectrum);
          Field u(operators.transform().plane_size());
          operators.residual_displacement(axis).apply(spectrum, u.data());
          return u;
        };
        for (const Axis axis : all_axes) {
          const Field u = stored(displacement(whole, strain, axis), grid, part.transform());
          CHECK(largest_difference(displacement(part, half, axis), u) < 1e-13);
        }
      }
    }
  }
}

TEST_CASE("kernels of a shallower box are taken over by a deeper one") {
  const SharedMedium steel = half_space({210e9, 0.3});
  const auto grid_of = [](int nz) { return Grid(11, 9, 1.0, 1.3, nz, 0.8); };
  const VolumeOptions options{Tensor::deviator, Symmetry::none, ResidualMethod::fast, 1e-5};
  const auto stress_and_displacement = [](const VolumeOperators& operators) {
    const Field strain = symmetric_strain(operators.grid(), Symmetry::none, operators.tensor());
    Tractions tractions;
    tractions.pressure.assign(strain.begin(), strain.begin() + operators.grid().surface_size());
    tractions.shear_x = tractions.pressure;
    Field found = operators.stress(strain.data(), &tractions, 1.0);
    VolumeSpectrum spectrum = operators.make_spectrum();
    forward(operators.transform(), strain.data(), spectrum);
    Field u(operators.transform().plane_size());
    operators.residual_displacement(Axis::z).apply(spectrum, u.data());
    found.insert(found.end(), u.begin(), u.end());
    return found;
  };
  const auto shallow = std::make_shared<const VolumeOperators>(grid_of(3), steel, options);
  stress_and_displacement(*shallow);
  const VolumeOperators deep(grid_of(7), steel, options, shallow);
  const VolumeOperators fresh(grid_of(7), steel, options);
  CHECK(stress_and_displacement(deep) == stress_and_displacement(fresh));
}

TEST_CASE("coefficients are computed only for layers with strain or with required stress") {
  const Grid grid(11, 9, 1.0, 1.0, 6, 0.8);
  const auto coated = medium_of(Stack{{{{300e9, 0.25}, 1.6}}, {210e9, 0.3}});
  for (const SharedMedium& medium : {half_space({210e9, 0.3}), coated}) {
    const VolumeOptions options{Tensor::deviator, Symmetry::none, ResidualMethod::fast, 1e-5};
    const VolumeOperators some(grid, medium, options), all(grid, medium, options);
    Field strain = symmetric_strain(grid, Symmetry::none, Tensor::deviator);
    const std::size_t plane = grid.surface_size();
    for (std::size_t n = 0; n < strain.size(); ++n) {
      const std::size_t k = n / plane % grid.nz;
      if (k != 2 && k != 4) strain[n] = 0;
    }
    const auto displacement = [&](const VolumeOperators& of) {
      VolumeSpectrum spectrum = of.make_spectrum();
      forward(of.transform(), strain.data(), spectrum);
      Field u(plane);
      of.residual_displacement(Axis::z).apply(spectrum, u.data());
      return u;
    };
    all.residual_displacement(Axis::z).build_all();
    CHECK(displacement(some) == displacement(all));
    CHECK(3 * some.bytes() == all.bytes());

    Tractions tractions;
    tractions.pressure.assign(strain.begin() + 2 * plane, strain.begin() + 3 * plane);
    const auto stress = [&](const VolumeOperators& of, int first) {
      VolumeSpectrum spectrum = of.make_spectrum();
      forward(of.transform(), strain.data(), spectrum);
      std::vector<Field> layers(grid.nz);
      of.for_each_layer(
          spectrum, strain.data(), &tractions, 1.0,
          [&](int k, const double* layer) { layers[k].assign(layer, layer + 5 * plane); }, grid.nz,
          {}, first);
      return layers;
    };
    const VolumeOperators lower(grid, medium, options), whole(grid, medium, options);
    const auto own = stress(lower, 2), expected = stress(whole, 0);
    for (int k = 0; k < grid.nz; ++k) CHECK(own[k] == (k < 2 ? Field{} : expected[k]));
    CHECK(lower.bytes() < whole.bytes());
  }
}

TEST_CASE("the effect of strain in a part of a box needs no coefficients beyond its reach") {
  const SharedMedium steel = half_space({210e9, 0.3});
  // With and without equal cell sides.
  for (const double dy : {1.0, 1.3}) {
    const Grid grid(14, 12, 1.0, dy, 3, 0.8);
    // The part is in the middle with mirrors.
    for (const auto& [symmetry, i0, j0] :
         {std::tuple{Symmetry::none, 2, 5}, std::tuple{Symmetry::y, 2, 4},
          std::tuple{Symmetry::xy, 5, 4}}) {
      constexpr int width = 4;
      const auto inside = [&, first = i0, left = j0](int i, int j) {
        return i >= first && i < first + width && j >= left && j < left + width;
      };
      Field strain = symmetric_strain(grid, symmetry, Tensor::full);
      for (std::size_t n = 0; n < strain.size(); ++n) {
        const int j = static_cast<int>(n % grid.ny), i = static_cast<int>(n / grid.ny % grid.nx);
        if (!inside(i, j)) strain[n] = 0.0;
      }
      VolumeOptions options{Tensor::full, symmetry, ResidualMethod::fast, 1e-5};
      const VolumeOperators all(grid, steel, options);
      options.reach = {std::max(i0 + width, grid.nx - i0), std::max(j0 + width, grid.ny - j0)};
      REQUIRE(options.reach.x < grid.nx);
      const VolumeOperators part(grid, steel, options);
      const VolumeTransform& transform = all.transform();
      const Field own = stored(strain, grid, transform);
      for (const Axis axis : all_axes) {
        const auto displacement = [&](const VolumeOperators& operators) {
          VolumeSpectrum spectrum = operators.make_spectrum();
          forward(transform, own.data(), spectrum);
          Field u(transform.plane_size());
          operators.residual_displacement(axis).apply(spectrum, u.data());
          return u;
        };
        CHECK(largest_difference(displacement(part), displacement(all)) < 1e-16);
      }

      Tractions tractions;
      tractions.pressure.assign(transform.plane_size(), 1e9);
      const Field expected = all.stress(own.data(), &tractions, 1.0);
      const int first = std::max(0, i0 - (grid.nx - transform.nx())),
                rows = i0 + width - (grid.nx - transform.nx()) - first;
      const fft::RowRun run{first, rows};
      VolumeSpectrum spectrum = part.make_spectrum();
      forward(transform, own.data(), spectrum);
      int layers = 0;
      part.for_each_layer(
          spectrum, own.data(), &tractions, 1.0,
          [&, left = j0](int k, const double* stress) {
            ++layers;
            const int skipped = grid.ny - transform.ny();
            for (int c = 0; c < 6; ++c) {
              for (int i = first; i < first + rows; ++i) {
                for (int j = std::max(0, left - skipped); j < left + width - skipped; ++j) {
                  const std::size_t at = static_cast<std::size_t>(i) * transform.ny() + j;
                  const double value = expected[(static_cast<std::size_t>(c) * grid.nz + k) *
                                                    transform.plane_size() +
                                                at];
                  CHECK(std::fabs(stress[c * transform.plane_size() + at] - value) < 1e-3);
                }
              }
            }
          },
          grid.nz, [&](int) { return std::span<const fft::RowRun>(&run, 1); });
      CHECK(layers == grid.nz);
    }
  }
}

TEST_CASE("a transform and its inverse reproduce the planes") {
  const int nx = 9, ny = 14;
  for (const Symmetry symmetry : {Symmetry::none, Symmetry::y, Symmetry::xy}) {
    const VolumeTransform transform(Grid(nx, ny, 1.0, 1.0), symmetry);
    const Grid grid(nx, ny, 1.0, 1.0, 3, 1.0);
    const Field start = stored(symmetric_strain(grid, symmetry, Tensor::full), grid, transform);
    VolumeSpectrum spectrum(transform, grid.nz, Tensor::full);
    forward(transform, start.data(), spectrum);
    Field back(start.size(), nan_value);
    inverse(transform, spectrum, back.data());
    for (double& value : back) value /= transform.mx() * transform.my();
    CHECK(largest_difference(back, start) < 1e-17);
  }
}

TEST_CASE("the five components of a deviator agree with all six") {
  const Grid grid(8, 7, 1.0, 1.0, 6, 1.0);
  constexpr double E = 210e9;
  const SharedMedium steel = half_space({E, 0.3});
  for (const ResidualMethod method : {ResidualMethod::exact, ResidualMethod::fast}) {
    const VolumeOperators five(grid, steel, {Tensor::deviator, Symmetry::none, method, 1e-3});
    const VolumeOperators six(grid, steel, {Tensor::full, Symmetry::none, method, 1e-3});
    const Field strain = symmetric_strain(grid, Symmetry::none, Tensor::deviator);
    const std::size_t n = grid.volume_size();
    Field full(6 * n);
    const auto places = components(Tensor::deviator);
    for (int c = 0; c < 5; ++c) {
      std::copy_n(strain.begin() + c * n, n, full.begin() + places[c] * n);
    }
    for (std::size_t i = 0; i < n; ++i) full[2 * n + i] = -full[i] - full[n + i];
    Tractions tractions;
    tractions.pressure.assign(strain.begin(), strain.begin() + grid.surface_size());
    Field all = six.stress(full.data(), &tractions, 1.0);
    for (std::size_t i = 0; i < n; ++i) {
      const double mean = (all[i] + all[n + i] + all[2 * n + i]) / 3;
      all[i] -= mean;
      all[n + i] -= mean;
    }
    Field expected(5 * n);
    for (int c = 0; c < 5; ++c) {
      std::copy_n(all.begin() + places[c] * n, n, expected.begin() + c * n);
    }
    const Field found = five.stress(strain.data(), &tractions, 1.0);
    CHECK(largest_difference(found, expected) < 1e-11 * E * 1e-3);
  }
}

TEST_CASE("boxes") {
  const Grid grid(10, 8, 1.0, 1.0, 6, 1.0);
  const Box a{2, 3, 2, 1, 2}, b{5, 1, 1, 3, 4};
  CHECK(a.united(b) == Box{2, 1, 4, 3, 4});
  CHECK(a.united(Box{}) == a);
  CHECK(a.united(b).contains(a));
  CHECK_FALSE(a.contains(b));
  Field values(a.volume_size());
  for (std::size_t n = 0; n < values.size(); ++n) values[n] = number(n);
  Field wide(grid.volume_size(), 0.0), back(values.size());
  insert(values.data(), a, wide.data(), Box::whole(grid));
  CHECK(wide[(1 * 10 + 3) * 8 + 3] == values[3]);
  extract(wide.data(), Box::whole(grid), back.data(), a);
  CHECK(back == values);
}

TEST_CASE("boxes below the surface") {
  const Grid grid(10, 8, 1.0, 1.0, 6, 1.0);
  const Box deep{2, 3, 2, 2, 5, 3};
  CHECK(deep.volume_size() == 8);
  CHECK(deep.united({5, 1, 1, 1, 0}) == Box{2, 1, 4, 4, 5, 3});  // wider, not deeper
  CHECK(deep.united({5, 1, 1, 1, 1}) == Box{2, 1, 4, 4, 5});
  CHECK(Box::whole(grid).contains(deep));
  CHECK_FALSE(deep.contains({2, 3, 2, 2, 5, 2}));
  CHECK(deep.intersected({2, 3, 2, 2, 3}).empty());
  Field values(deep.volume_size()), wide(grid.volume_size(), 0.0), back(deep.volume_size());
  for (std::size_t n = 0; n < values.size(); ++n) values[n] = number(n);
  copy_common(values.data(), deep, wide.data(), Box::whole(grid));
  CHECK(wide[(4 * 10 + 3) * 8 + 3] == values[6]);
  extract(wide.data(), Box::whole(grid), back.data(), deep);
  CHECK(back == values);
}

TEST_CASE("operators of a box below the surface equal those of the box from the surface") {
  constexpr int above = 5;
  const Elastic soft{1.0, 0.3}, stiff{4.0, 0.25};
  const Stack plain{{}, soft};
  // Interfaces above the box, at its first face, inside it, and at its last face.
  const Stack coated = Stack::of({{stiff, 1.5}, {soft, 1.0}, {stiff, 1.0}, {soft, 1.0}}, stiff);
  for (const Stack& stack : {plain, coated}) {
    for (const bool periodic : {false, true}) {
      const Box whole{0, 0, 10, 8, above + 4};
      Box deep = whole;
      deep.k0 = above;
      const Grid surface = Grid(10, 8, 1.0, 1.2).made_periodic(periodic, periodic);
      Grid grid(10, 8, 1.0, 1.2, whole.nz, 0.5);
      grid.period = surface.period;
      const auto medium = medium_of(stack);
      const VolumeOptions options{Tensor::full, Symmetry::none, ResidualMethod::fast, 1e-4, {}};
      const VolumeOperators all(whole.grid(grid), medium, options);
      const VolumeOperators part(deep.grid(grid), medium, options);
      Field strain(6 * deep.volume_size()), wide(6 * whole.volume_size(), 0.0);
      for (std::size_t n = 0; n < strain.size(); ++n) strain[n] = 1e-3 * number(n);
      for (int c = 0; c < 6; ++c) {
        insert(strain.data() + c * deep.volume_size(), deep, wide.data() + c * whole.volume_size(),
               whole);
      }
      Tractions tractions;
      tractions.pressure.resize(grid.surface_size());
      for (std::size_t n = 0; n < tractions.pressure.size(); ++n) {
        tractions.pressure[n] = 1e-3 * std::fabs(number(n));
      }
      const Field expected = all.stress(wide.data(), &tractions, 1.0);
      const Field found = part.stress(strain.data(), &tractions, 1.0);
      Field cut(found.size());
      for (int c = 0; c < 6; ++c) {
        extract(expected.data() + c * whole.volume_size(), whole,
                cut.data() + c * deep.volume_size(), deep);
      }
      // The images of a surface without period are interpolated over other coarse cells.
      CHECK(largest_difference(found, cut) < (periodic ? 1e-12 : 1e-4 * 1e-3) * stiff.E);
      CHECK(part.bytes() < all.bytes());
      const auto displacement = [](const VolumeOperators& operators, const Field& of) {
        VolumeSpectrum spectrum = operators.make_spectrum();
        forward(operators.transform(), of.data(), spectrum);
        Field out(operators.grid().surface_size());
        operators.residual_displacement(Axis::z).apply(spectrum, out.data());
        return out;
      };
      CHECK(largest_difference(displacement(part, strain), displacement(all, wide)) < 1e-15);
    }
  }
}
