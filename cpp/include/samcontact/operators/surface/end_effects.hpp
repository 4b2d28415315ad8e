// SPDX-License-Identifier: GPL-3.0-or-later
// Normal surface displacement due to free end faces: difference between the quarter space and the
// half-space, on the cells of a grid (Hetenyi 1970, J. Appl. Mech. 37, 70-76, as one linear
// system).
#pragma once

#include <memory>
#include <vector>

#include "samcontact/base/elastic.hpp"
#include "samcontact/base/free_faces.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/fft/plan.hpp"
#include "samcontact/operators/surface/face_pair.hpp"

namespace samcontact::operators {

/// A body that ends at a face.
struct EndingBody {
  Elastic elastic;
  FaceMethod method;
};

/// Effect of one face: symmetric in load and displacement. With M the mirror image about the face,
/// K the half-space and S the normal stress on one face due to a pressure on the other and its
/// image, u = K (I + M)(I - S^2)^-1 p; here without K p. In Fourier modes along x it is a dense
/// matrix over the distance from the face, on cells that become longer with this distance.
class EndEffect {
 public:
  /// distance: of the centre of each row of cells from the face [m]; <= 0: beyond the face, where
  /// the pressure is ignored and the displacement is zero.
  EndEffect(const Grid& grid, const std::vector<double>& distance,
            const std::vector<EndingBody>& bodies);

  /// displacement [m] += effect of pressure [Pa], both [i][j], different arrays.
  void add(const double* pressure, double* displacement) const;
  /// Operations of one application, in units of fft::filter_cost.
  double cost() const;

 private:
  /// Cells of the effect around a row, and the share of the farther one.
  struct Place {
    int row, cell;
    double share;
  };
  void add_body(const Grid& grid, const EndingBody& body);
  void gather(const double* pressure, double* lines) const;
  void scatter(const double* lines, double* displacement) const;

  int nx_, ny_, mx_;
  double dy_;
  std::vector<double> edges_, centres_;  // distances of the cells of the effect [m]
  std::vector<Place> places_;
  std::vector<int> counts_;           // by wavenumber: cells that the effect reaches
  std::vector<std::size_t> offsets_;  // by wavenumber: beginning of its matrix
  Field matrices_;                    // [wavenumber][cell][cell] [m^2/N], over mx
  fft::Plan forward_, inverse_;
};

/// Effect of all faces of the bodies in contact.
class EndEffects {
 public:
  /// Faces in the coordinate y of the grid. Null if there are none.
  static std::shared_ptr<const EndEffects> of(
      const Grid& grid, const std::vector<std::pair<Elastic, FreeFaces>>& bodies);

  /// Displacement [i][j] [m] due to a pressure [i][j] [Pa].
  Field displacement(const double* pressure) const;
  double cost() const;

 private:
  std::size_t size_ = 0;
  std::vector<EndEffect> effects_;
  std::vector<FacePair> pairs_;  // reflections between two faces of a body
};

using SharedEndEffects = std::shared_ptr<const EndEffects>;

}  // namespace samcontact::operators
