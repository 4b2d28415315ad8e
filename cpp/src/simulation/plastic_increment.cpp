// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/plastic_increment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "samcontact/base/memory.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"
#include "samcontact/plasticity/return_mapping.hpp"

namespace samcontact::simulation {
namespace {

using operators::Tensor;

/// Elastic stress above this part of the yield stress belongs into the box.
constexpr double near_yield = 0.9;
/// Flow at the border of the grid that is little against the strain that is there.
constexpr double negligible_flow = 1e-4;
/// Cells around what must be in a box.
constexpr int margin = 2;

/// Memory of an increment a cell of its box where all of them flow and it is divided; as measured,
/// docs/architecture.md has the parts.
constexpr double fast_bytes = 950, exact_bytes = 1800;

double bytes_of(const Box& box, operators::ResidualMethod method) {
  const bool exact = method == operators::ResidualMethod::exact;
  return static_cast<double>(box.volume_size()) * (exact ? exact_bytes : fast_bytes);
}

/// Before a box of the volume is taken instead of another one, which is given back.
void require_memory_of(const Box& box, const Box& before, operators::ResidualMethod method) {
  require_memory(bytes_of(box, method) - bytes_of(before, method),
                 "the plastic zone, " + std::to_string(box.nx) + " x " + std::to_string(box.ny) +
                     " x " + std::to_string(box.nz) + " cells of the grid,");
}

/// All six components of unknown number n; with 5 components zz follows.
plasticity::Tensor tensor_of(const Field& unknown, std::size_t n, int components) {
  const double* u = unknown.data() + n * components;
  if (components == 6) return {u[0], u[1], u[2], u[3], u[4], u[5]};
  return {u[0], u[1], -(u[0] + u[1]), u[2], u[3], u[4]};
}

void put(const plasticity::Tensor& t, Field& unknown, std::size_t n, int components) {
  const auto places = operators::components(components == 6 ? Tensor::full : Tensor::deviator);
  for (int c = 0; c < components; ++c) unknown[n * components + c] = t[places[c]];
}

/// One extent of a box that holds [begin, end) of a grid of n cells, and had `before` cells: with
/// room to grow, and a count that transforms fast. As much is added at both ends: contacts that are
/// mirror images have boxes that are.
void fit_extent(int n, int before, bool mirrored, int& begin, int& end) {
  if (mirrored) {
    begin = std::min(begin, n - end);
    end = n - begin;
  }
  const int needed = end - begin;
  int cells = needed;
  if (before > 0 && cells > before) cells = std::max(cells, before + before / 4);
  const auto good = [](int count) { return (fft::good_even_size(2 * count - 1) + 1) / 2; };
  for (cells = good(cells); (cells - needed) % 2 != 0;) cells = good(cells + 1);
  if (cells > n - n / 8) cells = n;
  begin = cells == n ? 0 : std::clamp(begin - (cells - needed) / 2, 0, n - cells);
  end = begin + cells;
}

/// Of the cells where a traction acts, for its window only.
Box bounding_box(const Field& field, const Grid& grid) {
  Box box = samcontact::bounding_box(grid, [&](std::size_t at) { return field[at] != 0; });
  box.nz = 0;
  return box;
}

/// Half the square of a deviator xx, yy, yz, xz, xy.
double second_invariant(const std::array<double, 5>& s) {
  return s[0] * s[0] + s[1] * s[1] + s[0] * s[1] + s[2] * s[2] + s[3] * s[3] + s[4] * s[4];
}

/// Sum of the backstresses of a cell: xx, yy, yz, xz, xy.
std::array<double, 5> centre(const Field& backstress, std::size_t cells, std::size_t cell) {
  std::array<double, 5> sum{};
  int c = 0;
  for (std::size_t at = cell; at < backstress.size(); at += cells) sum[c++ % 5] += backstress[at];
  return sum;
}

}  // namespace

/// Mirror planes of the increment: those of the scene, of the target, and of what happened before.
fft::Symmetry PlasticIncrement::choose_symmetry() const {
  using fft::Symmetry;
  if (from_.method == operators::ResidualMethod::exact) return Symmetry::none;
  Symmetry symmetry = scene_.symmetry(from_.travel);
  if (target_.kind == Target::Kind::tractions) {
    symmetry = symmetry_of(tractions_, scene_.grid);
  }
  symmetry = common(symmetry, symmetry_of(target_.heating));
  symmetry = common(symmetry, target_.past_symmetry);
  for (const auto& history : from_.plastic) {
    if (history) symmetry = common(symmetry, history->symmetry());
  }
  return symmetry;
}

bool PlasticIncrement::twins() const {
  const auto& [upper, lower] = scene_.materials;
  if (!upper.is_plastic() || upper != lower || scene_.friction > 0) return false;
  if (target_.heating[0] != target_.heating[1] || target_.past[0] != target_.past[1]) return false;
  // Two laws cannot be compared.
  if (settings_.softening[0] || settings_.softening[1]) return false;
  // Shear acts on the two in opposite directions.
  if (!target_.tractions.shear_x.empty() || !target_.tractions.shear_y.empty()) return false;
  const auto offset = from_.placement().offset;
  return offset[0] == offset[1] && same(from_.plastic[0], from_.plastic[1]);
}

Box PlasticIncrement::fit(const Box& needed, const Box& before) const {
  const Grid& grid = scene_.grid;
  const bool mirror_x = symmetry_ == fft::Symmetry::xy, mirror_y = symmetry_ != fft::Symmetry::none;
  const Box old = before.empty() ? Box{} : whole_box(before, grid, symmetry_);
  int i0 = needed.i0, i1 = needed.i0 + needed.nx, j0 = needed.j0, j1 = needed.j0 + needed.ny;
  fit_extent(grid.nx, old.nx, mirror_x, i0, i1);
  fit_extent(grid.ny, old.ny, mirror_y, j0, j1);
  int nz = needed.nz;
  if (before.nz > 0 && nz > before.nz) nz = std::max(nz, before.nz + before.nz / 4);
  nz = std::min(nz, grid.nz);
  if (nz > grid.nz - grid.nz / 8) nz = grid.nz;
  const Box part = stored_part(grid, symmetry_);
  i0 = std::max(i0, part.i0);
  j0 = std::max(j0, part.j0);
  return {i0, j0, i1 - i0, j1 - j0, nz};
}

PlasticIncrement::PlasticIncrement(const State& from, const Target& target, const Scans& scans,
                                   const Settings& settings, Counters& counters)
    : from_(from),
      target_(target),
      settings_(settings),
      counters_(counters),
      scene_(from.scene()),
      tractions_(target.kind == Target::Kind::tractions
                     ? seen_from_body(target.tractions, scene_.grid, from.placement().origin)
                     : operators::Tractions{from.tractions.pressure, {}, {}}),
      initial_gap_(target.kind == Target::Kind::tractions ? Field(scene_.grid.surface_size())
                                                          : scene_.gap(from.travel)),
      heat_(scene_, target),
      symmetry_(choose_symmetry()) {
  const bool one_for_both = twins();
  for (int b = one_for_both ? 1 : 0; b < 2; ++b) {
    if (!scene_.materials[b].is_plastic()) continue;
    Body body;
    body.index = b;
    body.copies = one_for_both ? 2 : 1;
    body.scan = scans[b].get();
    body.offset = from.placement().offset[b];
    body.history = unfolded(from.plastic[b], scene_.grid, symmetry_);
    if (body.history) {
      body.tensor = body.history->tensor();
      if (body.tensor == Tensor::full) components_ = 6;
      body.strained = true;
    }
    bodies_.push_back(std::move(body));
  }
  for (Body& body : bodies_) {
    if (body.history) {
      set_box(body, part_of(from.flow_box[body.index], scene_.grid, symmetry_));
    }
  }
}

void PlasticIncrement::set_box(Body& body, const Box& box) {
  require_memory_of(box, body.box, from_.method);
  const int parts = operators::count(body.tensor);
  const auto terms = static_cast<int>(scene_.materials[body.index].backstresses.size());
  std::vector<int> active(box.volume_size(), -1);
  PlasticFields fields = body.history ? body.history->fields(box)
                                      : PlasticFields{box, Field(parts * box.volume_size(), 0.0),
                                                      Field(box.volume_size(), 0.0),
                                                      Field(box.volume_size() * 5 * terms, 0.0)};
  // What is in the box by now includes the last guess.
  for (int c = 0; c < parts && !body.box.empty(); ++c) {
    insert(body.strain.data() + c * body.box.volume_size(), body.box,
           fields.strain.data() + c * box.volume_size(), box);
  }
  body.strain = std::move(fields.strain);
  body.equivalent = std::move(fields.equivalent);
  body.backstress = std::move(fields.backstress);
  const auto number = static_cast<std::uint8_t>(&body - bodies_.data());
  if (!body.box.empty() && !body.active.empty()) active_.move(number, body.box, box);
  for (std::size_t n = 0; n < active_.size(); ++n) {
    if (active_.cells[n].body == number) active[active_.cells[n].cell] = static_cast<int>(n);
  }
  body.active = std::move(active);
  body.box = box;
  // The old ones first: the two together may not fit.
  body.spectrum.clear();
  body.operators.reset();
  body.operators = scene_.volume(body.index, whole_box(box, scene_.grid, symmetry_), body.tensor,
                                 from_.method, symmetry_, target_.heating[body.index]);
  body.spectrum.push_back(body.operators->make_spectrum());
  body.given_stress = heat_.past_stress(body.index, box, body.tensor);
  if (!body.history) return;
  body.outside = outside_strain(scene_, body.index, *body.history, box, from_.method);
  Field& stress = body.outside.stress;
  if (body.given_stress.empty()) {
    body.given_stress = std::move(stress);
  } else {
    for (std::size_t n = 0; n < stress.size(); ++n) body.given_stress[n] += stress[n];
  }
}

void PlasticIncrement::scatter(const Field& guess) {
  const std::ptrdiff_t count = active_.size();
#pragma omp parallel for schedule(static) if (30.0 * count > worth_threads)
  for (std::ptrdiff_t n = 0; n < count; ++n) {
    const auto [b, cell] = active_.cells[n];
    Body& body = bodies_[b];
    const std::size_t cells = body.box.volume_size();
    const auto before = tensor_of(base_, n, components_), more = tensor_of(guess, n, components_);
    const auto places = operators::components(body.tensor);
    for (std::size_t c = 0; c < places.size(); ++c) {
      body.strain[c * cells + cell] = before[places[c]] + more[places[c]];
    }
  }
}

void PlasticIncrement::open(const Body& body, const Box& box, const Field& displacement,
                            Field& gap) const {
  const Grid& grid = scene_.grid;
  const Box whole = whole_box(box, grid, symmetry_);
  const auto add = [&](int to, const double* u, double part) {
    if (to < 0 || to >= grid.nx) return;
    double* row = gap.data() + static_cast<std::size_t>(to) * grid.ny;
    for (int j = whole.j0; j < whole.j0 + whole.ny; ++j) {
      const int sj = j < box.j0 ? grid.ny - 1 - j : j;
      row[j] += part * u[sj - box.j0];
    }
  };
  const double copies = body.copies, part = std::fabs(body.offset);
  const int side = body.offset > 0 ? -1 : 1;
  for (int i = whole.i0; i < whole.i0 + whole.nx; ++i) {
    const int si = i < box.i0 ? grid.nx - 1 - i : i;
    const double* u = displacement.data() + static_cast<std::size_t>(si - box.i0) * box.ny;
    add(i, u, copies * (1 - part));
    if (part > 0) add(i + side, u, copies * part);
  }
}

void PlasticIncrement::residual_displacement(Body& body, Field& gap) {
  body.rim_displacement = 0.0;
  if (target_.kind == Target::Kind::tractions) return;
  const bool mirror_x = symmetry_ == fft::Symmetry::xy, mirror_y = symmetry_ != fft::Symmetry::none;
  // Outside of the box it falls off.
  const auto largest_at_rim = [&](const Box& box, const Field& displacement, bool ends_x) {
    double largest = 0.0;
    for (int i = 0; i < box.nx; ++i) {
      for (int j = 0; j < box.ny; ++j) {
        const bool at_x = ends_x && (i == box.nx - 1 || (i == 0 && !mirror_x));
        const bool at_y = j == box.ny - 1 || (j == 0 && !mirror_y);
        if (!at_x && !at_y) continue;
        largest =
            std::max(largest, std::fabs(displacement[static_cast<std::size_t>(i) * box.ny + j]));
      }
    }
    return largest;
  };
  if (!body.outside.displacement.empty()) {
    const auto& [surface, displacement, stress] = body.outside;
    open(body, surface, displacement, gap);
    body.rim_displacement += largest_at_rim(surface, displacement, false);
  }
  if (!body.strained) return;
  Field displacement(body.box.surface_size());
  body.operators->residual_displacement().apply(body.spectrum[0], displacement.data());
  open(body, body.box, displacement, gap);
  body.rim_displacement += largest_at_rim(body.box, displacement, true);
}

void PlasticIncrement::look_from_bodies() {
  for (Body& body : bodies_) {
    if (body.offset != 0) body.seen = seen_from_body(tractions_, scene_.grid, body.offset);
  }
}

const operators::Tractions& PlasticIncrement::tractions_on(const Body& body) const {
  return body.offset != 0 ? body.seen : tractions_;
}

contact::Solution PlasticIncrement::solve_contact(const Field& gap, double tol) {
  contact::Solution solution;
  if (target_.kind == Target::Kind::tractions) {
    solution.pressure = tractions_.pressure;
    solution.load = scene_.grid.cell_area() *
                    ordered_sum(gap.size(), [&](std::size_t i) { return solution.pressure[i]; });
    solution.approach = std::numeric_limits<double>::quiet_NaN();
    look_from_bodies();
    return solution;
  }
  const auto driver = target_.kind == Target::Kind::load ? contact::Driver::load(target_.value)
                                                         : contact::Driver::approach(target_.value);
  contact::ContactSettings settings;
  settings.tol = tol;
  // An iterate may be larger than the solution: the border is checked once, at the end.
  settings.on_border = contact::OnBorder::warn;
  solution = scene_.solver(target_.heating)->solve(gap, driver, tractions_.pressure, settings);
  ++counters_.contact_solves;
  counters_.contact_iterations += solution.iterations;
  tractions_.pressure = solution.pressure;
  if (scene_.friction > 0) {
    tractions_.shear_x = solution.pressure;
    for (double& s : tractions_.shear_x) s *= scene_.friction;
  }
  look_from_bodies();
  return solution;
}

void PlasticIncrement::soften() {
  if (softened_) return;
  softened_ = true;
  for (Body& body : bodies_) {
    const Softening& law = settings_.softening[body.index];
    body.softening = heat_.softening(body.index, law, tractions_on(body).pressure);
    if (!body.softening) continue;
    body.weakest = *std::min_element(body.softening->begin(), body.softening->end());
  }
}

std::size_t PlasticIncrement::grid_cell(const Body& body, std::uint32_t cell) const {
  const Box& box = body.box;
  const std::size_t j = cell % box.ny, ki = cell / box.ny, i = ki % box.nx, k = ki / box.nx;
  const Grid& grid = scene_.grid;
  return (k * grid.nx + box.i0 + i) * grid.ny + box.j0 + j;
}

Box PlasticIncrement::contact_window(const Body& body) const {
  const Grid& grid = scene_.grid;
  const operators::Tractions& tractions = tractions_on(body);
  Box window = bounding_box(tractions.pressure, grid);
  for (const Field* shear : {&tractions.shear_x, &tractions.shear_y}) {
    if (!shear->empty()) window = window.united(bounding_box(*shear, grid));
  }
  return window;
}

bool PlasticIncrement::may_touch_outside(const Field& gap) const {
  if (gap.empty()) return false;
  const Grid& grid = scene_.grid;
  double reach = 0.0;
  for (const Body& body : bodies_) {
    reach += body.copies * body.rim_displacement;
  }
  for (const Body& body : bodies_) {
    if (body.rim_displacement == 0) continue;
    const Box whole = whole_box(body.box, grid, symmetry_);
    for (int i = 0; i < grid.nx; ++i) {
      for (int j = 0; j < grid.ny; ++j) {
        const bool inside =
            i >= whole.i0 && i < whole.i0 + whole.nx && j >= whole.j0 && j < whole.j0 + whole.ny;
        const double g = gap[static_cast<std::size_t>(i) * grid.ny + j];
        if (!inside && g < reach) return true;
      }
    }
  }
  return false;
}

bool PlasticIncrement::fit_boxes(const Field& gap) {
  const Grid& grid = scene_.grid;
  const bool touches = may_touch_outside(gap);
  bool grown = false;
  for (Body& body : bodies_) {
    const Box window = contact_window(body);
    Box needed = body.box.empty() ? Box{} : whole_box(body.box, grid, symmetry_);
    const Box now = needed;
    if (!scanned_) {
      const auto& hardening = scene_.materials[body.index].hardening;
      const double limit = near_yield * body.weakest * hardening.yield_stress(0.0);
      const Box near =
          heat_.has_past(body.index)
              ? heat_.above(body.index, tractions_on(body), from_.method, limit)
              : body.scan->box(tractions_on(body), body.index == 1 ? 1.0 : -1.0, limit);
      if (!near.empty()) needed = needed.united(near.widened(margin, grid));
    }
    if (needed.empty()) continue;
    // The stress is that of the tractions over the box: it must hold all of them.
    needed = needed.united(window);
    if (touches) needed = needed.united({0, 0, grid.nx, grid.ny, needed.nz});
    if (!now.empty() && now.contains(needed)) continue;
    set_box(body, fit(needed.united(window.widened(margin, grid)), body.box));
    grown = true;
  }
  scanned_ = true;
  return grown;
}

void PlasticIncrement::activate(std::uint8_t b, std::uint32_t cell,
                                const plasticity::Tensor& stress) {
  Body& body = bodies_[b];
  const std::size_t n = active_.size(), cells = body.box.volume_size();
  body.active[cell] = static_cast<int>(n);
  active_.cells.push_back({b, cell});
  stress_.push_back(stress);
  plasticity::Tensor before{};
  const auto places = operators::components(body.tensor);
  for (std::size_t c = 0; c < places.size(); ++c) {
    before[places[c]] = body.strain[c * cells + cell];
  }
  if (body.tensor == Tensor::deviator) before[2] = -(before[0] + before[1]);
  base_.resize((n + 1) * components_);
  put(before, base_, n, components_);
}

void PlasticIncrement::stress(std::uint8_t b, Field& guess, Result& result) {
  Body& body = bodies_[b];
  auto& spectrum = body.spectrum[0];
  if (!body.strained) std::fill(spectrum.data.begin(), spectrum.data.end(), 0.0);
  const auto& hardening = scene_.materials[body.index].hardening;
  const std::size_t plane = body.box.surface_size();
  const bool deviator = body.tensor == Tensor::deviator;
  const double first = hardening.yield_stress(0.0), bound = first * first / 3;
  const double weakest = bound * body.weakest * body.weakest;

  const bool kinematic = !body.backstress.empty();
  const auto centred = [&](std::size_t cell, std::array<double, 5> s) {
    const auto x = centre(body.backstress, body.box.volume_size(), cell);
    for (int c = 0; c < 5; ++c) s[c] -= x[c];
    return second_invariant(s);
  };

  using Found = std::pair<std::uint32_t, plasticity::Tensor>;
  std::vector<std::vector<Found>> found(body.box.nz);
  std::vector<double> largest(body.box.nz, 0.0);  // (von Mises / yield stress)^2
  const std::size_t parts = operators::count(body.tensor), cells = body.box.volume_size();
  const auto look = [&](int k, const double* layer) {
    Field sum;
    if (!body.given_stress.empty()) {
      sum.assign(layer, layer + parts * plane);
      for (std::size_t c = 0; c < parts; ++c) {
        const double* given = body.given_stress.data() + c * cells + k * plane;
        for (std::size_t i = 0; i < plane; ++i) sum[c * plane + i] += given[i];
      }
      layer = sum.data();
    }
    const double* s[6];
    double highest = 0.0;
    for (int c = 0; c < 6; ++c) s[c] = layer + (deviator ? (c < 3 ? c : c - 1) : c) * plane;
    for (std::size_t i = 0; i < plane; ++i) {
      const std::size_t cell = k * plane + i;
      double xx = s[0][i], yy = s[1][i];
      if (!deviator) {
        const double mean = (xx + yy + s[2][i]) / 3;
        xx -= mean;
        yy -= mean;
      }
      const int active = body.active[cell];
      if (active < 0) {
        const double second = kinematic ? centred(cell, {xx, yy, s[3][i], s[4][i], s[5][i]})
                                        : second_invariant({xx, yy, s[3][i], s[4][i], s[5][i]});
        double limit = bound;
        if (second > weakest && (body.softening || body.equivalent[cell] > 0)) {
          double yield_stress = hardening.yield_stress(body.equivalent[cell]);
          if (body.softening) yield_stress *= (*body.softening)[grid_cell(body, cell)];
          limit = yield_stress * yield_stress / 3;
        }
        highest = std::max(highest, second / limit);
        if (second <= limit) continue;
      }
      const plasticity::Tensor t{xx, yy, -(xx + yy), s[3][i], s[4][i], s[5][i]};
      if (active >= 0) {
        stress_[active] = t;
      } else {
        found[k].emplace_back(static_cast<std::uint32_t>(cell), t);
      }
    }
    largest[k] = highest;
  };
  const operators::Tractions here = window(tractions_on(body), scene_.grid, body.box);
  body.operators->for_each_layer(spectrum, body.strained ? body.strain.data() : nullptr, &here,
                                 body.index == 1 ? 1.0 : -1.0, look);
  for (const auto& layer : found) {
    for (const auto& [cell, t] : layer) activate(b, cell, t);
  }
  const double highest = *std::max_element(largest.begin(), largest.end());
  result.headroom = std::min(result.headroom, 1 - std::sqrt(highest));
  guess.resize(active_.size() * components_, 0.0);
}

std::span<const plasticity::Tensor> PlasticIncrement::backstresses(const Body& body,
                                                                   std::uint32_t cell,
                                                                   plasticity::Tensors& place) {
  const std::size_t cells = body.box.volume_size(), terms = body.backstress.size() / (5 * cells);
  for (std::size_t n = 0; n < terms; ++n) {
    const double* x = body.backstress.data() + 5 * n * cells + cell;
    place[n] = {x[0], x[cells], -(x[0] + x[cells]), x[2 * cells], x[3 * cells], x[4 * cells]};
  }
  return {place.data(), terms};
}

void PlasticIncrement::return_map(const Field& guess, Field& mapped, Result& result) {
  const std::ptrdiff_t count = active_.size();
  mapped.resize(count * components_);
  equivalent_.resize(count);
  double excess = 0.0, overshoot = 0.0;
  Field yield_strains(count);
#pragma omp parallel for schedule(static) \
    reduction(max : excess, overshoot) if (400.0 * count > worth_threads)
  for (std::ptrdiff_t n = 0; n < count; ++n) {
    const auto [b, cell] = active_.cells[n];
    const Body& body = bodies_[b];
    const auto& material = scene_.materials[body.index];
    const auto present = tensor_of(guess, n, components_);
    const double softening = body.softening ? (*body.softening)[grid_cell(body, cell)] : 1.0;
    plasticity::Tensors place;
    const auto r = plasticity::radial_return(stress_[n], present, body.equivalent[cell], material,
                                             backstresses(body, cell, place), softening);
    put(r.increment, mapped, n, components_);
    equivalent_[n] = r.equivalent;
    excess = std::max(excess, r.excess);
    overshoot = std::max(overshoot, r.overshoot);
    const bool flows = r.equivalent > 0 || present != plasticity::Tensor{};
    yield_strains[n] =
        flows ? material.hardening.yield_stress(0.0) / (3 * material.elastic.shear_modulus()) : 0.0;
  }
  result.excess = excess;
  result.overshoot = overshoot;
  result.yield_strain_norm =
      std::sqrt(ordered_dot(yield_strains.data(), yield_strains.data(), yield_strains.size()));
}

bool PlasticIncrement::grow_at_rim() {
  const Grid& grid = scene_.grid;
  bool grown = false;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    Body& body = bodies_[b];
    const Box box = body.box;
    const bool mirror_x = symmetry_ == fft::Symmetry::xy;
    const bool mirror_y = symmetry_ != fft::Symmetry::none;
    Box needed = box;
    for (std::size_t n = 0; n < active_.size(); ++n) {
      if (active_.cells[n].body != b || equivalent_[n] == 0) continue;
      const std::uint32_t cell = active_.cells[n].cell;
      const int j = static_cast<int>(cell % box.ny), ki = static_cast<int>(cell / box.ny);
      const int i = ki % box.nx, k = ki / box.nx;
      const bool rim = (i == 0 && !mirror_x) || (j == 0 && !mirror_y) || i == box.nx - 1 ||
                       j == box.ny - 1 || k == box.nz - 1;
      if (!rim) continue;
      needed = needed.united(Box{box.i0 + i, box.j0 + j, 1, 1, k + 1}.widened(margin, grid));
    }
    if (box.empty()) continue;
    // Widened across a mirror plane means nothing.
    const Box part = stored_part(grid, symmetry_);
    const int i1 = needed.i0 + needed.nx, j1 = needed.j0 + needed.ny;
    needed.i0 = std::max(needed.i0, part.i0);
    needed.j0 = std::max(needed.j0, part.j0);
    needed.nx = i1 - needed.i0;
    needed.ny = j1 - needed.j0;
    if (box.contains(needed)) continue;
    set_box(body, fit(whole_box(needed, grid, symmetry_), box));
    grown = true;
  }
  return grown;
}

