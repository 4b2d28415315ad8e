// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "samcontact/base/threads.hpp"
#include "samcontact/operators/surface_displacement.hpp"
#include "samcontact/operators/temperature.hpp"
#include "samcontact/plasticity/return_mapping.hpp"

namespace samcontact::simulation {
namespace {

using operators::Tensor;

/// scalar[i] = f(tensor of cell i).
template <class F>
Field reduce_tensor(const Field& tensor, const F& f) {
  const std::ptrdiff_t n = tensor.size() / 6;
  Field scalar(n);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    scalar[i] = f(plasticity::Tensor{tensor[i], tensor[n + i], tensor[2 * n + i], tensor[3 * n + i],
                                     tensor[4 * n + i], tensor[5 * n + i]});
  }
  return scalar;
}

void add(const Field& from, Field& to) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += from[i];
}

/// All six components of the deviator of n cells.
void complete(const double* deviator, std::size_t n, double* full) {
  int place = 0;
  for (const int c : operators::components(Tensor::deviator)) {
    std::copy_n(deviator + place++ * n, n, full + c * n);
  }
  for (std::size_t i = 0; i < n; ++i) full[2 * n + i] = -(full[i] + full[n + i]);
}

/// All six components of the plastic strain in its box.
Field six_components(const PlasticState& plastic) {
  if (plastic.tensor == Tensor::full) return plastic.strain;
  const std::size_t n = plastic.box.volume_size();
  Field full(6 * n);
  complete(plastic.strain.data(), n, full.data());
  return full;
}

/// Components of a field of the box placed into the whole volume, zero elsewhere.
Field embed(const Field& field, const Box& box, const Grid& grid, int components) {
  const Box whole = Box::whole(grid);
  if (box == whole) return field;
  Field out(components * grid.volume_size(), 0.0);
  for (int c = 0; c < components; ++c) {
    insert(field.data() + c * box.volume_size(), box, out.data() + c * grid.volume_size(), whole);
  }
  return out;
}

/// One plane, given from the mirror planes on, in a box with fewer of them.
void unfold(const double* from, const Box& stored, fft::Symmetry had, bool odd_x, bool odd_y,
            double* to, const Box& box, const Grid& grid) {
  for (int i = 0; i < box.nx; ++i) {
    for (int j = 0; j < box.ny; ++j) {
      int gi = box.i0 + i, gj = box.j0 + j;
      bool negative = false;
      if (gi < stored.i0 && had == fft::Symmetry::xy) {
        gi = grid.nx - 1 - gi;
        negative = odd_x;
      }
      if (gj < stored.j0) {
        gj = grid.ny - 1 - gj;
        negative = negative != odd_y;
      }
      const double value =
          from[static_cast<std::size_t>(gi - stored.i0) * stored.ny + (gj - stored.j0)];
      to[static_cast<std::size_t>(i) * box.ny + j] = negative ? -value : value;
    }
  }
}

}  // namespace

bool same(const std::shared_ptr<const PlasticState>& a,
          const std::shared_ptr<const PlasticState>& b) {
  return a == b || (a && b && *a == *b);
}

std::shared_ptr<const PlasticState> unfolded(const std::shared_ptr<const PlasticState>& history,
                                             const Grid& grid, fft::Symmetry symmetry) {
  if (!history || history->symmetry == symmetry) return history;
  auto out = std::make_shared<PlasticState>();
  out->symmetry = symmetry;
  out->tensor = history->tensor;
  Box whole = whole_box(history->box, grid, history->symmetry);
  // From the planes that remain on.
  const Box part = stored_part(grid, symmetry);
  if (symmetry != fft::Symmetry::none) {
    whole.ny -= part.j0 - whole.j0;
    whole.j0 = part.j0;
  }
  out->box = whole;
  const auto places = operators::components(out->tensor);
  const std::size_t from = history->box.surface_size(), to = whole.surface_size();
  const std::size_t layers = whole.nz;
  out->strain.resize(places.size() * layers * to);
  out->equivalent.resize(layers * to);
  const std::size_t terms = history->backstress.size() / (5 * layers * from);
  out->backstress.resize(5 * terms * layers * to);
  const auto copy = [&](const Field& old, Field& young, std::size_t plane, bool odd_x, bool odd_y) {
    unfold(old.data() + plane * from, history->box, history->symmetry, odd_x, odd_y,
           young.data() + plane * to, whole, grid);
  };
  for (std::size_t k = 0; k < layers; ++k) {
    copy(history->equivalent, out->equivalent, k, false, false);
    for (std::size_t c = 0; c < places.size(); ++c) {
      const bool odd_x = places[c] == 4 || places[c] == 5, odd_y = places[c] == 3 || places[c] == 5;
      copy(history->strain, out->strain, c * layers + k, odd_x, odd_y);
    }
    const auto five = operators::components(Tensor::deviator);
    for (std::size_t c = 0; c < 5 * terms; ++c) {
      const int place = five[c % 5];
      copy(history->backstress, out->backstress, c * layers + k, place == 4 || place == 5,
           place == 3 || place == 5);
    }
  }
  return out;
}

