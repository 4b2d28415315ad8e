// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat_history.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>

#include "samcontact/base/errors.hpp"
#include "samcontact/base/interrupt.hpp"
#include "samcontact/operators/heat_near.hpp"
#include "samcontact/operators/heat_symbols.hpp"
#include "samcontact/operators/heating.hpp"
#include "samcontact/operators/surface_convolution.hpp"

namespace samcontact::operators {
namespace {

/// How far heat must diffuse in the shortest step, in cells.
constexpr double least_diffused = 0.02;

/// 1 - exp(-z) without cancellation.
Complex grown(Complex z) {
  const double e = std::exp(-z.real()), half = std::sin(z.imag() / 2);
  return {-std::expm1(-z.real()) + 2 * e * half * half, e * std::sin(z.imag())};
}

using RealMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// exp(-lambda x) and (1 - exp(-lambda x))/lambda, lambda = decay + s^2, as products of what
/// depends on the mode and on s.
class Decay {
 public:
  Decay(const HeatLevel& level, double x) : s_(level.s.size()), grown_s_(level.s.size()) {
    modes_.reserve(level.modes.size());
    grown_.reserve(level.modes.size());
    for (const HeatMode& mode : level.modes) {
      modes_.push_back(std::exp(-mode.decay * x));
      grown_.push_back(grown(mode.decay * x));
    }
    for (std::size_t j = 0; j < s_.size(); ++j) {
      const double y = level.s[j] * level.s[j] * x;
      s_[j] = std::exp(-y);
      grown_s_[j] = -std::expm1(-y);
    }
    x_ = x;
  }
  Complex factor(std::size_t mode, std::size_t j) const { return modes_[mode] * s_[j]; }
  Complex integral(std::size_t mode, std::size_t j, Complex lambda) const {
    if (lambda == 0.0) return x_;
    return (grown_[mode] + modes_[mode] * grown_s_[j]) / lambda;
  }

 private:
  std::vector<Complex> modes_, grown_;
  std::vector<double> s_, grown_s_;
  double x_;
};

}  // namespace

struct HeatHistory::Plan {
  Plan(const Grid& grid_, const Thermal& thermal_, const Elastic& elastic_, double vx, double vy,
       const HeatHistorySettings& settings_)
      : grid(grid_),
        thermal(thermal_),
        elastic(elastic_),
        speed_x(vx),
        speed_y(vy),
        settings(settings_),
        modes(grid, vx * grid.dx / thermal.diffusivity, vy * grid.dx / thermal.diffusivity,
              {aged(settings.shortest), aged(settings.longest), settings.tolerance,
               settings.in_depth}),
        near(modes) {}

  Grid grid;
  Thermal thermal;
  Elastic elastic;
  double speed_x, speed_y;
  HeatHistorySettings settings;
  HeatModes modes;
  NearHeat near;

  double aged(double time) const { return thermal.diffusivity * time / (grid.dx * grid.dx); }

  /// Tables of a depth (over dx), kept: a simulation asks for the same depths at every step.
  std::shared_ptr<const NearTables> tables(Quantity quantity, double z) const {
    const std::lock_guard lock(mutex);
    const std::pair key(static_cast<int>(quantity), z);
    if (const auto found = kept.find(key); found != kept.end()) return found->second;
    constexpr std::size_t most = 128;
    if (kept.size() >= most) kept.clear();
    auto made = std::make_shared<const NearTables>(
        quantity == Quantity::temperature    ? near.temperature(z)
        : quantity == Quantity::displacement ? near.displacement()
                                             : near.stress(z, elastic.nu));
    return kept[key] = std::move(made);
  }

