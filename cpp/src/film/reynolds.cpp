// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/film/reynolds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"

namespace samcontact::film {
namespace {

/// Smallest film of third order at a face, relative to the smaller film of its two cells.
constexpr double least_share = 0.9;

/// Cells on each side of a face that its flux depends on.
constexpr int stencil = 2;
constexpr std::size_t stencil_cells = 4;

void require_faces(const Field& faces, std::size_t count, const char* name) {
  if (faces.size() != count) {
    throw std::invalid_argument(std::string(name) + " must have a value for each face, got " +
                                std::to_string(faces.size()) + " instead of " +
                                std::to_string(count));
  }
}

}  // namespace

struct Reynolds::CellValues {
  Field reduced, fluidity, density, density_slope;
  Field content;  // density times film [m]
  Field film;     // at least the thinnest [m]
};

/// A line of cells along an axis, and the faces between them.
struct Reynolds::Line {
  const Lattice& lattice;
  int axis, across;
  int cells;
  double length;  // of a cell along the line [m]

  std::ptrdiff_t at(int k) const {
    return axis == 0 ? lattice.at(k, across) : lattice.at(across, k);
  }
  bool is_closed() const { return axis == 1 && lattice.wraps(); }
  bool has(int k) const { return is_closed() || (k >= 0 && k < cells); }
};

/// A cell of a line and its weight in a sum.
struct Reynolds::Part {
  int cell;
  double share;
};

/// Content that flows through a face, as a sum over cells of the line.
struct Reynolds::Entrained {
  int from;
  bool enters;  // from beyond the grid
  Parts parts;
  double content = 0.0;
  double own = 0.0;  // further weight of the cell from which it flows, in the derivative only
};

/// Flux through the face before cell `number` of a line, and its derivatives with respect to the
/// two cells on each side [m^2/s].
struct Reynolds::Face {
  int number;
  double flux = 0.0;
  std::array<double, stencil_cells> pressure{}, film{}, void_fraction{};

