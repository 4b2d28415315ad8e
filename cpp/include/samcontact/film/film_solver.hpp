// SPDX-License-Identifier: GPL-3.0-or-later
// Lubricated contact on one grid: a semismooth Newton method for pressure, film, cavitation and the
// pressure of a boundary layer together.
#pragma once

#include "samcontact/film/elastic_film.hpp"
#include "samcontact/film/film_system.hpp"
#include "samcontact/film/reynolds.hpp"

namespace samcontact::film {

/// Layer adsorbed on the surfaces, or asperities smaller than a cell: its pressure is
/// p_b (h_b/(h - h_b))^3 at a film h > h_b.
struct BoundaryLayer {
  double thickness = 0.0;  // h_b [m]; 0: none
  double pressure = 0.0;   // p_b [Pa]
};

struct FilmProblem {
  const Field& gap;  // of the undeformed surfaces [m]
  bool has_load;     // whether `target` is a load [N] or an approach [m]
  double target;
};

/// State of a film. All fields are [i][j].
struct FilmState {
  Field fluid_pressure, boundary_pressure;  // [Pa]
  Field void_fraction;                      // 1 - filling [-]; 0 in full cells
  Field film;                               // [m]
  double approach = 0.0;                    // [m]
};

/// Content of the film at the previous instants, for a film that changes in time.
struct FilmHistory {
  double step = 0.0;     // [s]; 0: steady
  double present = 1.0;  // weight of the present content
  Field content = {};    // weighted sum of the earlier contents [m]
};

struct FilmSolution {
  FilmState state;
  double load = 0.0;          // [N]
  double error = 0.0;         // largest residual, relative [-]
  int iterations = 0;         // of Newton
  int krylov_steps = 0;       // of GMRES
  double applications = 0.0;  // of the elastic operator
  double fill = 0.0;          // numbers in the factors of the last decomposition
  bool converged = false;
};

struct NewtonSettings {
  double tol = 1e-6;
  int max_iterations = 40;
  int max_krylov_steps = 250;
};

class FilmSolver {
 public:
  FilmSolver(const Grid& grid, const operators::SurfaceInfluence& influence);

  /// Solves from a start whose film is computed from its pressure and approach. Throws
  /// std::invalid_argument for fields of other shape. Without convergence, the last state is
  /// returned.
  FilmSolution solve(const FilmProblem& problem, const FaceVelocities& velocities,
                     const LubricantTable& lubricant, const FlowSettings& flow,
                     const BoundaryLayer& layer, const FilmHistory& history, FilmState start,
                     const NewtonSettings& settings);

  const Grid& grid() const { return grid_; }
  ElasticFilm& elastic() { return elastic_; }

 private:
  class Newton;

  Grid grid_;
  ElasticFilm elastic_;
  FilmSystem system_;
};

}  // namespace samcontact::film