 private:
  mutable std::mutex mutex;
  mutable std::map<std::pair<int, double>, std::shared_ptr<const NearTables>> kept;
};

HeatHistory::HeatHistory(const Grid& grid, const Thermal& thermal, const Elastic& elastic,
                         double speed_x, double speed_y, const HeatHistorySettings& settings) {
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
  // Else wavenumbers far beyond those of the cells are followed: time and memory without bounds.
  const double diffused = std::sqrt(thermal.diffusivity * settings.shortest);
  const double cell = std::max(grid.dx, grid.dy);
  require(diffused >= least_diffused * cell, "shortest (of heat_history)",
          "long enough for heat to diffuse over " + to_short_text(least_diffused) + " of a cell, " +
              to_short_text(cell * cell * least_diffused * least_diffused / thermal.diffusivity) +
              " s with cells of " + to_short_text(cell) + " m and a diffusivity of " +
              to_short_text(thermal.diffusivity) + " m^2/s",
          settings.shortest);
  plan_ = std::make_shared<const Plan>(grid, thermal, elastic, speed_x, speed_y, settings);
  near_.assign(plan_->near.rates().size() * grid.surface_size(), 0.0);
  modes_.assign(plan_->modes.generations(), ComplexField(plan_->modes.size(), Complex{}));
  filled_.assign(plan_->modes.levels().size(), 0.0);
  youngest_.assign(filled_.size(), 0);
  newest_.assign(plan_->modes.mode_count(), Complex{});
  flux_.assign(grid.surface_size(), 0.0);
}

void HeatHistory::add(const double* flux, double dt) {
  require(std::isfinite(dt) && dt >= 0, "dt", "finite and >= 0", dt);
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

/// Lets a level age by the newest flux's duration, and adds that flux.
void HeatHistory::absorb(const HeatLevel& level, std::size_t number, std::size_t first_mode) {
  const int generations = plan_->modes.generations();
  double left = plan_->aged(duration_);
  // What is older than all generations is dropped at once.
  const double kept = std::min(left, generations * level.generation);
  const auto age = [&](double x) {
    const Decay decay(level, x);
    for (int g = 0; g < generations; ++g) {
      const bool adds = g == youngest_[number];
      for (const HeatBlock& block : level.blocks) {
        for (std::size_t j = 0; j < block.nodes; ++j) {
          Complex* c = modes_[g].data() + block.offset + j * block.count;
          const double s2 = level.s[j] * level.s[j];
          for (std::size_t n = 0; n < block.count; ++n) {
            const std::size_t mode = block.first + n;
            c[n] *= decay.factor(mode, j);
            if (!adds) continue;
            c[n] +=
                newest_[first_mode + mode] * decay.integral(mode, j, level.modes[mode].decay + s2);
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
  return ahead >= plan_->settings.shortest * (1 - 1e-12);
}

Field HeatHistory::temperature(double ahead, std::span<const double> depths) const {
  return fields(Quantity::temperature, ahead, depths);
}

Field HeatHistory::displacement(double ahead) const {
  const double surface = 0;
  return fields(Quantity::displacement, ahead, {&surface, 1});
}

Field HeatHistory::stress(double ahead, std::span<const double> depths) const {
  return fields(Quantity::stress, ahead, depths);
}

Field HeatHistory::fields(Quantity quantity, double ahead, std::span<const double> depths) const {
  require(std::isfinite(ahead) && ahead >= 0, "ahead", "finite and >= 0", ahead);
  const Plan& plan = *plan_;
  const HeatModes& modes = plan.modes;
  for (const double z : depths) {
    require(std::isfinite(z) && z >= 0, "depth", "finite and >= 0", z);
    require(plan.settings.in_depth || z == 0, "depth", "0 without in_depth", z);
  }
  const bool newest = newest_by_modes(ahead) && duration_ > 0;
  const std::size_t plane = plan.grid.surface_size(), total = modes.mode_count();
  const int components = quantity == Quantity::stress ? 6 : 1;
  Field out(components * depths.size() * plane, 0.0);

  ComplexField near_spectra;
  if (!near_.empty()) {
    Field fields = near_;
    double age = plan.aged(ahead);
    if (newest) {
      age_near(plan.aged(duration_), fields);
    } else {
      age += plan.aged(duration_);
    }
    near_spectra = plan.near.spectra(fields, age);
  }

  // Profiles of some depths at a time, so that their memory stays small.
  constexpr std::size_t most = 1 << 20;
  const std::size_t together = std::clamp<std::size_t>(most / total, 1, depths.size() + 1);
  for (std::size_t d0 = 0; d0 < depths.size(); d0 += together) {
    const std::size_t count = std::min(together, depths.size() - d0);
    std::vector<double> z(count);
    for (std::size_t d = 0; d < count; ++d) z[d] = depths[d0 + d] / plan.grid.dx;
    ComplexField t(count * total), p, slope, base(total);
    if (quantity == Quantity::stress) {
      p.resize(count * total);
      slope.resize(count * total);
    }
    std::size_t first = 0, number = 0;
    for (const HeatLevel& level : modes.levels()) {
      check_interrupt();
      // Generations that are still near, and how much of the newest flux is.
      const double later = plan.aged(ahead), all = plan.aged(duration_ + ahead);
      const double limit = (modes.generations() - 1) * level.generation;
      std::vector<const Complex*> near;
      for (int g = 0; g < modes.generations(); ++g) {
        const int older = (youngest_[number] - g + modes.generations()) % modes.generations();
        const double youngest = older == 0 ? 0 : filled_[number] + (older - 1) * level.generation;
        if (modes.generations() == 1 || youngest + all < limit) near.push_back(modes_[g].data());
      }
      ++number;
      const double part =
          modes.generations() == 1 ? all - later : std::max(std::min(all, limit) - later, 0.0);
      const Decay since(level, all), after(level, later), during(level, part);
      const std::size_t nodes = level.s.size();
      // Rows of sums over s: T or P of each depth, slope of each depth, P(0).
      RealMatrix cosines(count + 1, nodes), sines(count, nodes);
      for (std::size_t j = 0; j < nodes; ++j) {
        for (std::size_t d = 0; d < count; ++d) {
          const double sz = level.s[j] * z[d], weight = level.weight[j] * modes.fade(sz);
          cosines(d, j) = z[d] == 0 ? level.weight[j] : weight * std::cos(sz);
          sines(d, j) = -weight * level.s[j] * std::sin(sz);
        }
        cosines(count, j) = level.weight[j];
      }
      const auto block_count = static_cast<std::ptrdiff_t>(level.blocks.size());
#pragma omp parallel for schedule(dynamic)
      for (std::ptrdiff_t k = 0; k < block_count; ++k) {
        const HeatBlock& block = level.blocks[k];
        RealMatrix c(block.nodes, 2 * block.count), over(block.nodes, 2 * block.count);
        for (std::size_t j = 0; j < block.nodes; ++j) {
          const std::size_t row = block.offset + j * block.count;
          const double s2 = level.s[j] * level.s[j];
          for (std::size_t n = 0; n < block.count; ++n) {
            const HeatMode& mode = level.modes[block.first + n];
            Complex value = 0;
            for (const Complex* kept : near) value += kept[row + n];
            value *= since.factor(block.first + n, j);
            if (newest) {
              value += newest_[first + block.first + n] * after.factor(block.first + n, j) *
                       during.integral(block.first + n, j, mode.decay + s2);
            }
            const double k2 = mode.w * mode.w + s2, inverse = mode.w > 0 ? 1 / k2 : 0;
            c(j, 2 * n) = value.real();
            c(j, 2 * n + 1) = value.imag();
            over(j, 2 * n) = inverse * value.real();
            over(j, 2 * n + 1) = inverse * value.imag();
          }
        }
        const auto store = [&](const RealMatrix& sums, std::size_t d, Complex* into) {
          for (std::size_t n = 0; n < block.count; ++n) {
            into[first + block.first + n] = {sums(d, 2 * n), sums(d, 2 * n + 1)};
          }
        };
        const auto used = static_cast<Eigen::Index>(block.nodes);
        if (quantity != Quantity::displacement) {
          const RealMatrix sums = cosines.topRows(count).leftCols(used) * c;
          for (std::size_t d = 0; d < count; ++d) store(sums, d, t.data() + d * total);
        }
        if (quantity == Quantity::temperature) continue;
        const RealMatrix sums = cosines.leftCols(used) * over;
        store(sums, count, base.data());
        for (std::size_t n = 0; n < block.count; ++n) {
          const HeatMode& mode = level.modes[block.first + n];
          Complex& b = base[first + block.first + n];
          // The limit of w P(0) at w = 0 is the heat itself.
          b = mode.w > 0 ? mode.w * b : Complex(c(0, 2 * n), c(0, 2 * n + 1));
        }
        if (quantity == Quantity::displacement) continue;
        for (std::size_t d = 0; d < count; ++d) store(sums, d, p.data() + d * total);
        const RealMatrix slopes = sines.leftCols(used) * over;
        for (std::size_t d = 0; d < count; ++d) store(slopes, d, slope.data() + d * total);
      }
      first += level.modes.size();
    }

    std::vector<std::shared_ptr<const NearTables>> tables(count);
    for (std::size_t d = 0; d < count; ++d) {
      if (!near_spectra.empty() && z[d] < plan.near.depth()) {
        tables[d] = plan.tables(quantity, z[d]);
      }
    }
    check_interrupt();
    const double nu = plan.elastic.nu, k = plan.thermal.conductivity, dx = plan.grid.dx;
    const double alpha = plan.thermal.expansion;
    double scale = dx / k;
    if (quantity == Quantity::displacement) scale = -2 * alpha * (1 + nu) / k * dx * dx;
    if (quantity == Quantity::stress) scale = plan.elastic.E * alpha / (1 - nu) / k * dx;
    const auto tasks = static_cast<std::ptrdiff_t>(count) * components;
#pragma omp parallel for schedule(dynamic)
    for (std::ptrdiff_t task = 0; task < tasks; ++task) {
      const std::size_t d = task / components;
      const int component = static_cast<int>(task % components);
      const bool free = component >= 2 && component <= 4;  // no traction at the surface
      if (quantity == Quantity::stress && free && z[d] == 0) continue;
      ComplexField values(total);
      std::size_t n = 0;
      for (const HeatLevel& level : modes.levels()) {
        for (const HeatMode& mode : level.modes) {
          if (quantity == Quantity::temperature) {
            values[n] = t[d * total + n];
          } else if (quantity == Quantity::displacement) {
            values[n] = base[n];
          } else {
            const ThermalProfile<Complex> at{t[d * total + n], p[d * total + n],
                                             slope[d * total + n], base[n]};
            const Complex v =
                heat_stress_symbol(component, plan.elastic.nu, z[d], mode.w1, mode.w2, at);
            values[n] = component == 3 || component == 4 ? Complex{v.imag(), -v.real()} : v;
          }
          ++n;
        }
      }
      double* to = out.data() + (component * depths.size() + d0 + d) * plane;
      modes.evaluate(values.data(), to);
      if (tables[d]) {
        const bool shear = quantity == Quantity::stress;
        plan.near.add(tables[d]->components[component], shear && (component == 4 || component == 5),
                      shear && (component == 3 || component == 5), near_spectra, to);
      }
      for (std::size_t i = 0; i < plane; ++i) to[i] *= scale;
    }
    check_interrupt();
  }
  if (!newest && duration_ > 0) add_newest(quantity, ahead, depths, out);
  return out;
}

/// The newest flux by tables: since it began, less since it ended.
void HeatHistory::add_newest(Quantity quantity, double ahead, std::span<const double> depths,
                             Field& out) const {
  const Plan& plan = *plan_;
  const Grid& grid = plan.grid;
  const SurfaceConvolution convolution(grid);
  const Offsets offsets = Offsets::lattice(grid.dx, grid.dy, grid.nx, grid.ny);
  const std::size_t plane = grid.surface_size();
  ComplexField work;
  Field part(plane);
  const auto add = [&](ParityParts parts, kernels::Parity parity, double sign, double* to) {
    std::vector<ParityKernel> kernels;
    for (int flip = 0; flip < 4; ++flip) {
      if (parts[flip].empty()) continue;
      kernels.push_back(
          {{parity.odd_x != ((flip & 1) != 0), parity.odd_y != ((flip & 2) != 0), parity.odd_z},
           std::move(parts[flip])});
      convolution.transform(kernels.back());
    }
    if (kernels.empty()) return;
    convolution.apply(kernels, flux_.data(), part.data(), work);
    for (std::size_t i = 0; i < plane; ++i) to[i] += sign * part[i];
  };
  for (const double age : {ahead + duration_, ahead}) {
    if (age == 0) continue;
    const double sign = age == ahead ? -1 : 1;
    const Heating heating{1.0, plan.thermal, plan.speed_x, plan.speed_y, age};
    if (quantity == Quantity::displacement) {
      add(heat_displacement(heating, plan.elastic.nu, grid.dx, grid.dy, offsets), {}, sign,
          out.data());
      continue;
    }
    for (std::size_t d = 0; d < depths.size(); ++d) {
      check_interrupt();
      if (quantity == Quantity::temperature) {
        add(heat_temperature(heating, grid.dx, grid.dy, depths[d], offsets), {}, sign,
            out.data() + d * plane);
        continue;
      }
      auto stress = heat_stress(heating, plan.elastic, grid.dx, grid.dy, depths[d], offsets);
      for (int c = 0; c < 6; ++c) {
        const kernels::Parity parity{c == 4 || c == 5, c == 3 || c == 5, false};
        add(std::move(stress[c]), parity, sign, out.data() + (c * depths.size() + d) * plane);
      }
    }
  }
}

std::size_t HeatHistory::size() const {
  return 2 * (modes_.size() * plan_->modes.size() + newest_.size()) + flux_.size() + near_.size() +
         1 + 2 * filled_.size();
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
  return state;
}

void HeatHistory::set_state(std::span<const double> state) {
  const std::size_t plane = flux_.size(), levels = filled_.size();
  const int generations = plan_->modes.generations();
  if (state.size() !=
      1 + plane + near_.size() + 2 * levels + 2 * plan_->modes.size() * generations) {
    throw std::invalid_argument("the state of the heat belongs to another history");
  }
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
}

}  // namespace samcontact::operators
