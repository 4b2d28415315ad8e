// SPDX-License-Identifier: GPL-3.0-or-later
// Linear system of a Newton step of a film: flow, elasticity, boundary layer and load, solved by
// GMRES. Preconditioner: with the film instead of the pressure as the unknown the flow is nearly
// local, and is solved with the nearest coefficients of the inverse elastic operator by an LU
// decomposition in blocks; the pressure of this film follows from conjugate gradients.
#pragma once

#include <vector>

#include "samcontact/film/block_lu.hpp"
#include "samcontact/film/elastic_film.hpp"
#include "samcontact/film/reynolds.hpp"

namespace samcontact::film {

/// Linear system at a state of the film.
struct Linearised {
  const Reynolds::Slopes& slopes;
  const Field& outflow;                // [m^3/s]
  const std::vector<char>& cavitated;  // cells without fluid pressure
  /// Boundary layer: its pressure changes by lag - stiffness times the change of the film.
  const Field& stiffness;  // [Pa/m]
  const Field& lag;        // [Pa]
  double missing_load;     // [N]
  bool has_load;           // whether the load is prescribed, or the approach
  double load_scale;       // [N]
};

/// Change of the state.
struct FilmChange {
  Field fluid_pressure, boundary_pressure;  // [Pa]
  Field film, void_fraction;                // [m], [-]
  double approach = 0.0;                    // [m]
  int steps = 0;                            // of GMRES
};

class FilmSystem {
 public:
  FilmSystem(const Grid& grid, ElasticFilm& elastic);

  /// Solves until the weighted residual is a share of the first, or after max_steps. The change is
  /// empty if the flow has no unique solution.
  FilmChange solve(const Linearised& system, double share, int max_steps);

  /// Numbers in the factors of the last decomposition.
  double fill() const { return factors_.fill(); }

 private:
  /// Kinds of cells at the present state.
  void classify(const Linearised& system);
  /// Whether the matrix can be decomposed.
  bool decompose(const Linearised& system);
  /// Response of the preconditioner to a unit approach.
  void find_response(const Linearised& system);
  /// Displacement, at the pressure of the fluid where it is given, from the solution of the flow.
  Field target(const Linearised& system, const Field& flow, double approach,
               const Field& contact) const;
  void precondition(const Linearised& system, const Field& residual, Field& change);
  void apply(const Linearised& system, const Field& change, Field& image);
  FilmChange unpack(const Linearised& system, const Field& solution);
  /// Pressure that a change implies in each cell.
  Field pressure_of(const Field& change) const;
  Field flow_solution(const Field& residual);
  /// Pressure of the nearest coefficients for a displacement.
  Field nearest_pressure(const Field& displacement) const;

  std::size_t size() const { return lattice_.size(); }

  Lattice lattice_;
  double cell_area_;
  ElasticFilm& elastic_;
  std::vector<char> full_, touched_, stiff_, pressed_;
  Field damping_, column_, contact_weight_, row_scale_;
  Field flow_response_, pressure_response_;
  double load_response_ = 1.0, accuracy_ = 1.0;
  NearMatrix matrix_;
  BlockLu factors_;
};

}  // namespace samcontact::film
