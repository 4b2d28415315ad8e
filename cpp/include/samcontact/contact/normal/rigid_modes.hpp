// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid-body motions of a contact whose forces are prescribed, over the cells of one grid:
// projections of pressures and gaps that keep load and moments.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/box.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/base/threads.hpp"
#include "samcontact/contact/normal/drive.hpp"

namespace samcontact::contact {

/// Approach and tilts with prescribed forces. Lever arms refer to the line of action of the load,
/// about which the pressure has no moment. Prescribed tilts are part of the gap, not of this class.
class RigidModes {
 public:
  /// Sums over cells do not depend on the number of threads.
  RigidModes(const Drive& drive, const Grid& grid);

  const Given& normal() const { return normal_; }
  /// Whether a tilt is free. Then the load is prescribed and positive.
  bool tilts() const { return free_[0] || free_[1]; }
  /// Modes over the grid with cells twice as long, or over the cells of a box.
  RigidModes coarsened() const;
  RigidModes over(const Box& box) const;
  /// Box that contains the cells next to the line of action of the load.
  Box united(Box box) const;
  /// Modes of bodies that do not exist in cells with larger gaps than this one.
  RigidModes within(double largest_gap) const;

  /// Makes a pressure >= 0 meet the prescribed load and moments: scales it, and for moments
  /// multiplies it by the exponential of a plane. Without a prescribed load nothing changes. False,
  /// with the pressure unchanged, if the line of action lies outside the cells with pressure.
  bool meet(Field& pressure) const;
  /// Scales a pressure to the prescribed load, and returns the factor; 1 without a prescribed load.
  double scale(Field& pressure) const;
  /// Like meet(), except that a pressure that cannot meet the moments is replaced by one over all
  /// cells. gap: by cell, of the undeformed bodies.
  bool meet_anywhere(const Field& gap, Field& pressure) const;
  /// Whether load and moments are met except for rounding.
  bool is_met(const Field& pressure, double tol) const;

  /// Tilts that make the weighted moments of field - plane vanish; 0 about directions in which the
  /// cells have no extent. weight: function of the cell.
  template <class Weight>
  AboutAxes slope(const Field& field, const Weight& weight) const {
    return solve(sums(weight, [&](std::size_t i) { return field[i]; }));
  }
  /// Subtracts the plane of a tilt from a field.
  void lower(const AboutAxes& tilt, Field& field) const;
  /// Subtracts from a field the plane at which its moments over the pressure vanish, and returns
  /// the tilt; nothing without free tilts.
  AboutAxes level(const Field& pressure, Field& field) const;

  /// Gap = field - rigid motion, in place. Returns the motion: a free tilt by level(), and a free
  /// approach as the mean over the contact.
  RigidMotion close(const Field& pressure, Field& field) const;

 private:
  /// Sums of w, w times each arm and product of arms, and of w f times 1 and each arm.
  struct Sums {
    double weight = 0.0, xx = 0.0, xy = 0.0, yy = 0.0, field = 0.0;
    AboutAxes arm{}, moment{};
  };
  RigidModes() = default;

  template <class Weight, class Value>
  Sums sums(const Weight& weight, const Value& value) const {
    const std::ptrdiff_t nx = std::ssize(arms_[1]);
    const std::size_t ny = arms_[0].size();
    std::vector<std::array<double, 5>> rows(nx);
#pragma omp parallel for schedule(static) if (nx * static_cast<std::ptrdiff_t>(ny) >= \
                                                  min_parallel_cells)
    for (std::ptrdiff_t i = 0; i < nx; ++i) {
      std::array<double, 5> row{};
      for (std::size_t j = 0; j < ny; ++j) {
        const std::size_t cell = i * ny + j;
        const double w = weight(cell);
        if (w == 0) continue;
        const double arm = w * arms_[0][j], f = value(cell);
        row[0] += w;
        row[1] += arm;
        row[2] += arm * arms_[0][j];
        row[3] += w * f;
        row[4] += arm * f;
      }
      rows[i] = row;
    }
    Sums all;
    for (std::ptrdiff_t i = 0; i < nx; ++i) {
      const double arm = arms_[1][i];
      const auto& [w, wy, wyy, wf, wyf] = rows[i];
      all.weight += w;
      all.arm[0] += wy;
      all.arm[1] += arm * w;
      all.xx += wyy;
      all.xy += arm * wy;
      all.yy += arm * arm * w;
      all.field += wf;
      all.moment[0] += wyf;
      all.moment[1] += arm * wf;
    }
    return all;
  }
  /// Tilts of the weighted least-squares plane, whose constant term is free too.
  AboutAxes solve(const Sums& sums) const;
  /// Exponents of the factor exp(plane) at which the moments of a pressure vanish; false: none.
  bool find_exponents(const Field& pressure, AboutAxes& exponents) const;
  double factor(const AboutAxes& exponents, std::size_t cell) const;

  Given normal_{};
  double cell_area_ = 0.0, largest_gap_ = INFINITY;
  std::array<double, 2> size_{};  // of a cell along y and x, the directions of the arms [m]
  std::array<bool, 2> free_{};
  AboutAxes centre_{};  // y and -x of the line of action [m]; 0 for a held tilt
  /// y and -x relative to the line of action, of columns and rows of cells [m].
  std::array<std::vector<double>, 2> arms_;
};

}  // namespace samcontact::contact
