// SPDX-License-Identifier: GPL-3.0-or-later
// Gap of an adhesive contact as the unknown: the cells that are open, and the displacement that the
// gap implies at an approach.
#pragma once

#include <cstddef>
#include <vector>

#include "samcontact/contact/laws/contact_law.hpp"
#include "samcontact/contact/normal/adhesive_surface.hpp"

namespace samcontact::contact {

class AdhesiveGap {
 public:
  /// initial_gap: of the undeformed surfaces over the grid; inf: no body.
  AdhesiveGap(const AdhesiveSurface& surface, const Field& initial_gap);

  std::size_t size() const { return x_.size(); }
  /// Gap of cells with both bodies; in all other cells the displacement [m].
  Field& values() { return x_; }
  const Field& values() const { return x_; }
  double approach() const { return approach_; }
  /// Whether any cell is closed.
  bool touches() const;
  /// Gap of the undeformed surfaces [m]; 0 in cells without both bodies.
  double undeformed(std::size_t i) const { return undeformed_[i]; }

  /// Cells with both bodies.
  bool is_body(std::size_t i) const { return cells_[i] == Cell::body; }
  /// Cells that take no part: the padding of a surface whose mean displacement is zero.
  bool is_frozen(std::size_t i) const { return cells_[i] == Cell::frozen; }
  /// Cells whose displacement is free: with a gap, or without contact.
  bool is_open(std::size_t i) const { return is_body(i) ? x_[i] > 0 : cells_[i] == Cell::free; }

  /// Sets the gap to that of a pressure over the grid, or of undeformed surfaces (empty).
  void start_from(const Field& pressure, const ContactLaw& law, ComplexField& work);
  /// Approach at which the start touches, and at which periodic surfaces would touch everywhere
  /// (inf for others) [m].
  double touching() const;
  double largest_approach() const;

  /// Changes the approach. A contact keeps its gap; separated surfaces keep their displacement.
  void approach_to(double approach);
  /// Sets the gap and approach to those of an earlier gap.
  void return_to(const Field& values, double approach);
  /// Restores the mean gap of a surface whose mean displacement is zero.
  void keep_mean();
  /// Displacement [m], padded.
  void displacement(Field& found) const;
  /// Gap over the grid [m]; inf: no body.
  Field over_grid() const;

 private:
  enum class Cell : unsigned char { frozen, free, body };

  /// Whether a pressure is that of surfaces that do not touch: its tension is less than the
  /// attraction at the gap that they would have if they touched. gap: with lowest value 0 [m].
  bool is_separated(const ContactLaw& law, const Field& pressure, const Field& gap) const;

  const AdhesiveSurface& surface_;
  std::vector<Cell> cells_;
  Field x_, undeformed_, height_;  // height: undeformed - approach; both 0 in the padding
  double approach_ = 0.0;
  bool has_approach_ = false;
};

}  // namespace samcontact::contact
