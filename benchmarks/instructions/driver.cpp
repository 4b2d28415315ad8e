// SPDX-License-Identifier: GPL-3.0-or-later
// Runs one of the hottest kernels on fixed data; guard.py counts its instructions.
//
//   samcontact_instructions            names of the kernels
//   samcontact_instructions KERNEL N   prepares the data of the kernel and runs it N times; with
//                                      N = 0 only the preparation is counted
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "samcontact/operators/convolution/volume_spectrum.hpp"
#include "samcontact/operators/residual/layer_residual_stress.hpp"
#include "samcontact/plasticity/return_mapping.hpp"

using namespace samcontact;

namespace {

/// A smooth sequence without period in [-1, 1]: the same numbers in every build.
double number(std::size_t n) { return std::sin(1.7 * static_cast<double>(n) + 0.3); }

/// Prepares the data and returns one run of the kernel; the run returns a number that depends on
/// its results, so that no compiler omits it.
using Prepare = std::function<double()> (*)();

const Grid box(64, 64, 1e-6, 1e-6, 32, 1e-6);

/// Residual stress of all wavenumbers of a box, without transforms and without images.
std::function<double()> layer_sweep() {
  const operators::VolumeTransform transform(box, operators::Symmetry::none);
  const operators::ResidualSettings settings{operators::ResidualMethod::fast, 0.1, {}};
  const operators::LayerResidualStress stress(box, transform, {{}, Elastic::isotropic(210e9, 0.3)},
                                              settings);
  operators::VolumeSpectrum spectrum(transform, box.nz, operators::Tensor::deviator);
  for (std::size_t n = 0; n < spectrum.data.size(); ++n) {
    spectrum.data[n] = 1e-3 * number(n);
  }
  // In place: a copy would count as well.
  return [stress, spectrum]() mutable {
    stress.apply(spectrum);
    return spectrum.data[spectrum.data.size() / 2];
  };
}

/// 100 000 cells of AISI 52100, about half of which yield.
std::function<double()> radial_return() {
  constexpr std::size_t cells = 100'000;
  const auto steel =
      plasticity::Material::with_law(210e9, 0.3, plasticity::Swift{945e6, 20.0, 0.121});
  std::vector<plasticity::Tensor> stress(cells);
  std::vector<double> strain(cells);
  for (std::size_t n = 0; n < cells; ++n) {
    for (std::size_t c = 0; c < 6; ++c) stress[n][c] = 0.8e9 * number(7 * n + c);
    strain[n] = 1e-3 * (1 + number(7 * n + 6));
  }
  return [steel, stress, strain]() {
    double sum = 0.0;
    for (std::size_t n = 0; n < stress.size(); ++n) {
      sum += plasticity::radial_return(stress[n], {}, strain[n], steel).equivalent;
    }
    return sum;
  };
}

/// A deviator of a box to wavenumbers and back.
std::function<double()> transforms(operators::Symmetry symmetry) {
  struct Data {
    explicit Data(operators::Symmetry symmetry) : transform(box, symmetry) {}
    operators::VolumeTransform transform;
    operators::VolumeSpectrum spectrum{transform, box.nz, operators::Tensor::deviator};
    Field field = Field(5 * transform.plane_size() * box.nz);
  };
  const auto data = std::make_shared<Data>(symmetry);
  for (std::size_t n = 0; n < data->field.size(); ++n) data->field[n] = number(n);
  return [data]() {
    operators::forward(data->transform, data->field.data(), data->spectrum);
    operators::inverse(data->transform, data->spectrum, data->field.data());
    // Scales back to the original size: the transform is not normalised.
    const double unit = 1.0 / (data->transform.mx() * data->transform.my());
    for (double& value : data->field) value *= unit;
    return data->field[data->field.size() / 2];
  };
}

std::function<double()> padded_transforms() { return transforms(operators::Symmetry::none); }
std::function<double()> mirrored_transforms() { return transforms(operators::Symmetry::xy); }

const std::map<std::string, Prepare> measured{{"layer_sweep", layer_sweep},
                                              {"radial_return", radial_return},
                                              {"padded_transforms", padded_transforms},
                                              {"mirrored_transforms", mirrored_transforms}};

}  // namespace

int main(int argc, char** argv) {
  if (argc == 1) {
    for (const auto& [name, prepare] : measured) std::puts(name.c_str());
    return 0;
  }
  const auto found = measured.find(argv[1]);
  if (argc != 3 || found == measured.end()) {
    std::fputs("usage: samcontact_instructions [KERNEL RUNS]\n", stderr);
    return 2;
  }
  const auto run = found->second();
  double sum = 0.0;
  for (int n = std::atoi(argv[2]); n > 0; --n) sum += run();
  std::printf("%.15g\n", sum);
  return 0;
}
