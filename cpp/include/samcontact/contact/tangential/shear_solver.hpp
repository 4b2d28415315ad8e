// SPDX-License-Identifier: GPL-3.0-or-later
// Shear under a given pressure on a grid: the box of the contact, a start from coarser boxes, and
// the iteration of stick and slip on each.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "samcontact/base/box.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/contact/laws/friction_law.hpp"
#include "samcontact/contact/normal/drive.hpp"
#include "samcontact/contact/tangential/shear_problem.hpp"

namespace samcontact::contact {

/// The three rigid motions along the surface: x, y, and the turn about z at the origin of the grid.
using TangentialDrive = std::array<Given, 3>;
inline constexpr TangentialDrive held{Given::motion(0), Given::motion(0), Given::motion(0)};

/// Along x and y, and the turn: of each whether its value is a force, else a motion.
TangentialDrive tangential_drive(const std::array<bool, 3>& is_force,
                                 const std::array<double, 3>& values);

/// How the shear before an increment lets the surfaces slide in a box, for several solves of it.
struct SlidBefore {
  Box box;
  Field displacement;  // [2][i][j] [m]
};

/// Vector fields are [2][i][j] on the grid.
struct ShearTask {
  const Field& pressure;  // [i][j] [Pa]
  const FrictionLaw& friction;
  /// Before this increment, on body 2 [Pa]; empty: none.
  const Field& previous_shear;
  /// Slip of body 1 over body 2 in this increment but for the rigid motion and what the change of
  /// the shear does [m]; empty: none.
  const Field& free_slip;
  /// Motions of this increment [m, m, rad], or total forces at its end [N, N, N m].
  TangentialDrive drive = held;
  SlidBefore* slid = nullptr;  // kept by the caller of several solves
  /// [xx, xy, yy][i][j] What a cell slips in touch of the rigid motion; without, all of it.
  const Field* in_touch = nullptr;
  /// Cells [i][j] of the start; without, those below their bound.
  const std::vector<unsigned char>* sticking = nullptr;
  /// The contact rolls steadily towards +x. Motions, free_slip, slip and friction_work are per way
  /// that it rolls [-, -, 1/m, N]: motions are creepages and spin.
  bool rolls = false;
};

struct ShearSolution {
  Field shear, slip;                    // [2][i][j] [Pa], [m]; slip is 0 where the contact sticks
  std::vector<unsigned char> sticking;  // [i][j]; without pressure nothing sticks
  std::array<double, 3> motion{};       // of this increment [m, m, rad]
  std::array<double, 3> force{};        // [N, N, N m]
  double friction_work = 0.0;           // of this increment [J]
  double error = 0.0;                   // natural residual e_t
  double energy_gap = 0.0;              // [J]; no number where friction prevents slip
  int steps = 0, iterations = 0, fallbacks = 0;
  int operator_applications = 0;  // of C on the box of the contact
  /// Transforms of the whole solve in applications on the box of the contact.
  double work = 0.0;
  bool converged = true;
};

/// Keeps the operators of the box used last and of coarser ones. Thread-safe.
class ShearSolver {
 public:
  ShearSolver(const Grid& grid, operators::TangentialInfluence influence);
  ~ShearSolver();
  ShearSolver(ShearSolver&&) noexcept;
  ShearSolver& operator=(ShearSolver&&) noexcept;
  ShearSolver(const ShearSolver&) = delete;
  ShearSolver& operator=(const ShearSolver&) = delete;

  /// Starts from `shear` and from `motion` of the forces that are given, or from coarser boxes if
  /// the shear is empty.
  /// Where the iteration ends beyond tol, converged is false. The forces must be possible.
  ShearSolution solve(const ShearTask& task, const Field& shear,
                      const std::array<double, 3>& motion, double tol, int most_steps) const;

 private:
  class Level;
  std::shared_ptr<const Level> level(const Box& box, int margin) const;

  struct Kept;
  Grid grid_;
  operators::TangentialInfluence influence_;
  std::unique_ptr<Kept> kept_;
};

/// Of a cell along x: a step of the contact takes the slip of a turn where its cells are so far
/// from where they end, back to where they came from.
constexpr double spin_lead = 1.0 / 6;

/// Forces of a shear [2][i][j] on a grid about its origin [N, N, N m].
std::array<double, 3> forces(const Grid& grid, const Field& shear);
/// The largest forces that friction holds under a pressure: along the surface, and the torque.
struct LargestForces {
  double along, torque;
};
LargestForces largest_forces(const Grid& grid, const Field& pressure, const FrictionLaw& friction);

}  // namespace samcontact::contact
