// SPDX-License-Identifier: GPL-3.0-or-later
// Adhesive contact at a given approach: conjugate gradients on the energy as a function of the gap.
// Polonsky & Keer (1999) in the opposite order: the unknown is the displacement, the stiffness is
// the operator, and the compliance the preconditioner; as Rey, Anciaux & Molinari (2017,
// doi:10.1007/s00466-017-1392-5), who precondition with the compliance in periodic surfaces.
#pragma once

#include <vector>

#include "samcontact/contact/laws/contact_law.hpp"
#include "samcontact/contact/normal/adhesive_surface.hpp"

namespace samcontact::contact {

/// Local minimum of the energy 1/2 u' K^-1 u + sum phi(g), g = h + u - approach >= 0, to which the
/// energy decreases from the initial gap.
class GapDescent {
 public:
  /// initial_gap: of the undeformed surfaces; inf: no body. Keeps references.
  GapDescent(const AdhesiveSurface& surface, const ContactLaw& law, const Field& initial_gap);

  /// Sets the start to the gap of a pressure over the grid, or to undeformed surfaces (empty).
  void start_from(const Field& pressure);
  /// Approach at which periodic surfaces would touch everywhere [m]; inf for others.
  double largest_approach() const;
  /// Approach at which the start touches [m].
  double touching() const;

  /// A solution to which the descent can return.
  struct Place {
    Field x;
    double approach;
  };
  Place place() const { return {x_, approach_}; }
  void return_to(const Place& place);

  /// Descends at an approach from the present displacement, which becomes the solution.
  /// Returns whether the error is at most tol after at most max_iterations.
  bool descend(double approach, double tol, int max_iterations);

  double approach() const { return approach_; }
  /// Gap over the grid [m]; inf: no body.
  Field gap() const;
  /// Pressure over the grid [Pa], tension negative.
  Field pressure() const;
  double load() const;  // [N]
  /// Largest residual of the tractions, relative to the largest traction.
  double error() const { return error_; }
  /// Iterations, and applications of compliance and stiffness, of all descents.
  int iterations() const { return iterations_; }
  int applications() const { return applications_; }
  /// Largest increase of the energy in a step, relative to the work of adhesion of the grid.
  double energy_rise() const { return energy_rise_; }

 private:
  /// frozen: padding whose displacement has no meaning. free: without contact and attraction
  /// (padding, cells without a body). body: all others.
  enum class Cell : unsigned char { frozen, free, body };

  bool is_body(std::size_t i) const { return cells_[i] == Cell::body; }
  bool is_open(std::size_t i) const {
    return is_body(i) ? x_[i] > 0 : cells_[i] == Cell::free;
  }
  void approach_to(double approach);
  void keep_mean();
  void press();
  /// Residual of the stationary energy in open cells, and the error.
  void find_residual();
  void find_direction(bool restart);
  /// Moves along the direction; whether cells have opened.
  bool move(bool is_first);
  double step_length(bool is_first);
  double energy() const;
  /// Removes the mean over the open cells, if the mean is fixed.
  void remove_mean(Field& field) const;

  const AdhesiveSurface& surface_;
  const ContactLaw& law_;
  std::vector<Cell> cells_;
  Field undeformed_, height_;  // h and h - approach; 0 in the padding
  double approach_ = 0.0;
  bool has_approach_ = false;
  /// Gap; in free cells the displacement [m].
  Field x_;
  Field p_, attraction_, residual_, before_, z_, t_, q_;
  double multiplier_ = 0.0, error_ = 1.0, rz_ = 0.0, energy_rise_ = 0.0;
  bool exact_ = false;  // whether the pressure is that of the gap without accumulated rounding
  int iterations_ = 0, applications_ = 0;
  ComplexField work_;
};

}  // namespace samcontact::contact
