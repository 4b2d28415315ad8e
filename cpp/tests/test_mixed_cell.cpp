// SPDX-License-Identifier: GPL-3.0-or-later
// Law of a cell that an inclusion fills, against Eshelby's sphere, and laminate of two phases,
// against closed forms.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "samcontact/plasticity/mixed_cell.hpp"
#include "samcontact/plasticity/two_phase_cell.hpp"

using samcontact::plasticity::Material;
using samcontact::plasticity::MixedCell;
using samcontact::plasticity::MixedLaw;
using samcontact::plasticity::MixedReturn;
using samcontact::plasticity::Phase;
using samcontact::plasticity::Tensor;
using samcontact::plasticity::two_phase_step;
using samcontact::plasticity::TwoPhaseStep;

namespace {

constexpr double E = 210e9, nu = 0.3;
constexpr double G = E / (2 * (1 + nu)), K = E / (3 * (1 - 2 * nu));
constexpr Tensor load{3e8, -2e8, 5e8, 4e7, -6e7, 9e7};

double mean(const Tensor& t) { return (t[0] + t[1] + t[2]) / 3; }

/// a on the mean part plus b on the deviator.
Tensor isotropic(double a, double b, const Tensor& t) {
  Tensor out;
  for (int c = 0; c < 6; ++c) out[c] = b * t[c] + (c < 3 ? (a - b) * mean(t) : 0.0);
  return out;
}

Tensor sum(Tensor a, double factor, const Tensor& b) {
  for (int c = 0; c < 6; ++c) a[c] += factor * b[c];
  return a;
}

/// Stress in a sphere of the matrix with an eigenstrain (Eshelby 1957).
Tensor inside_sphere(const Tensor& eigenstrain) {
  const double bulk = (1 + nu) / (3 * (1 - nu)), shear = 2 * (4 - 5 * nu) / (15 * (1 - nu));
  return sum(load, 1.0, isotropic(-3 * K * (1 - bulk), -2 * G * (1 - shear), eigenstrain));
}

Phase elastic(double bulk, double shear, const Tensor& inelastic = {}) {
  return {bulk, shear, nullptr, 1.0, inelastic, 0.0};
}

}  // namespace

TEST_CASE("one step of the law of a cell solves a sphere in uniform stress") {
  const Material matrix = Material::make_elastic(E, nu);
  const double bulk_part = (1 + nu) / (3 * (1 - nu)),
               shear_part = 2 * (4 - 5 * nu) / (15 * (1 - nu));
  for (const auto& [bulk, shear] : {std::array{0.3, 0.4}, {2.0, 3.0}, {0.5, 4.0}, {0.0, 0.0}}) {
    const MixedLaw law(matrix, false);
    const MixedCell cell{.bulk = bulk, .shear = shear, .material = 0};
    const Material inclusion = Material::make_elastic(E, nu);
    const MixedReturn first = law.step(cell, &inclusion, load, {}, {});
    const Tensor stress = inside_sphere(first.eigenstrain);
    const Tensor expected = isotropic(bulk / (1 + bulk_part * (bulk - 1)),
                                      shear / (1 + shear_part * (shear - 1)), load);
    for (int c = 0; c < 6; ++c) CHECK(std::fabs(stress[c] - expected[c]) <= 1e-13 * 5e8);
    const MixedReturn second = law.step(cell, &inclusion, stress, first.eigenstrain, {});
    for (int c = 0; c < 6; ++c) {
      CHECK(std::fabs(second.eigenstrain[c] - first.eigenstrain[c]) <= 1e-16);
    }
  }
}

TEST_CASE("the solution of a cell does not depend on the part of its strain that a step keeps") {
  const Material matrix = Material::make_elastic(E, nu);
  const MixedCell cell{
      .bulk = 0.4, .shear = 2.5, .misfit = {1e-3, 2e-3, -1e-3, 0, 5e-4, 0}, .material = 0};
  std::array<Tensor, 2> found{};
  for (const bool strong : {false, true}) {
    const MixedLaw law(matrix, strong);
    for (int n = 0; n < 200; ++n) {
      const Tensor stress = inside_sphere(found[strong]);
      found[strong] = law.step(cell, &matrix, stress, found[strong], {}).eigenstrain;
    }
  }
  for (int c = 0; c < 6; ++c) CHECK(found[0][c] == doctest::Approx(found[1][c]).epsilon(1e-10));
}

TEST_CASE("a cell with the constants of the matrix flows as the matrix does") {
  const Material matrix = Material::with_law(
      E, nu, samcontact::plasticity::LinearHardening{.yield_stress = 3e8, .tangent_modulus = 2e10});
  const MixedLaw law(matrix, false);
  const MixedCell cell{.material = 0};
  Tensor stress = load, strain{};
  for (int n = 0; n < 200; ++n) {
    const MixedReturn r = law.step(cell, &matrix, inside_sphere(strain), strain, {});
    strain = r.eigenstrain;
  }
  stress = inside_sphere(strain);
  const auto r = samcontact::plasticity::radial_return(stress, strain, 0.0, matrix);
  CHECK(r.equivalent > 1e-4);
  CHECK(r.excess <= 1e-9);
  for (int c = 0; c < 6; ++c) CHECK(std::fabs(r.increment[c] - strain[c]) <= 1e-9 * 1e-3);
}

