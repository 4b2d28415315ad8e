// SPDX-License-Identifier: GPL-3.0-or-later
// Adhesive contact at a given approach: conjugate gradients on the energy as a function of the gap.
// Method of Polonsky & Keer (1999) with exchanged roles: the unknown is the displacement, the
// stiffness is the operator, and the compliance the preconditioner; as Rey, Anciaux & Molinari
// (2017, doi:10.1007/s00466-017-1392-5), who precondition with the compliance in periodic surfaces.
#pragma once

#include "samcontact/contact/laws/contact_law.hpp"
#include "samcontact/contact/normal/adhesive_gap.hpp"
#include "samcontact/contact/normal/adhesive_surface.hpp"

namespace samcontact::contact {

/// Local minimum of the energy 1/2 u' K^-1 u + sum phi(g), g = h + u - approach >= 0, to which the
/// energy decreases from the initial gap.
class GapDescent {
 public:
  /// initial_gap: as for AdhesiveGap. Keeps references to surface and law.
  GapDescent(const AdhesiveSurface& surface, const ContactLaw& law, const Field& initial_gap);

  /// Sets the start to the gap of a pressure over the grid, or to undeformed surfaces (empty).
  void start_from(const Field& pressure);
  /// Descends at an approach from the present gap, which becomes the solution. Returns whether the
  /// error is at most tol after at most max_iterations.
  /// On a surface with a free approach, descends at a load [N] from a start that touches, and also
  /// returns false if the contact is lost: the energy is unbounded below under tension.
  bool descend(double given, double tol, int max_iterations);

  AdhesiveGap& gap() { return gap_; }
  const AdhesiveGap& gap() const { return gap_; }
  /// Pressure over the grid [Pa], tension negative, and its resultant [N].
  Field pressure() const;
  double load() const;
  double approach() const;
  /// Largest residual of the tractions, relative to the largest traction.
  double error() const { return error_; }
  /// Iterations, and applications of compliance and stiffness, of all descents.
  int iterations() const { return iterations_; }
  int applications() const { return applications_; }
  /// Largest increase of the energy in a step, relative to the energy or to the work of adhesion
  /// of the grid.
  double energy_rise() const { return energy_rise_; }

 private:
  /// Pressure of the gap.
  void press();
  /// Residual of the stationary energy in open cells, and the error.
  void find_residual();
  void find_direction(bool restart);
  /// Moves by a step along the direction, and opens cells by a share of the displacement under
  /// their residual. Returns whether cells have opened.
  bool move(double step, double share);
  /// Takes one step that decreases the energy. Returns whether the next step must be along the
  /// preconditioned residual alone.
  bool descend_once(bool is_first, double& energy_before);
  double step_length(bool is_first);
  double energy();
  /// Mean over the open cells; 0 if there are none.
  double mean_of_open(const Field& field) const;
  /// Removes the mean over the open cells, if the mean displacement is fixed.
  void remove_mean(Field& field) const;

  const AdhesiveSurface& surface_;
  const ContactLaw& law_;
  AdhesiveGap gap_;
  double work_of_grid_;  // of adhesion, over the cell area
  double rounding_of_pressure_;
  Field p_, residual_, before_, z_, t_, q_, scratch_;
  double mean_pressure_ = 0.0;   // prescribed, with a free approach
  double uniform_softness_ = 0;  // uniform displacement of the open cells due to a force on them
  double multiplier_ = 0.0, error_ = 1.0, rz_ = 0.0, energy_rise_ = 0.0;
  bool exact_ = false;   // whether the pressure is that of the gap without accumulated rounding
  bool is_cold_ = true;  // no earlier state whose branch to follow
  int iterations_ = 0, applications_ = 0;
  ComplexField work_;
};

}  // namespace samcontact::contact