void PlasticIncrement::flow(State& state, Body& body, std::size_t n, const Field& mapped,
                            double largest) const {
  const std::uint32_t cell = active_.cells[n].cell;
  const Box& box = body.box;
  body.equivalent[cell] += equivalent_[n];
  plasticity::Tensors place;
  std::size_t to = cell;
  const auto laws = scene_.materials[body.index].backstresses.begin();
  for (const auto& before : backstresses(body, cell, place)) {
    const auto x = plasticity::advanced(before, laws[&before - place.data()],
                                        tensor_of(mapped, n, components_), equivalent_[n]);
    for (const int c : {0, 1, 3, 4, 5}) {
      body.backstress[to] = x[c];
      to += box.volume_size();
    }
  }
  const Grid& grid = scene_.grid;
  const int j = box.j0 + static_cast<int>(cell % box.ny), ki = static_cast<int>(cell / box.ny);
  const int i = box.i0 + ki % box.nx, k = ki / box.nx;
  state.flowed[body.index] = true;
  const double share = equivalent_[n] / largest;
  if (share <= negligible_flow) return;
  // Mirror planes lie inside.
  const bool at_x = i == 0 || i == grid.nx - 1, at_y = j == 0 || j == grid.ny - 1;
  BorderFlow here;
  if (k == grid.nz - 1) {
    here.bottom = share;
  } else {
    here = {0.0, at_x ? share : 0.0, at_y ? share : 0.0};
  }
  state.border_flow[body.index] = state.border_flow[body.index].united(here);
}

