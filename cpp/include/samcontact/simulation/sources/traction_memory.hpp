// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of a viscoelastic body. Its relaxation r(t) multiplies all moduli, so that its surface
// displacement is the elastic one due to equivalent tractions E, with the tractions
//     T(t) = int r(t - t') dE(t')
// at each point of the surface. The fading part F_i = int exp(-(t - t')/tau_i) dE(t') of each term
// is stored; its recursion is exact for E linear in a step (Taylor, Pister & Goudreau 1970,
// doi:10.1002/nme.1620020106).
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "samcontact/base/box.hpp"
#include "samcontact/base/relaxation.hpp"
#include "samcontact/operators/surface/body_displacement.hpp"
#include "samcontact/simulation/setup/setup.hpp"

namespace samcontact::simulation {

/// Coefficients of a step of time, which may be 0 (elastic) or infinite (long-time state).
struct RelaxationStep {
  std::vector<double> decay;  // exp(-x_i), with x_i = duration/tau_i
  std::vector<double> mean;   // (1 - exp(-x_i))/x_i
  std::vector<double> lag;    // (1 - mean)/x_i
  double compliance;          // factor on the elastic compliance

  /// Throws std::invalid_argument for a fluid in an infinite step.
  RelaxationStep(const Relaxation& relaxation, double duration);
};

/// Tractions of the past, of the kinds that have occurred, on the box of all cells that have been
/// loaded. It moves with the body and extends beyond a grid that is not periodic along x: the track
/// of the contact, which still displaces the surface in the grid. Immutable.
struct TractionMemory {
  Box box;        // nz = 1; counted from the first cell of the grid
  int kinds = 0;  // bits of operators::Traction
  /// [kind][0: equivalent; then fading part of each term][i][j] [Pa]
  Field values = {};
  double supplied = 0.0;  // work of the tractions on this body since the start [J]

  bool has(operators::Traction kind) const { return (kinds >> static_cast<int>(kind) & 1) != 0; }
  /// Number of kinds of tractions.
  int count() const;
  bool operator==(const TractionMemory&) const = default;
};
using TractionMemories = std::array<std::shared_ptr<const TractionMemory>, 2>;

/// What the memory of a viscoelastic body depends on.
struct RelaxingBody {
  RelaxingBody(const Setup& setup, int body);

  const OperatorCache& cache;
  const Grid& grid;
  const Relaxation& relaxation;
  int body;
};

/// Tractions [i][j] on a box of cells that contains the grid, and all of the track of the contact.
struct TrackTractions {
  Box box;
  operators::Tractions tractions;

  bool empty() const { return tractions.pressure.empty(); }
  /// Tractions [i][j] on another box; 0 outside this one.
  operators::Tractions of_box(const Box& other) const;
  /// Subtracts tractions of the same box.
  void subtract(const operators::Tractions& other);
  /// Adds tractions [i][j] of the grid times a factor, of the kinds that this has or `all`.
  void add(double factor, const operators::Tractions& of_grid, const Grid& grid, bool all);
};
/// Elastic displacement of a body along axes [axis][i][j] of the grid [m].
Field displacement(const TrackTractions& cause, const RelaxingBody& body,
                   std::span<const operators::Axis> axes);

/// Equivalent tractions [Pa].
TrackTractions equivalent(const TractionMemory& memory, const RelaxingBody& body);
/// Tractions whose elastic displacement remains at the end of a step in addition to that of the
/// tractions times the compliance factor.
TrackTractions remembered(const TractionMemory& memory, const RelaxingBody& body,
                          const RelaxationStep& step);
/// Memory of a body that has moved through the grid by some cells towards +x. memory: may be null.
std::shared_ptr<const TractionMemory> moved(std::shared_ptr<const TractionMemory> memory,
                                            const Grid& grid, int cells);
/// Memory after a step that ends with tractions [i][j] of the grid. before: may be null.
std::shared_ptr<const TractionMemory> after_step(const TractionMemory* before,
                                                 const RelaxingBody& body,
                                                 const RelaxationStep& step,
                                                 const operators::Tractions& tractions);
/// Elastic energy of a body [J]: the work supplied less this energy is viscous work.
double stored_energy(const TractionMemory& memory, const RelaxingBody& body);

}  // namespace samcontact::simulation
