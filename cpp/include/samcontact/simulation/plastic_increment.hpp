// SPDX-License-Identifier: GPL-3.0-or-later
// The fixed point of one increment: contact, stress and radial return for a given guess of the
// plastic strain increment.
#pragma once

#include <vector>

#include "samcontact/simulation/simulation.hpp"

namespace samcontact::simulation {

/// The unknown is the plastic strain increment of all inelastic bodies, [body][component][k][i][j].
class PlasticIncrement {
 public:
  PlasticIncrement(const State& from, const Target& target, Counters& counters);

  struct Result {
    contact::Solution contact;
    double excess = 0.0;     // largest relative yield excess of the stress
    double overshoot = 0.0;  // largest relative yield excess of the trial stress
    /// Euclidean norm over the flowing cells of the strain at yield, yield stress / 3 G.
    double yield_strain_norm = 0.0;
  };

  /// mapped = G(guess). contact_tol applies to load and approach.
  Result evaluate(const Field& guess, double contact_tol, Field& mapped);

  std::size_t size() const { return bodies_.size() * body_size_; }
  bool has_plastic_body() const { return !bodies_.empty(); }

  /// The state after the increment `mapped` of the last evaluation.
  State finish(const Field& mapped, const Result& result) const;

 private:
  void residual_fields(int body, const double* guess, Field& gap,
                       operators::VolumeSpectrum& spectrum);
  contact::Solution solve_contact(const Field& gap, double tol);
  void return_map(int body, const double* guess, double* mapped, double* equivalent,
                  Result& result) const;

  const State& from_;
  const Target& target_;
  Counters& counters_;
  const Scene& scene_;
  std::vector<int> bodies_;  // inelastic ones
  std::size_t cells_, body_size_;
  operators::Tractions tractions_;
  Field equivalent_;  // [body][k][i][j], of the last evaluation
  Field strain_, stress_;
  std::vector<operators::VolumeSpectrum> spectra_;
};

}  // namespace samcontact::simulation
