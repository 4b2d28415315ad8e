// SPDX-License-Identifier: GPL-3.0-or-later
// Shear under a given pressure on a grid: the box of the contact, a start from coarser boxes, and
// the partial-slip iteration on each box.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "samcontact/base/box.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/contact/laws/friction_conditions.hpp"
#include "samcontact/contact/laws/friction_law.hpp"
#include "samcontact/contact/normal/drive.hpp"
#include "samcontact/contact/tangential/shear_problem.hpp"

namespace samcontact::contact {

/// Three tangential rigid motions: along x, along y, and rotation about z at the origin of the
/// grid.
using TangentialDrive = std::array<Given, 3>;
inline constexpr TangentialDrive held{Given::motion(0), Given::motion(0), Given::motion(0)};

/// Drive along x, along y and about z: a value for each, and whether it is a force or a motion.
inline TangentialDrive tangential_drive(const std::array<bool, 3>& is_force,
                                        const std::array<double, 3>& values) {
  const auto given = [&](int k) {
    return is_force[k] ? Given::force(values[k]) : Given::motion(values[k]);
  };
  return {given(0), given(1), given(2)};
}

/// Tangential displacement due to the shear before an increment, in a box, for several solves of
/// the increment.
struct PreviousDisplacement {
  Box box;
  Field displacement;  // [2][i][j] [m]
};

inline const Field no_field{};

/// Vector fields are [2][i][j] on the grid.
struct ShearTask {
  const Field& pressure;  // [i][j] [Pa]
  const FrictionLaw& friction;
  /// Shear before this increment, on body 2 [Pa]; empty: none.
  const Field& previous_shear;
  /// Slip of body 1 relative to body 2 in this increment that is due neither to the rigid motion
  /// nor to the change of the shear [m]; empty: none.
  const Field& free_slip;
  /// Motions of this increment [m, m, rad], or total forces at its end [N, N, N m].
  TangentialDrive drive = held;
  PreviousDisplacement* slid = nullptr;  // owned by a caller with several solves
  /// [xx, xy, yy][i][j] Part of the slip due to the rigid motion that occurs in contact; null: all
  /// of it.
  const Field* slip_part = nullptr;
  /// Sticking cells [i][j] of the start; null: cells below their bound.
  const std::vector<unsigned char>* sticking = nullptr;
  /// Whether the contact is in steady rolling towards +x. Motions, free_slip, slip and
  /// friction_work are then per distance rolled [-, -, 1/m, N]; the motions are creepages and spin.
  bool rolls = false;
  /// Bound of each cell [i][j], relative to that of the law; empty: 1.
  const Field& factor = no_field;
};

struct ShearSolution {
  Field shear, slip;                    // [2][i][j] [Pa], [m]; slip is 0 in sticking cells
  std::vector<unsigned char> sticking;  // [i][j]; cells without pressure do not stick
  std::array<double, 3> motion{};       // of this increment [m, m, rad]
  std::array<double, 3> force{};        // [N, N, N m]
  double friction_work = 0.0;           // of this increment [J]
  double error = 0.0;                   // natural residual e_t
  double energy_gap = 0.0;              // [J]; NaN if friction prevents slip
  int steps = 0, iterations = 0, fallbacks = 0;
  int operator_applications = 0;  // of C on the box of the contact
  /// Work of all transforms of the solve, in units of one application on the box of the contact.
  double work = 0.0;
  bool converged = true;
};

/// Keeps the operators of the last box and of coarser boxes. Thread-safe.
class ShearSolver {
 public:
  ShearSolver(const Grid& grid, operators::TangentialInfluence influence);
  ~ShearSolver();
  ShearSolver(ShearSolver&&) noexcept;
  ShearSolver& operator=(ShearSolver&&) noexcept;
  ShearSolver(const ShearSolver&) = delete;
  ShearSolver& operator=(const ShearSolver&) = delete;

  /// Starts from `shear` and, for prescribed forces, from `motion`; if the shear is empty, from a
  /// solution on coarser boxes. If the iteration ends with an error above tol, converged is false.
  /// The forces must be below the friction limit.
  ShearSolution solve(const ShearTask& task, const Field& shear,
                      const std::array<double, 3>& motion, double tol, int max_steps) const;

  /// Displacement of a cell under its own unit shear on the last box; in rolling, less that of the
  /// cell ahead [m/Pa]. 0 before the first solve.
  double self_influence(bool rolls) const;

 private:
  class Level;
  std::shared_ptr<const Level> level(const Box& box, int margin) const;

  struct Kept;
  Grid grid_;
  operators::TangentialInfluence influence_;
  std::unique_ptr<Kept> kept_;
};

/// Offset along x [cells] at which a step of the contact takes the slip due to spin: from the end
/// positions of its cells back towards their start.
constexpr double spin_lead = 1.0 / 6;

/// Forces of a shear [2][i][j] on a grid about its origin [N, N, N m].
std::array<double, 3> forces(const Grid& grid, const Field& shear);
}  // namespace samcontact::contact