TEST_CASE("an elastic laminate has the moduli of layers in series and in parallel") {
  const std::array<double, 2> bulk{K, 2.5 * K}, shear{G, 0.4 * G};
  const double f = 0.3;
  // With p = 1 the strain is prescribed.
  const auto stress_of = [&](const Tensor& strain) {
    const Tensor kept = isotropic(3 * K, 2 * G, strain);
    return two_phase_step({elastic(bulk[0], shear[0]), elastic(bulk[1], shear[1])}, f, {0, 0, 1},
                          {1, 1}, kept, {})
        .stress;
  };
  const auto series = [&](double a, double b) { return 1 / ((1 - f) / a + f / b); };
  const double stiff0 = bulk[0] + 4 * shear[0] / 3, stiff1 = bulk[1] + 4 * shear[1] / 3;
  const Tensor normal = stress_of({0, 0, 1e-3, 0, 0, 0});
  const double szz = 1e-3 * series(stiff0, stiff1);
  CHECK(normal[2] == doctest::Approx(szz).epsilon(1e-9));
  const double along = (1 - f) * (bulk[0] - 2 * shear[0] / 3) * szz / stiff0 +
                       f * (bulk[1] - 2 * shear[1] / 3) * szz / stiff1;
  CHECK(normal[0] == doctest::Approx(along).epsilon(1e-9));
  CHECK(stress_of({0, 0, 0, 1e-3, 0, 0})[3] ==
        doctest::Approx(2e-3 * series(shear[0], shear[1])).epsilon(1e-9));
  CHECK(stress_of({0, 0, 0, 0, 0, 1e-3})[5] ==
        doctest::Approx(2e-3 * ((1 - f) * shear[0] + f * shear[1])).epsilon(1e-9));
}

TEST_CASE("the phases of a laminate in shear carry the same stress and flow apart") {
  const double yield = 3e8, tangent = 2e10, H = E * tangent / (E - tangent), f = 0.4;
  const Material matrix = Material::with_law(
      E, nu,
      samcontact::plasticity::LinearHardening{.yield_stress = yield, .tangent_modulus = tangent});
  const Phase flowing{K, G, &matrix.hardening, 1.0, {}, 0.0};
  const double strain = 4e-3;
  const TwoPhaseStep r = two_phase_step({flowing, elastic(2 * K, 2 * G)}, f, {0, 0, 1}, {1, 1},
                                        isotropic(3 * K, 2 * G, {0, 0, 0, strain, 0, 0}), {});
  // tau (1/2G) of both phases plus the flow (tau sqrt 3 - yield)/H sqrt(3)/2 of the first.
  const double root = std::numbers::sqrt3;
  const double tau =
      (strain + (1 - f) * 0.5 * root * yield / H) / ((1 - f) * (0.5 / G + 1.5 / H) + f * 0.25 / G);
  CHECK(r.stress[3] == doctest::Approx(tau).epsilon(1e-8));
  CHECK(r.equivalent[0] == doctest::Approx((tau * root - yield) / H).epsilon(1e-7));
  CHECK(r.equivalent[1] == 0.0);
  CHECK(r.plastic[0][3] == doctest::Approx(0.5 * root * r.equivalent[0]).epsilon(1e-9));
}

TEST_CASE("every laminate that flows satisfies its equations") {
  const Material matrix = Material::with_law(
      E, nu,
      samcontact::plasticity::LinearHardening{.yield_stress = 1.5e9, .tangent_modulus = 9.5e9});
  const Material soft = Material::with_law(
      E, nu, samcontact::plasticity::LinearHardening{.yield_stress = 4e8, .tangent_modulus = 2e9});
  std::mt19937 random(3);  // NOLINT(bugprone-random-generator-seed): the same in every run
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const auto tensor = [&](double size) {
    Tensor t;
    for (double& v : t) v = size * (2 * uniform() - 1);
    return t;
  };
  const double bulk_part = 2 * (1 - 2 * nu) / (3 * (1 - nu)),
               shear_part = (7 - 5 * nu) / (15 * (1 - nu));
  double worst = 0.0;
  for (int n = 0; n < 100000; ++n) {
    std::array<double, 3> normal{};
    for (double& v : normal) v = 2 * uniform() - 1;
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    for (double& v : normal) v /= length;
    const double size = 6e9 * uniform(), before = 5e-3 * uniform();
    const bool both = n % 2 == 0;
    const std::array<Phase, 2> phases{
        Phase{K, G, &matrix.hardening, 1.0, isotropic(0, 1, tensor(before)), before},
        Phase{both ? 0.6 * K : 1.5 * K, both ? 0.4 * G : 1.9 * G, both ? &soft.hardening : nullptr,
              1.0, isotropic(0, 1, tensor(both ? before : 0.0)), both ? before : 0.0}};
    const Tensor kept = tensor(size);
    const TwoPhaseStep r =
        two_phase_step(phases, uniform(), normal, {bulk_part, shear_part}, kept, tensor(size / E));
    const Tensor sum_of_parts = sum(isotropic(1 - bulk_part, 1 - shear_part, r.stress), 1.0,
                                    isotropic(3 * K * bulk_part, 2 * G * shear_part, r.strain));
    for (int c = 0; c < 6; ++c) {
      worst = std::fmax(worst, std::fabs(sum_of_parts[c] - kept[c]) / size);
    }
  }
  CHECK(worst <= 1e-8);
}
