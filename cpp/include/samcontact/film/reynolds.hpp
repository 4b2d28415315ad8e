// SPDX-License-Identifier: GPL-3.0-or-later
// Conservation of the mass of a lubricant film by finite volumes: the equation of Reynolds with the
// cavitation model of Jakobsson, Floberg and Olsson (Elrod 1981, doi:10.1115/1.3251669).
#pragma once

#include <array>
#include <limits>

#include "samcontact/base/grid.hpp"
#include "samcontact/film/lubricant_table.hpp"
#include "samcontact/film/star.hpp"

namespace samcontact::film {

/// Mean velocity of the two surfaces, normal to the faces between the cells [m/s].
struct FaceVelocities {
  Field along_x;  // [nx + 1][ny]
  Field along_y;  // [nx][ny + 1]
};

/// Flow due to the pressure of a lubricant whose viscosity does not depend on the pressure only,
/// at each face: the flow of the table times a factor [-], that of a constant fluidity
/// [1/(Pa s)], a multiple of the difference of the two pressures [m^2/(Pa s)], and a given flow
/// [m^2/s]. Empty fields: 1, and 0 for the others.
struct PressureFlow {
  struct Faces {
    Field factor, fluidity, slope, added;
  };
  Faces along_x;  // [nx + 1][ny]
  Faces along_y;  // [nx][ny + 1]
};

struct FlowSettings {
  /// Order of the film at a face in the direction of the flow: 1, 2, or 3 (QUICK; Leonard 1979,
  /// doi:10.1016/0045-7825(79)90034-3).
  int order = 3;
  /// Thickness of a boundary layer [m], near which the film at a face is of first order; 0: none.
  double boundary_thickness = 0.0;
  /// Range of films, in thicknesses of this layer, in which the film at a face changes from first
  /// to third order.
  double first_order_below = 4.0, higher_order_above = 20.0;
  /// Film of lubricant that arrives at the inlet [m]; infinite: fully flooded.
  double supply = std::numeric_limits<double>::infinity();
  /// Smallest film in the flow [m]: thinner films conduct as much.
  double thinnest = 0.0;
  PressureFlow pressure_flow = {};
};

/// Film of fluid: pressure, film thickness, and the void fraction of cavitated cells.
struct FilmFields {
  Field pressure, film, void_fraction;
};

class Reynolds {
 public:
  Reynolds(const Grid& grid, FaceVelocities velocities, const LubricantTable& lubricant,
           FlowSettings settings);

  /// Volume that flows out of each cell per time, at the density of p = 0 [m^3/s].
  Field outflow(const FilmFields& fields) const { return sum(fields, nullptr); }

  /// Derivatives of the outflow with respect to pressure, film and void fraction.
  struct Slopes {
    Star pressure, film, void_fraction;
  };
  Field outflow(const FilmFields& fields, Slopes& slopes) const { return sum(fields, &slopes); }

  const Lattice& lattice() const { return lattice_; }
  /// Largest velocity [m/s].
  double speed() const { return speed_; }

 private:
  struct Line;
  struct Face;
  struct CellValues;
  struct Part;
  struct Entrained;
  using Parts = std::array<Part, 3>;

  Field sum(const FilmFields& fields, Slopes* slopes) const;
  void add_direction(int axis, const FilmFields& fields, const CellValues& values, Field& outflow,
                     Slopes* slopes) const;
  Face face(const Line& line, int number, double velocity, double factor, const FilmFields& fields,
            const CellValues& values) const;
  void add_pressure_flow(const Line& line, double factor, const CellValues& values,
                         Face& face) const;
  /// Flow in addition to that of the table.
  void add_given_flow(const Line& line, const PressureFlow::Faces& given, std::size_t at,
                      const FilmFields& fields, Face& face) const;
  /// Content at a face through which the film flows in the direction of the sign.
  Entrained entrained(const Line& line, int number, int sign, const CellValues& values) const;
  /// Changes to first order near the boundary layer; first: content of the cell upstream.
  void blend(double first, Entrained& found) const;
  void add_entrained_flow(const Line& line, double velocity, const FilmFields& fields,
                          const CellValues& values, Face& face) const;

  Lattice lattice_;
  Grid grid_;
  FaceVelocities velocities_;
  const LubricantTable& lubricant_;
  FlowSettings settings_;
  double speed_;
};

}  // namespace samcontact::film
