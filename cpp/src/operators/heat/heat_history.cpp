// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat/heat_history.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/errors.hpp"
#include "samcontact/operators/heat/heat_decay.hpp"
#include "samcontact/operators/heat/heat_plan.hpp"

namespace samcontact::operators {
namespace {

/// Minimum diffusion length in the shortest step [cells].
constexpr double min_diffusion_length = 0.02;
/// Number of values that describe the motion on a track.
constexpr std::size_t path_numbers = 10;

PlaneVector sum(const PlaneVector& a, const PlaneVector& b) { return {a[0] + b[0], a[1] + b[1]}; }

bool is_finite(const PlaneVector& v) { return std::isfinite(v[0]) && std::isfinite(v[1]); }

}  // namespace

HeatHistory::HeatHistory(const Grid& grid, const Stack& elastic, const Heating& heating,
                         const HeatHistorySettings& settings) {
  const double speed_x = heating.speed_x, speed_y = heating.speed_y;
  const auto positive = [](const char* name, double value) {
    require(std::isfinite(value) && value > 0, name, "finite and > 0", value);
  };
  positive("shortest", settings.shortest);
  require(std::isfinite(settings.longest) && settings.longest >= settings.shortest, "longest",
          "finite and >= shortest", settings.longest);
  require(settings.tolerance >= 1e-10 && settings.tolerance <= 1e-2, "tolerance",
          "in [1e-10, 1e-2]", settings.tolerance);
  require(std::isfinite(speed_x) && std::isfinite(speed_y), "speed", "finite",
          std::hypot(speed_x, speed_y));
  for (const double length : settings.track) {
    require(std::isfinite(length) && length >= 0, "track", "finite and >= 0", length);
  }
  require(!settings.follows() || (speed_x == 0 && speed_y == 0), "speed", "0 with a track",
          std::hypot(speed_x, speed_y));
  // Otherwise wavenumbers far beyond those of the cells are needed: time and memory without bounds.
  double diffusivity = heating.thermal.substrate.diffusivity;
  for (const ThermalLayer& layer : heating.thermal.layers) {
    diffusivity = std::min(diffusivity, layer.thermal.diffusivity);
  }
  const double diffused = std::sqrt(diffusivity * settings.shortest);
  const double cell = std::max(grid.dx, grid.dy);
  require(
      diffused >= min_diffusion_length * cell, "shortest (of heat_history)",
      "at least " +
          to_short_text(cell * cell * min_diffusion_length * min_diffusion_length / diffusivity) +
          " s, the time in which heat diffuses over " + to_short_text(min_diffusion_length) +
          " of a cell (cells of " + to_short_text(cell) + " m, diffusivity " +
          to_short_text(diffusivity) + " m^2/s)",
      settings.shortest);
  plan_ = std::make_shared<const HeatPlan>(grid, elastic, heating, settings);
  near_.assign(plan_->near.rates().size() * grid.surface_size(), 0.0);
  modes_.assign(plan_->modes.generations(), ComplexField(plan_->modes.size(), Complex{}));
  filled_.assign(plan_->modes.levels().size(), 0.0);
  youngest_.assign(filled_.size(), 0);
  newest_.assign(plan_->modes.mode_count(), Complex{});
  flux_.assign(grid.surface_size(), 0.0);
}

void HeatHistory::add(const double* flux, double dt, const PlaneVector& speed) {
  require(std::isfinite(dt) && dt >= 0, "dt", "finite and >= 0", dt);
  require(is_finite(speed) && (speed == PlaneVector{} || plan_->settings.follows()), "speed",
          "0 without a track", std::hypot(speed[0], speed[1]));
  if (dt == 0) return;
  ComplexField amplitudes;
  plan_->modes.project(flux, amplitudes);
  std::size_t first = 0, number = 0;
  for (const HeatLevel& level : plan_->modes.levels()) {
    absorb(level, number++, first);
    first += level.modes.size();
  }
  age_near(plan_->aged(duration_), near_);
  newest_ = std::move(amplitudes);
  flux_.assign(flux, flux + flux_.size());
  duration_ = dt;
  speed_ = {speed[0] / plan_->grid.dx, speed[1] / plan_->grid.dx};
  moved_ = {};
  extend_to({position_[0] - speed_[0] * dt, position_[1] - speed_[1] * dt});
}

void HeatHistory::move(const PlaneVector& by) {
  require(is_finite(by), "motion", "finite", std::hypot(by[0], by[1]));
  extend_to(sum(position_, by));
  position_ = sum(position_, by);
  moved_ = sum(moved_, by);
  for (const HeatLevel& level : plan_->modes.levels()) {
    const ComplexField phases = phases_of(level, by);
    for (const HeatBlock& block : level.blocks) {
      for (ComplexField& modes : modes_) {
        Complex* c = modes.data() + block.offset;
        for (std::size_t j = 0; j < block.nodes; ++j) {
          for (std::size_t n = 0; n < block.count; ++n) *c++ *= phases[block.first + n];
        }
      }
    }
  }
}

/// Extends the path of the body to a position [dx].
void HeatHistory::extend_to(const PlaneVector& position) {
  if (!plan_->settings.follows()) return;
  const double dx = plan_->grid.dx;
  PlaneVector first, last;
  for (int k = 0; k < 2; ++k) {
    first[k] = std::min(first_[k], position[k]);
    last[k] = std::max(last_[k], position[k]);
    const double length = (last[k] - first[k]) * dx, track = plan_->settings.track[k];
    require(length <= track * (1 + 1e-9), k == 0 ? "heat.track" : "heat.track along y",
            "at least the length of the path of each heated body" +
                std::string(k == 0 ? "" : " along y") + ", so far " + to_short_text(length, 6) +
                " m",
            track);
  }
  first_ = first;
  last_ = last;
}

/// Speed during the newest flux, per unit of time of the modes.
PlaneVector HeatHistory::aged_speed() const {
  const double unit = plan_->aged(1.0);
  return {speed_[0] / unit, speed_[1] / unit};
}

/// Near fields after the newest flux.
void HeatHistory::age_near(double x, Field& fields) const {
  const std::vector<double>& rates = plan_->near.rates();
  const std::size_t plane = flux_.size();
  for (std::size_t m = 0; m < rates.size(); ++m) {
    const double factor = std::exp(-rates[m] * x), integral = -std::expm1(-rates[m] * x) / rates[m];
    double* field = fields.data() + m * plane;
    for (std::size_t i = 0; i < plane; ++i) field[i] = field[i] * factor + flux_[i] * integral;
  }
}

/// Ages a level by the duration of the newest flux, and adds that flux.
void HeatHistory::absorb(const HeatLevel& level, std::size_t number, std::size_t first_mode) {
  const int generations = plan_->modes.generations();
  double left = plan_->aged(duration_);
  // Heat older than all generations is dropped at once.
  const double kept = std::min(left, generations * level.generation);
  const ComplexField phases = phases_of(level, moved_);
  const auto age = [&](double x) {
    const Decay decay(level, x);
    const Decay since = speed_ == PlaneVector{} ? decay : Decay(level, x, aged_speed());
    for (int g = 0; g < generations; ++g) {
      const bool adds = g == youngest_[number];
      for (const HeatBlock& block : level.blocks) {
        for (std::size_t j = 0; j < block.nodes; ++j) {
          Complex* c = modes_[g].data() + block.offset + j * block.count;
          const std::size_t node = block.first_node + j;
          const double rate = level.rates[node];
          for (std::size_t n = 0; n < block.count; ++n) {
            const std::size_t mode = block.first + n;
            c[n] *= decay.factor(mode, node);
            if (!adds) continue;
            c[n] += phases[mode] * newest_[first_mode + mode] * since.integral(mode, node, rate);
          }
        }
      }
    }
  };
  const auto clear = [&](int g) {
    const HeatBlock &front = level.blocks.front(), &back = level.blocks.back();
    std::fill(modes_[g].begin() + front.offset,
              modes_[g].begin() + back.offset + back.count * back.nodes, Complex{});
  };
  if (level.blocks.empty()) return;
  if (kept < left) {
    for (int g = 0; g < generations; ++g) clear(g);
    filled_[number] = 0;
    left = kept;
  }
  while (left > 0) {
    if (filled_[number] >= level.generation) {
      youngest_[number] = (youngest_[number] + 1) % generations;
      clear(youngest_[number]);
      filled_[number] = 0;
    }
    const double room = level.generation - filled_[number];
    const bool fills = left >= room;
    const double x = fills ? room : left;
    age(x);
    filled_[number] = fills ? level.generation : filled_[number] + x;
    left = fills ? left - x : 0;
  }
}

bool HeatHistory::newest_by_modes(double ahead) const {
  // Tables require a uniform motion since the beginning of the newest flux.
  constexpr double rounding = 1e-6;
  return ahead >= plan_->settings.shortest * (1 - 1e-12) ||
         std::abs(moved_[0] - speed_[0] * ahead) > rounding ||
         std::abs(moved_[1] - speed_[1] * ahead) > rounding;
}

Field HeatHistory::temperature(double ahead, std::span<const double> depths) const {
  return fields(HeatQuantity::temperature, ahead, depths);
}

Field HeatHistory::displacement(double ahead) const {
  const double surface = 0;
  return fields(HeatQuantity::displacement, ahead, {&surface, 1});
}

Field HeatHistory::stress(double ahead, std::span<const double> depths) const {
  return fields(HeatQuantity::stress, ahead, depths);
}

std::size_t HeatHistory::size() const {
  return 2 * (modes_.size() * plan_->modes.size() + newest_.size()) + flux_.size() + near_.size() +
         1 + 2 * filled_.size() + (plan_->settings.follows() ? path_numbers : 0);
}

std::vector<double> HeatHistory::state() const {
  std::vector<double> state{duration_};
  state.insert(state.end(), flux_.begin(), flux_.end());
  state.insert(state.end(), near_.begin(), near_.end());
  state.insert(state.end(), filled_.begin(), filled_.end());
  state.insert(state.end(), youngest_.begin(), youngest_.end());
  for (const ComplexField& modes : modes_) {
    const auto* numbers = reinterpret_cast<const double*>(modes.data());
    state.insert(state.end(), numbers, numbers + 2 * modes.size());
  }
  if (plan_->settings.follows()) {
    for (const PlaneVector& part : {speed_, moved_, position_, first_, last_}) {
      state.insert(state.end(), part.begin(), part.end());
    }
  }
  return state;
}

void HeatHistory::set_state(std::span<const double> state) {
  const std::size_t plane = flux_.size(), levels = filled_.size();
  const int generations = plan_->modes.generations();
  const std::size_t path = plan_->settings.follows() ? path_numbers : 0;
  const std::size_t size =
      1 + plane + near_.size() + 2 * levels + 2 * plan_->modes.size() * generations + path;
  require(state.size() == size, "number of values in the heat state", std::to_string(size),
          static_cast<double>(state.size()),
          "use a state of a heat history with the same grid, body and settings");
  const double* from = state.data() + 1;
  const auto take = [&](auto to, std::size_t count) {
    std::copy(from, from + count, to);
    from += count;
  };
  duration_ = state[0];
  take(flux_.begin(), plane);
  take(near_.begin(), near_.size());
  take(filled_.begin(), levels);
  for (int& youngest : youngest_)
    youngest = std::clamp(static_cast<int>(*from++), 0, generations - 1);
  for (ComplexField& modes : modes_)
    take(reinterpret_cast<double*>(modes.data()), 2 * modes.size());
  plan_->modes.project(flux_.data(), newest_);
  if (path == 0) return;
  for (PlaneVector* part : {&speed_, &moved_, &position_, &first_, &last_}) {
    for (double& value : *part) value = *from++;
  }
}

}  // namespace samcontact::operators