Field PlasticIncrement::first_guess() {
  const auto& last = from_.last_flow;
  const Travel& by = from_.advance;
  if (!last || by == Travel{} || last->symmetry != symmetry_) return {};
  // The same way, with steps that may be longer or shorter.
  const int main = std::fabs(last->advance[0]) > std::fabs(last->advance[1]) ? 0 : 1;
  const double ratio = by[main] / last->advance[main];
  const bool same_way =
      std::fabs(by[1 - main] - ratio * last->advance[1 - main]) <= 1e-6 * std::fabs(by[main]);
  if (!same_way || !(ratio > 0 && ratio <= 2)) return {};
  const auto near = [](double a, double b) { return std::fabs(a - b) <= 0.05 * std::fabs(b); };
  if (target_.kind == Target::Kind::load && !near(target_.value, from_.load)) return {};
  if (target_.kind == Target::Kind::approach && !near(target_.value, from_.approach)) return {};

  Field guess;
  const Grid& grid = scene_.grid;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Body& body = bodies_[b];
    const auto& flow = last->bodies[body.index];
    if (flow.strain.size() != components_ * flow.cells.size()) return {};
    for (std::size_t n = 0; n < flow.cells.size(); ++n) {
      const int j = static_cast<int>(flow.cells[n] % grid.ny) - body.box.j0;
      const int i = static_cast<int>(flow.cells[n] / grid.ny % grid.nx) - body.box.i0;
      const int k = static_cast<int>(flow.cells[n] / grid.ny / grid.nx);
      if (i < 0 || i >= body.box.nx || j < 0 || j >= body.box.ny || k >= body.box.nz) continue;
      const auto cell = static_cast<std::uint32_t>((k * body.box.nx + i) * body.box.ny + j);
      activate(static_cast<std::uint8_t>(b), cell, {});
      for (int c = 0; c < components_; ++c) {
        guess.push_back(ratio * flow.strain[n * components_ + c]);
      }
    }
  }
  return guess;
}

