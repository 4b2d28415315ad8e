// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface/creep_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "samcontact/operators/surface/track_sum.hpp"

namespace samcontact::operators {
namespace {

/// One creep term of a body, relative to the medium whose table serves several bodies.
struct Term {
  double amount, distance;
  bool towards_plus_x;
};

/// Bodies whose coefficients are multiples of those of one medium.
struct Group {
  const Medium* medium;
  double elastic = 0.0;
  std::vector<Term> terms;
};

std::vector<Group> grouped(const std::vector<CreepingBody>& bodies) {
  std::vector<Group> groups;
  for (const CreepingBody& body : bodies) {
    if (body.medium->is_rigid()) continue;
    double ratio = 1.0;
    auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& g) {
      const auto found = body.medium->normal_ratio(Traction::pressure, *g.medium);
      ratio = found.value_or(1.0);
      return found.has_value();
    });
    if (group == groups.end()) {
      group = groups.insert(groups.end(), Group{body.medium.get(), 0.0, {}});
    }
    group->elastic += ratio;
    const MovingCreep& creep = body.creep;
    for (std::size_t n = 0; n < creep.amounts.size(); ++n) {
      group->terms.push_back({ratio * creep.amounts[n], creep.distances[n], creep.towards_plus_x});
    }
  }
  return groups;
}

/// Weights of the pressure of a cell and of the cell ahead in the creep at the end of a cell, and
/// the decay over a cell, for a pressure linear between cell centres.
struct CellWeights {
  double own, ahead, decay;
  explicit CellWeights(double cells) : decay(std::exp(-cells)) {
    if (cells < 1e-3) {
      own = cells * (1.0 / 2 - cells * (1.0 / 6 - cells * (1.0 / 24 - cells / 120)));
      ahead = cells * (1.0 / 2 - cells * (1.0 / 3 - cells * (1.0 / 8 - cells / 30)));
    } else {
      const double mean = std::isinf(cells) ? 0.0 : -std::expm1(-cells) / cells;
      own = 1 - mean;
      ahead = mean - decay;
    }
  }
};

/// Tables [j][i] of the parts of a kernel that are even and odd in x.
struct Parts {
  Field even, odd;
};

/// Adds a term to both parts. kernel: [j][i] at offsets i < nx, with this sign at offsets -i;
/// beyond: [j] sums over the track from offset nx on.
void add_term(const Term& term, const CellWeights& weights, const Field& kernel,
              const Field& beyond, std::size_t nx, double sign, Parts& parts) {
  Field &even = parts.even, &odd = parts.odd;
  const double first = weights.decay * weights.own + weights.ahead;
  const double all = term.towards_plus_x ? sign * term.amount : term.amount;
  const double half = 0.5 * all, half_odd = term.towards_plus_x ? -half : half;
  for (std::size_t j = 0; j < beyond.size(); ++j) {
    const double* k = kernel.data() + j * nx;
    double track = beyond[j];
    const auto response = [&](double here) {
      const double own = weights.own * here + first * track;
      track = here + weights.decay * track;
      return own;
    };
    for (std::size_t i = nx - 1; i > 0; --i) {
      const double ahead = response(k[i]);
      even[j * nx + i] += half * ahead;
      odd[j * nx + i] += half_odd * ahead;
    }
    even[j * nx] += all * response(k[0]);
    for (std::size_t i = 1; i < nx; ++i) {
      const double behind = response(sign * k[i]);
      even[j * nx + i] += half * behind;
      odd[j * nx + i] -= half_odd * behind;
    }
  }
}

/// Kernels of a grid that is not periodic along x, from the response of one cell and its track.
Parts with_tracks(const Grid& grid, const std::vector<Group>& groups, const KernelOffsets& offsets,
                  Traction kind, Axis axis) {
  const std::size_t nx = offsets.nx, size = nx * offsets.ny;
  Parts parts{Field(size, 0.0), Field(size, 0.0)};
  const bool is_odd = compliance_parity(kind, axis).odd_x;
  Field& elastic = is_odd ? parts.odd : parts.even;
  for (const Group& group : groups) {
    const Field kernel =
        group.medium->compliance(kind, axis, grid, CellOffsets::lattice(offsets.nx, offsets.ny));
    for (std::size_t n = 0; n < kernel.size(); ++n) elastic[n] += group.elastic * kernel[n];
    std::vector<double> decays;
    decays.reserve(group.terms.size());
    for (const Term& term : group.terms) decays.push_back(grid.dx / term.distance);
    const std::vector<Field> beyond = track_sums(*group.medium, kind, axis, grid, offsets, decays);
    for (std::size_t t = 0; t < group.terms.size(); ++t) {
      add_term(group.terms[t], CellWeights(decays[t]), kernel, beyond[t], nx, is_odd ? -1.0 : 1.0,
               parts);
    }
  }
  return parts;
}