  /// Place of a cell of the line in the derivatives.
  int place(int cell) const { return cell - number + stencil; }
};

Reynolds::Reynolds(const Grid& grid, FaceVelocities velocities, const LubricantTable& lubricant,
                   FlowSettings settings)
    : lattice_(grid),
      grid_(grid),
      velocities_(std::move(velocities)),
      lubricant_(lubricant),
      settings_(std::move(settings)) {
  require_faces(velocities_.along_x, static_cast<std::size_t>(grid.nx + 1) * grid.ny, "along_x");
  require_faces(velocities_.along_y, static_cast<std::size_t>(grid.nx) * (grid.ny + 1), "along_y");
  const auto require = [](const PressureFlow::Faces& given, const Field& faces) {
    for (const Field* field : {&given.factor, &given.fluidity, &given.slope, &given.added}) {
      if (!field->empty()) require_faces(*field, faces.size(), "pressure_flow");
    }
  };
  require(settings_.pressure_flow.along_x, velocities_.along_x);
  require(settings_.pressure_flow.along_y, velocities_.along_y);
  const auto largest = [](const Field& field) {
    return largest_of(field.size(), [&](std::size_t i) { return std::fabs(field[i]); });
  };
  speed_ = std::hypot(largest(velocities_.along_x), largest(velocities_.along_y));
}

Field Reynolds::sum(const FilmFields& fields, Slopes* slopes) const {
  const std::size_t n = lattice_.size();
  CellValues values{Field(n), Field(n), Field(n), Field(n), Field(n), Field(n)};
  for_each_cell(static_cast<std::ptrdiff_t>(n), [&](std::ptrdiff_t i) {
    const auto oil = lubricant_.at(fields.pressure[i]);
    values.reduced[i] = oil.reduced;
    values.fluidity[i] = oil.fluidity;
    values.density[i] = oil.density;
    values.density_slope[i] = oil.density_slope;
    values.content[i] = oil.density * fields.film[i];
    values.film[i] = std::max(fields.film[i], settings_.thinnest);
  });
  if (slopes != nullptr) {
    for (Star* star : {&slopes->pressure, &slopes->film, &slopes->void_fraction}) star->clear();
  }
  Field outflow(n, 0.0);
  add_direction(0, fields, values, outflow, slopes);
  if (lattice_.ny() > 1) add_direction(1, fields, values, outflow, slopes);
  return outflow;
}

void Reynolds::add_direction(int axis, const FilmFields& fields, const CellValues& values,
                             Field& outflow, Slopes* slopes) const {
  const bool along_x = axis == 0;
  const int lines = along_x ? lattice_.ny() : lattice_.nx();
  const double width = along_x ? grid_.dy : grid_.dx;
  const PressureFlow::Faces& given =
      along_x ? settings_.pressure_flow.along_x : settings_.pressure_flow.along_y;
  const auto add = [&](std::ptrdiff_t row, int away, double sign, const Face& face) {
    if (row < 0) return;
    outflow[row] += sign * width * face.flux;
    if (slopes == nullptr) return;
    for (int k = 0; k < 2 * stencil; ++k) {
      const int offset = k + away;
      if (offset < -Star::reach || offset > Star::reach) continue;
      slopes->pressure.entry(row, axis, offset) += sign * width * face.pressure[k];
      slopes->film.entry(row, axis, offset) += sign * width * face.film[k];
      slopes->void_fraction.entry(row, axis, offset) += sign * width * face.void_fraction[k];
    }
  };
#pragma omp parallel for schedule(static) if (lattice_.size() > 10'000)
  for (int across = 0; across < lines; ++across) {
    const Line line{lattice_, axis, across, along_x ? lattice_.nx() : lattice_.ny(),
                    along_x ? grid_.dx : grid_.dy};
    const int faces = line.is_closed() ? line.cells : line.cells + 1;
    for (int f = 0; f < faces; ++f) {
      const std::size_t at = along_x ? static_cast<std::size_t>(f) * lattice_.ny() + across
                                     : static_cast<std::size_t>(across) * (lattice_.ny() + 1) + f;
      const double velocity = along_x ? velocities_.along_x[at] : velocities_.along_y[at];
      const double factor = given.factor.empty() ? 1.0 : given.factor[at];
      Face found = face(line, f, velocity, factor, fields, values);
      if (!given.factor.empty()) add_given_flow(line, given, at, fields, found);
      add(line.at(f - 1), 1 - stencil, 1.0, found);
      if (f < line.cells) add(line.at(f), -stencil, -1.0, found);
    }
  }
}

Reynolds::Face Reynolds::face(const Line& line, int number, double velocity, double factor,
                              const FilmFields& fields, const CellValues& values) const {
  Face face{number};
  add_pressure_flow(line, factor, values, face);
  add_entrained_flow(line, velocity, fields, values, face);
  return face;
}

void Reynolds::add_pressure_flow(const Line& line, double factor, const CellValues& values,
                                 Face& face) const {
  const int f = face.number;
  std::array<Part, 2> mean{{{f - 1, 0.5}, {f, 0.5}}};
  double before = 1.0, after = 1.0;  // weights of the reduced pressures
  if (!line.has(f - 1) || !line.has(f)) {
    // The pressure is zero at the border, half a cell away; the film is extrapolated.
    const bool is_first = !line.has(f - 1);
    const int edge = is_first ? f : f - 1, next = is_first ? f + 1 : f - 2;
    mean = line.cells > 1 ? std::array<Part, 2>{{{edge, 1.5}, {next, -0.5}}}
                          : std::array<Part, 2>{{{edge, 1.0}, {edge, 0.0}}};
    before = is_first ? 0.0 : 2.0;
    after = is_first ? 2.0 : 0.0;
  }
  double film = 0.0;
  for (const Part& part : mean) film += part.share * values.film[line.at(part.cell)];
  film = std::max(film, settings_.thinnest);
  const std::ptrdiff_t left = before > 0 ? line.at(f - 1) : -1, right = after > 0 ? line.at(f) : -1;
  const double rise = (right < 0 ? 0.0 : after * values.reduced[right]) -
                      (left < 0 ? 0.0 : before * values.reduced[left]);
  const double conductance = factor * (film * film * film / (12 * line.length));
  face.flux -= conductance * rise;
  if (left >= 0) face.pressure[stencil - 1] += conductance * before * values.fluidity[left];
  if (right >= 0) face.pressure[stencil] -= conductance * after * values.fluidity[right];
  for (const Part& part : mean) {
    face.film[face.place(part.cell)] -=
        factor * (part.share * film * film / (4 * line.length) * rise);
  }
}

void Reynolds::add_given_flow(const Line& line, const PressureFlow::Faces& given, std::size_t at,
                              const FilmFields& fields, Face& face) const {
  const int f = face.number;
  if (!line.has(f - 1) || !line.has(f)) return;
  const std::ptrdiff_t left = line.at(f - 1), right = line.at(f);
  const double film = std::max(0.5 * (fields.film[left] + fields.film[right]), settings_.thinnest);
  const double fluidity = given.fluidity[at], rise = fields.pressure[right] - fields.pressure[left];
  const double slope = given.slope[at] + fluidity * film * film * film / (12 * line.length);
  face.flux += given.added[at] - slope * rise;
  face.pressure[stencil - 1] += slope;
  face.pressure[stencil] -= slope;
  const double thicker = fluidity * film * film / (8 * line.length) * rise;
  face.film[stencil - 1] -= thicker;
  face.film[stencil] -= thicker;
}

Reynolds::Entrained Reynolds::entrained(const Line& line, int number, int sign,
                                        const CellValues& values) const {
  const int from = sign > 0 ? number - 1 : number, behind = from - sign, ahead = from + sign;
  const auto content_at = [&](int cell) { return values.content[line.at(cell)]; };
  Entrained found{from, !line.has(from), {{{from, 1.0}, {from, 0.0}, {from, 0.0}}}};
  if (found.enters) {  // the film at the border
    const int next = ahead + sign;
    found.parts = line.has(next) ? Parts{{{ahead, 1.5}, {next, -0.5}, {ahead, 0.0}}}
                                 : Parts{{{ahead, 1.0}, {ahead, 0.0}, {ahead, 0.0}}};
  } else if (line.has(ahead) && settings_.order > 1) {
    if (!line.has(behind)) {
      found.parts = {{{from, 0.5}, {ahead, 0.5}, {from, 0.0}}};
    } else if (settings_.order == 2) {
      found.parts = {{{from, 1.5}, {behind, -0.5}, {from, 0.0}}};
    } else {
      found.parts = {{{from, 0.75}, {behind, -0.125}, {ahead, 0.375}}};
    }
  }
  for (const Part& part : found.parts) found.content += part.share * content_at(part.cell);
  if (found.enters || settings_.order < 3 || !line.has(ahead) || !line.has(behind)) return found;
  const int lower = content_at(ahead) < content_at(from) ? ahead : from;
  if (found.content < least_share * content_at(lower)) {
    found.parts = {{{lower, least_share}, {from, 0.0}, {from, 0.0}}};
    found.content = least_share * content_at(lower);
  }
  if (settings_.boundary_thickness > 0) blend(content_at(from), found);
  return found;
}

void Reynolds::blend(double first, Entrained& found) const {
  const double layer = settings_.boundary_thickness, below = settings_.first_order_below * layer;
  const double range = settings_.higher_order_above * layer - below;
  const double s = std::clamp((first - below) / range, 0.0, 1.0);
  const double share = s * s * (3 - 2 * s), difference = found.content - first;
  for (Part& part : found.parts) part.share *= share;
  found.own = (1 - share) + 6 * s * (1 - s) / range * difference;
  found.content = first + share * difference;
}

void Reynolds::add_entrained_flow(const Line& line, double velocity, const FilmFields& fields,
                                  const CellValues& values, Face& face) const {
  if (velocity == 0) return;
  Entrained flow = entrained(line, face.number, velocity > 0 ? 1 : -1, values);
  const bool is_limited = flow.enters && flow.content > settings_.supply;
  if (is_limited) flow.content = settings_.supply;
  const double filling = flow.enters ? 1.0 : 1.0 - fields.void_fraction[line.at(flow.from)];
  face.flux += velocity * filling * flow.content;
  if (!flow.enters) face.void_fraction[face.place(flow.from)] -= velocity * flow.content;
  if (is_limited) return;
  const auto add = [&](int cell, double share) {
    if (share == 0) return;
    const std::ptrdiff_t at = line.at(cell);
    const double weight = velocity * filling * share;
    face.pressure[face.place(cell)] += weight * values.density_slope[at] * fields.film[at];
    face.film[face.place(cell)] += weight * values.density[at];
  };
  for (const Part& part : flow.parts) add(part.cell, part.share);
  add(flow.from, flow.own);
}

}  // namespace samcontact::film