void PlasticIncrement::remember_flow(State& state, const Field& mapped) const {
  state.last_flow = nullptr;
  if (from_.advance == Travel{}) return;
  auto flow = std::make_shared<Flow>();
  flow->symmetry = symmetry_;
  flow->advance = from_.advance;
  for (std::size_t n = 0; n < active_.size(); ++n) {
    if (equivalent_[n] == 0) continue;
    const Body& body = bodies_[active_.cells[n].body];
    auto& kept = flow->bodies[body.index];
    kept.cells.push_back(static_cast<std::uint32_t>(grid_cell(body, active_.cells[n].cell)));
    for (int c = 0; c < components_; ++c) kept.strain.push_back(mapped[n * components_ + c]);
  }
  if (flow->bodies[0].cells.empty() && flow->bodies[1].cells.empty()) return;
  state.last_flow = std::move(flow);
}

PlasticIncrement::Result PlasticIncrement::evaluate(Field& guess, double contact_tol,
                                                    Field& mapped) {
  scatter(guess);
  gap_ = initial_gap_;
  heat_.open(gap_);
  const auto transform = [](Body& body) {
    if (body.strained) {
      operators::forward(body.operators->transform(), body.strain.data(), body.spectrum[0]);
    }
  };
  for (Body& body : bodies_) {
    body.strained = body.strained || !active_.cells.empty();
    if (body.box.empty()) body.strained = false;
    transform(body);
    residual_displacement(body, gap_);
  }
  Result result;
  result.contact = solve_contact(gap_, contact_tol);
  soften();
  if (fit_boxes(result.contact.gap)) {
    result.grown =
        std::any_of(bodies_.begin(), bodies_.end(), [](const Body& body) { return body.strained; });
    for (Body& body : bodies_) transform(body);
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (!bodies_[b].box.empty()) stress(static_cast<std::uint8_t>(b), guess, result);
  }
  return_map(guess, mapped, result);
  result.grown = grow_at_rim() || result.grown;
  return result;
}