/// Spectra of both parts.
std::vector<ParityKernel> spectra(Parts parts, const SurfaceConvolution& convolution, Traction kind,
                                  Axis axis) {
  const kernels::Parity own = compliance_parity(kind, axis);
  std::vector<ParityKernel> kernels{{{false, own.odd_y, own.odd_z}, std::move(parts.even)},
                                    {{true, own.odd_y, own.odd_z}, std::move(parts.odd)}};
  for (ParityKernel& kernel : kernels) convolution.transform(kernel);
  return kernels;
}

/// Factor of the displacement of a Fourier mode exp(i q x): real part, and part along i q.
struct ModeFactor {
  double real, imaginary;
};

ModeFactor mode_factor(const Group& group, double wavenumber) {
  ModeFactor factor{group.elastic, 0.0};
  for (const Term& term : group.terms) {
    const double phase = wavenumber * term.distance;
    if (std::isinf(phase)) continue;
    const double real = term.amount / (1 + phase * phase);
    factor.real += real;
    factor.imaginary += (term.towards_plus_x ? -phase : phase) * real;
  }
  return factor;
}

}  // namespace

std::vector<ParityKernel> creep_kernels(const Grid& grid, const std::vector<CreepingBody>& bodies,
                                        const SurfaceConvolution& convolution) {
  const KernelOffsets& offsets = convolution.offsets();
  const std::vector<Group> groups = grouped(bodies);
  const kernels::Parity even = compliance_parity(Traction::pressure, Axis::z);
  const kernels::Parity odd{!even.odd_x, even.odd_y, even.odd_z};
  if (grid.period.x == 0) {
    return spectra(with_tracks(grid, groups, offsets, Traction::pressure, Axis::z), convolution,
                   Traction::pressure, Axis::z);
  }
  std::vector<ParityKernel> kernels{{even, {}}, {odd, {}}};
  const std::size_t width = convolution.mx() / 2 + 1;
  for (const Group& group : groups) {
    ParityKernel elastic{even,
                         group.medium->compliance(Traction::pressure, Axis::z, grid,
                                                  CellOffsets::lattice(offsets.nx, offsets.ny))};
    convolution.transform(elastic);
    if (&group == groups.data()) {
      for (ParityKernel& kernel : kernels) kernel.quarter.assign(elastic.quarter.size(), 0.0);
    }
    for (std::size_t kx = 0; kx < width; ++kx) {
      const double q =
          2 * std::numbers::pi * static_cast<double>(kx) / (convolution.mx() * grid.dx);
      const auto [real, imaginary] = mode_factor(group, q);
      // A real field has no imaginary part at the shortest wave.
      const double across = kx + 1 == width ? 0.0 : imaginary;
      for (std::size_t at = kx; at < elastic.quarter.size(); at += width) {
        kernels[0].quarter[at] += real * elastic.quarter[at];
        kernels[1].quarter[at] -= across * elastic.quarter[at];
      }
    }
  }
  return kernels;
}

std::vector<ParityKernel> creep_kernels(const Grid& grid, const std::vector<CreepingBody>& bodies,
                                        const SurfaceConvolution& convolution, Traction kind,
                                        Axis axis) {
  std::vector<Group> groups;
  for (const CreepingBody& body : bodies) {
    if (body.medium->is_rigid()) continue;
    groups.push_back(Group{body.medium.get(), body.factor, {}});
    const MovingCreep& creep = body.creep;
    for (std::size_t n = 0; n < creep.amounts.size(); ++n) {
      groups.back().terms.push_back(
          {body.factor * creep.amounts[n], creep.distances[n], creep.towards_plus_x});
    }
  }
  if (groups.empty()) return {};
  return spectra(with_tracks(grid, groups, convolution.offsets(), kind, axis), convolution, kind,
                 axis);
}

}  // namespace samcontact::operators