operators::Tractions window(const operators::Tractions& tractions, const Grid& grid,
                            const Box& box) {
  const Box surface = Box::surface(grid);
  Box part = box;
  part.nz = 1;
  if (part == surface) return tractions;
  operators::Tractions out;
  const auto cut = [&](const Field& from, Field& to) {
    if (from.empty()) return;
    to.resize(box.surface_size());
    extract(from.data(), surface, to.data(), part);
  };
  cut(tractions.pressure, out.pressure);
  cut(tractions.shear_x, out.shear_x);
  cut(tractions.shear_y, out.shear_y);
  return out;
}

State::State(std::shared_ptr<const Scene> scene, operators::ResidualMethod method_)
    : method(method_), scene_(std::move(scene)) {
  tractions.pressure.assign(scene_->grid.surface_size(), 0.0);
  approach = *std::min_element(scene_->initial_gap.begin(), scene_->initial_gap.end());
}

PastHeat State::heat_so_far() const {
  PastHeat so_far = past;
  if (!scene_->march.is_on() || time == 0) return so_far;
  for (int b = 0; b < 2; ++b) {
    if (b == 1 && heating[0] == heating[1] && past[0] == past[1] &&
        scene_->materials[0].elastic == scene_->materials[1].elastic) {
      so_far[1] = so_far[0];
      continue;
    }
    if (!past[b] && !heating[b].is_on()) continue;
    auto history = std::make_shared<operators::HeatHistory>(
        past[b] ? *past[b] : scene_->heat_history(b, heating[b]));
    Field flux = tractions.pressure;
    for (double& q : flux) q *= heating[b].factor;
    history->add(flux.data(), heating[b].time);
    so_far[b] = std::move(history);
  }
  return so_far;
}

fft::Symmetry State::heat_symmetry_so_far() const {
  if (!heating[0].is_on() && !heating[1].is_on()) return past_symmetry;
  const fft::Symmetry flux = symmetry_of(tractions.pressure, scene_->grid);
  return common(past_symmetry, common(flux, symmetry_of(heating)));
}

Field State::gap() const {
  if (!contact_gap.empty()) return contact_gap;
  Field gap = scene_->initial_gap;
  const double moved = std::isfinite(approach) ? approach : 0.0;
  for (double& g : gap) g -= moved;
  for (int body = 0; body < 2; ++body) {
    const Field u = surface_displacement(body);
    for (std::size_t i = 0; i < gap.size(); ++i) gap[i] += u[i];
  }
  return gap;
}

Field State::total_stress(int body, bool with_tractions) const {
  const Grid& grid = scene_->grid;
  scene_->require_volume(body);
  const double sign = body == 1 ? 1.0 : -1.0;
  const Box whole = Box::whole(grid);
  if (!plastic[body] && !with_tractions) return Field(6 * grid.volume_size(), 0.0);
  const operators::Heating heat = with_tractions ? heating[body] : operators::Heating{};

  // In the box the very stress that the flow was computed with: the fast operator depends a little
  // on period and mirrors.
  const bool exact = method == operators::ResidualMethod::exact;
  auto symmetry = fft::Symmetry::none;
  if (plastic[body] && !exact) {
    symmetry = plastic[body]->symmetry;
    if (with_tractions) {
      symmetry = common(symmetry, symmetry_of(tractions, grid));
      symmetry = common(symmetry, past_symmetry);
      symmetry = common(symmetry, symmetry_of(heating));
    }
  }
  const auto history = unfolded(plastic[body], grid, symmetry);
  const Box box = history ? whole_box(history->box, grid, symmetry) : Box{};

  Field out;
  if (exact || box != whole) {
    const auto all = unfolded(history, grid, fft::Symmetry::none);
    const Field strain = all ? embed(six_components(*all), box, grid, 6) : Field{};
    out = scene_->volume(body, whole, Tensor::full, method, fft::Symmetry::none, heat)
              ->stress(all ? strain.data() : nullptr, with_tractions ? &tractions : nullptr, sign);
    if (!history || exact) return out;
  } else {
    out.resize(6 * grid.volume_size());
  }
  const auto operators = scene_->volume(body, box, Tensor::full, method, symmetry, heat);
  const operators::Tractions here = window(tractions, grid, history->box);
  const Field part =
      operators->stress(six_components(*history).data(), with_tractions ? &here : nullptr, sign);
  Field plane(box.surface_size());
  Box layer = box, surface = Box::surface(grid);
  layer.nz = 1;
  for (int c = 0; c < 6; ++c) {
    for (int k = 0; k < box.nz; ++k) {
      unfold(part.data() + (c * box.nz + k) * history->box.surface_size(), history->box, symmetry,
             c == 4 || c == 5, c == 3 || c == 5, plane.data(), box, grid);
      insert(plane.data(), layer, out.data() + (c * grid.nz + k) * grid.surface_size(), surface);
    }
  }
  return out;
}