void PlasticIncrement::refine_contact(double contact_tol, Result& result) {
  result.contact = solve_contact(gap_, contact_tol);
}

State PlasticIncrement::finish(const Field& mapped, const Result& result) {
  State state = from_;
  state.warnings.clear();
  state.tractions = tractions_;
  state.heating = target_.heating;
  state.past = target_.past;
  state.past_symmetry = target_.past_symmetry;
  state.softening = {};
  for (const Body& body : bodies_) {
    state.softening[body.index] = body.softening;
    if (body.copies == 2) state.softening[0] = body.softening;
  }
  state.contact_gap.clear();
  state.load = result.contact.load;
  state.approach = result.contact.approach;
  state.flowed = {};
  state.border_flow = {};
  state.advance = {};
  remember_flow(state, mapped);
  scatter(mapped);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    Body& body = bodies_[b];
    const int i = body.index;
    // Material that past flow left at the yield stress creeps when it is unloaded, far from the
    // contact too; where that is little against what is there, the grid need not hold it.
    const auto& material = scene_.materials[i];
    double strain = material.hardening.yield_stress(0.0) / (3 * material.elastic.shear_modulus());
    if (body.history) strain = std::max(strain, body.history->max_equivalent());
    for (std::size_t n = 0; n < active_.size(); ++n) {
      if (active_.cells[n].body == b) strain = std::max(strain, equivalent_[n]);
    }
    for (std::size_t n = 0; n < active_.size(); ++n) {
      if (active_.cells[n].body == b && equivalent_[n] != 0) flow(state, body, n, mapped, strain);
    }
    if (state.flowed[i]) {
      const PlasticFields fields{body.box, std::move(body.strain), std::move(body.equivalent),
                                 std::move(body.backstress)};
      state.plastic[i] =
          std::make_shared<const PlasticState>(body.history.get(), symmetry_, body.tensor, fields);
      state.flow_box[i] = whole_box(body.box, scene_.grid, symmetry_);
    }
    if (body.copies == 1) continue;
    state.plastic[0] = state.plastic[i];
    state.flow_box[0] = state.flow_box[i];
    state.flowed[0] = state.flowed[i];
    state.border_flow[0] = state.border_flow[i];
  }
  if (target_.kind != Target::Kind::tractions) {
    Box whole = Box::whole(scene_.grid);
    const bool known = std::all_of(bodies_.begin(), bodies_.end(), [&](const Body& body) {
      whole.nz = body.box.nz;
      return !state.plastic[body.index] || whole_box(body.box, scene_.grid, symmetry_) == whole;
    });
    if (known) state.contact_gap = result.contact.gap;
  }
  return state;
}

}  // namespace samcontact::simulation
