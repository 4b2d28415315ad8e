// SPDX-License-Identifier: GPL-3.0-or-later
// Elastic displacement of the surfaces of a film, and two approximations of its inverse: a few
// coefficients around each cell, and an iteration on some of the cells.
#pragma once

#include <vector>

#include "samcontact/contact/normal/preconditioner.hpp"
#include "samcontact/film/star.hpp"
#include "samcontact/operators/surface/surface_displacement.hpp"

namespace samcontact::film {

class ElasticFilm {
 public:
  ElasticFilm(const Grid& grid, const operators::SurfaceInfluence& influence);

  /// Displacement [m] due to a pressure [Pa].
  void displace(const Field& pressure, Field& displacement);
  double self_influence() const { return displacement_.self_influence(); }
  /// Applications of displacement and preconditioner so far, in applications of the displacement.
  double applications() const { return applications_; }

  /// Coefficient of the inverse: pressure of a cell due to the displacement of a neighbour.
  struct Neighbour {
    int along_x, along_y;
    double stiffness;  // [Pa/m]
  };
  const std::vector<Neighbour>& nearest() const { return nearest_; }

  /// Solves (K + D) p = u on marked cells by conjugate gradients, until the residual is a share of
  /// the first. compliance: diagonal D [m/Pa]. The pressure of other cells is zero.
  Field press(const Field& displacement, const std::vector<char>& marked, const Field& compliance,
              double share);

 private:
  void precondition(const std::vector<char>& marked, const Field& residual, Field& step);

  Lattice lattice_;
  operators::SurfaceDisplacement displacement_;
  contact::NearOperators near_;
  std::vector<Neighbour> nearest_;
  ComplexField work_;
  double applications_ = 0.0;
};

}  // namespace samcontact::film