Field State::stress(int body) const {
  Field stress = total_stress(body, true);
  if (past[body]) add(past[body]->stress(heating[body].time, scene_->grid.z()), stress);
  return stress;
}

Field State::residual_stress(int body) const { return total_stress(body, false); }

Field State::von_mises(int body) const {
  return reduce_tensor(stress(body), plasticity::von_mises);
}

Field State::hydrostatic(int body) const {
  return reduce_tensor(stress(body),
                       [](const plasticity::Tensor& s) { return (s[0] + s[1] + s[2]) / 3; });
}

Field State::plastic_strain(int body) const {
  scene_->require_volume(body);
  if (!plastic[body]) return Field(6 * scene_->grid.volume_size(), 0.0);
  const auto history = unfolded(plastic[body], scene_->grid, fft::Symmetry::none);
  return embed(six_components(*history), history->box, scene_->grid, 6);
}

Field State::equivalent_plastic_strain(int body) const {
  scene_->require_volume(body);
  if (!plastic[body]) return Field(scene_->grid.volume_size(), 0.0);
  const auto history = unfolded(plastic[body], scene_->grid, fft::Symmetry::none);
  return embed(history->equivalent, history->box, scene_->grid, 1);
}

double State::max_equivalent_plastic_strain(int body) const {
  const auto& history = plastic[body];
  return history ? *std::max_element(history->equivalent.begin(), history->equivalent.end()) : 0.0;
}

double State::max_plastic_strain(int body) const {
  const auto& history = plastic[body];
  if (!history) return 0.0;
  const bool full = history->tensor == Tensor::full;
  const std::ptrdiff_t n = history->box.volume_size();
  const double* e = history->strain.data();
  double largest = 0.0;
#pragma omp parallel for schedule(static) reduction(max : largest) if (10.0 * n > worth_threads)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const double xx = e[i], yy = e[n + i], zz = full ? e[2 * n + i] : -(xx + yy);
    const double* shear = e + (full ? 3 : 2) * n + i;
    largest = std::max(
        largest, xx * xx + yy * yy + zz * zz +
                     2 * (shear[0] * shear[0] + shear[n] * shear[n] + shear[2 * n] * shear[2 * n]));
  }
  return std::sqrt(2.0 / 3 * largest);
}

Field State::backstress(int body) const {
  const Grid& grid = scene_->grid;
  scene_->require_volume(body);
  const std::size_t terms = scene_->materials[body].backstresses.size();
  Field out(6 * terms * grid.volume_size(), 0.0);
  const auto history = unfolded(plastic[body], grid, fft::Symmetry::none);
  if (!history) return out;
  const std::size_t cells = history->box.volume_size();
  Field full(6 * terms * cells);
  for (std::size_t n = 0; n < terms; ++n) {
    complete(history->backstress.data() + 5 * n * cells, cells, full.data() + 6 * n * cells);
  }
  return embed(full, history->box, grid, static_cast<int>(6 * terms));
}

Field State::residual_displacement(int body) const {
  const Grid& grid = scene_->grid;
  Field out(grid.surface_size(), 0.0);
  if (!plastic[body]) return out;
  const auto whole_history = unfolded(plastic[body], grid, fft::Symmetry::none);
  const PlasticState& history = *whole_history;
  Box wide = Box::whole(grid);
  wide.nz = history.box.nz;
  const auto operators =
      scene_->volume(body, wide, history.tensor, method, fft::Symmetry::none, {});
  operators::VolumeSpectrum spectrum = operators->make_spectrum();
  const int parts = operators::count(history.tensor);
  operators::forward(operators->transform(),
                     embed(history.strain, history.box, wide.grid(grid), parts).data(), spectrum);
  operators->residual_displacement().apply(spectrum, out.data());
  return out;
}

Field State::surface_displacement(int body) const {
  Field out = residual_displacement(body);
  const Elastic& elastic = scene_->materials[body].elastic;
  if (elastic.is_rigid()) return out;
  const auto pointer = [](const Field& f) { return f.empty() ? nullptr : f.data(); };
  operators::SurfaceInfluence influence(elastic.normal_compliance());
  influence.add(heating[body], elastic.nu);
  const Field loaded = operators::surface_displacement(
      scene_->grid, influence, (body == 1 ? 1.0 : -1.0) * elastic.coupling_compliance(),
      pointer(tractions.pressure), pointer(tractions.shear_x), pointer(tractions.shear_y));
  add(loaded, out);
  if (past[body]) add(past[body]->displacement(heating[body].time), out);
  return out;
}

Field State::temperature(int body) const {
  scene_->require_volume(body);
  Field rise = scene_->temperature(heating[body])->rise(tractions.pressure.data());
  if (past[body]) add(past[body]->temperature(heating[body].time, scene_->grid.z()), rise);
  return rise;
}

Field State::surface_temperature(int body) const {
  const std::array surface{0.0};
  Field rise =
      operators::Temperature(scene_->grid, heating[body], surface).rise(tractions.pressure.data());
  if (past[body]) add(past[body]->temperature(heating[body].time, surface), rise);
  return rise;
}

}  // namespace samcontact::simulation
