// SPDX-License-Identifier: GPL-3.0-or-later
// Fields due to a heat history at a later time.
#include "samcontact/operators/heat/heat_history.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "samcontact/base/errors.hpp"
#include "samcontact/base/interrupt.hpp"
#include "samcontact/operators/convolution/surface_convolution.hpp"
#include "samcontact/operators/heat/heat_decay.hpp"
#include "samcontact/operators/heat/heat_plan.hpp"
#include "samcontact/operators/heat/heat_symbols.hpp"
#include "samcontact/operators/heat/heating.hpp"

namespace samcontact::operators {
namespace {

using RealMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

int components_of(HeatQuantity quantity) { return quantity == HeatQuantity::stress ? 6 : 1; }

}  // namespace

/// Quantities that are evaluated from the modes together.
struct HeatHistory::Moment {
  HeatQuantity quantity;
  double ahead;
  bool newest;  // whether the newest flux is in the modes
};

/// Sums over the wavenumbers s along the depth, [depth][mode]; empty where not needed: temperature,
/// and potential with its slope; the potential at the surface [mode], times w.
struct HeatHistory::Profiles {
  std::vector<double> z;  // over dx
  ComplexField temperature, potential, slope, surface;
};

/// Contribution of a level to the profiles: amplitudes of its modes times weights over s.
class HeatHistory::LevelSum {
 public:
  LevelSum(const HeatHistory& history, std::size_t number, std::size_t first, const Moment& moment,
           const std::vector<double>& z)
      : history_(history),
        moment_(moment),
        level_(history.plan_->modes.levels()[number]),
        first_(first),
        old_(history.generations_of(number, moment.ahead)),
        since_(level_, history.plan_->aged(history.duration_ + moment.ahead)),
        after_(level_, history.plan_->aged(moment.ahead)),
        during_(level_, history.newest_part(level_, moment.ahead),
                history.speed_ / history.plan_->aged(1.0)),
        phases_(phases_of(level_, history.moved_)),
        cosines_(z.size() + 1, level_.s.size()),
        sines_(z.size(), level_.s.size()) {
    // Rows: T or P of each depth, slope of each depth, P(0).
    for (std::size_t j = 0; j < level_.s.size(); ++j) {
      for (std::size_t d = 0; d < z.size(); ++d) {
        const double sz = level_.s[j] * z[d];
        const double weight = level_.weight[j] * history.plan_->modes.scales().fade(sz);
        cosines_(d, j) = z[d] == 0 ? level_.weight[j] : weight * std::cos(sz);
        sines_(d, j) = -weight * level_.s[j] * std::sin(sz);
      }
      cosines_(z.size(), j) = level_.weight[j];
    }
  }

  void add(Profiles& profiles) const {
    const auto count = static_cast<std::ptrdiff_t>(level_.blocks.size());
#pragma omp parallel for schedule(dynamic)
    for (std::ptrdiff_t k = 0; k < count; ++k) add(level_.blocks[k], profiles);
  }

 private:
  void add(const HeatBlock& block, Profiles& profiles) const {
    RealMatrix c(block.nodes, 2 * block.count), over(block.nodes, 2 * block.count);
    amplitudes(block, c, over);
    const auto used = static_cast<Eigen::Index>(block.nodes);
    const std::size_t depths = profiles.z.size();
    if (moment_.quantity != HeatQuantity::displacement) {
      const RealMatrix sums = cosines_.topRows(depths).leftCols(used) * c;
      store(block, sums, depths, profiles.temperature);
    }
    if (moment_.quantity == HeatQuantity::temperature) return;
    const RealMatrix sums = cosines_.leftCols(used) * over;
    for (std::size_t n = 0; n < block.count; ++n) {
      const double w = level_.modes[block.first + n].w;
      const Complex at_surface(sums(depths, 2 * n), sums(depths, 2 * n + 1));
      // The limit of w P(0) at w = 0 is the heat itself.
      profiles.surface[first_ + block.first + n] =
          w > 0 ? w * at_surface
                : history_.plan_->mean_share() * Complex(c(0, 2 * n), c(0, 2 * n + 1));
    }
    if (moment_.quantity == HeatQuantity::displacement) return;
    store(block, sums, depths, profiles.potential);
    const RealMatrix slopes = sines_.leftCols(used) * over;
    store(block, slopes, depths, profiles.slope);
  }

  /// Amplitudes of the modes of a block, [s][mode, real and imaginary], and amplitudes over k^2.
  void amplitudes(const HeatBlock& block, RealMatrix& c, RealMatrix& over) const {
    for (std::size_t j = 0; j < block.nodes; ++j) {
      const std::size_t row = block.offset + j * block.count;
      const double s2 = level_.s[j] * level_.s[j];
      for (std::size_t n = 0; n < block.count; ++n) {
        const HeatMode& mode = level_.modes[block.first + n];
        Complex value = 0;
        for (const Complex* kept : old_) value += kept[row + n];
        value *= since_.factor(block.first + n, j);
        if (moment_.newest) {
          value += phases_[block.first + n] * history_.newest_[first_ + block.first + n] *
                   after_.factor(block.first + n, j) * during_.integral(block.first + n, j, s2);
        }
        const double k2 = mode.w * mode.w + s2, inverse = mode.w > 0 ? 1 / k2 : 0;
        c(j, 2 * n) = value.real();
        c(j, 2 * n + 1) = value.imag();
        over(j, 2 * n) = inverse * value.real();
        over(j, 2 * n + 1) = inverse * value.imag();
      }
    }
  }

  void store(const HeatBlock& block, const RealMatrix& sums, std::size_t depths,
             ComplexField& into) const {
    const std::size_t total = history_.plan_->modes.mode_count();
    for (std::size_t d = 0; d < depths; ++d) {
      for (std::size_t n = 0; n < block.count; ++n) {
        into[d * total + first_ + block.first + n] = {sums(d, 2 * n), sums(d, 2 * n + 1)};
      }
    }
  }

  const HeatHistory& history_;
  const Moment& moment_;
  const HeatLevel& level_;
  std::size_t first_;  // mode of the level
  std::vector<const Complex*> old_;
  Decay since_, after_, during_;
  ComplexField phases_;  // of the newest flux
  RealMatrix cosines_, sines_;
};

/// Generations of a level that are not left to the near fields.
std::vector<const Complex*> HeatHistory::generations_of(std::size_t number, double ahead) const {
  const int generations = plan_->modes.generations();
  const HeatLevel& level = plan_->modes.levels()[number];
  const double all = plan_->aged(duration_ + ahead);
  const double limit = (generations - 1) * level.generation;
  std::vector<const Complex*> chosen;
  for (int g = 0; g < generations; ++g) {
    const int older = (youngest_[number] - g + generations) % generations;
    const double youngest = older == 0 ? 0 : filled_[number] + (older - 1) * level.generation;
    if (generations == 1 || youngest + all < limit) chosen.push_back(modes_[g].data());
  }
  return chosen;
}

/// Fraction of the duration of the newest flux that is not left to the near fields.
double HeatHistory::newest_part(const HeatLevel& level, double ahead) const {
  const int generations = plan_->modes.generations();
  const double later = plan_->aged(ahead), all = plan_->aged(duration_ + ahead);
  const double limit = (generations - 1) * level.generation;
  return generations == 1 ? all - later : std::max(std::min(all, limit) - later, 0.0);
}

HeatHistory::Profiles HeatHistory::profiles(const Moment& moment, std::vector<double> z) const {
  const std::size_t total = plan_->modes.mode_count(), count = z.size() * total;
  Profiles profiles{std::move(z), ComplexField(count), {}, {}, ComplexField(total)};
  if (moment.quantity == HeatQuantity::stress) {
    profiles.potential.resize(count);
    profiles.slope.resize(count);
  }
  std::size_t first = 0, number = 0;
  for (const HeatLevel& level : plan_->modes.levels()) {
    check_interrupt();
    LevelSum(*this, number++, first, moment, profiles.z).add(profiles);
    first += level.modes.size();
  }
  return profiles;
}

/// Amplitudes of the modes of a component at depth d.
ComplexField HeatHistory::component(const Moment& moment, const Profiles& profiles, std::size_t d,
                                    int component) const {
  const std::size_t total = plan_->modes.mode_count();
  if (moment.quantity == HeatQuantity::displacement) return profiles.surface;
  if (moment.quantity == HeatQuantity::temperature) {
    const Complex* first = profiles.temperature.data() + d * total;
    return ComplexField(first, first + total);
  }
  ComplexField values(total);
  std::size_t n = 0;
  for (const HeatLevel& level : plan_->modes.levels()) {
    for (const HeatMode& mode : level.modes) {
      const std::size_t at = d * total + n;
      const ThermalProfile<Complex> profile{profiles.temperature[at], profiles.potential[at],
                                            profiles.slope[at], profiles.surface[n]};
      const Complex v = heat_stress_symbol(component, plan_->elastic.nu, profiles.z[d], mode.w1,
                                           mode.w2, profile);
      values[n++] = component == 3 || component == 4 ? Complex{v.imag(), -v.real()} : v;
    }
  }
  return values;
}

/// Spectra of the near heat.
ComplexField HeatHistory::near_spectra(const Moment& moment) const {
  if (near_.empty()) return {};
  Field fields = near_;
  double age = plan_->aged(moment.ahead);
  if (moment.newest) {
    age_near(plan_->aged(duration_), fields);
  } else {
    age += plan_->aged(duration_);
  }
  return plan_->near.spectra(fields, age);
}

/// Evaluates modes and near fields on the grid: `into(component, d)` is the plane at depth d.
template <class Into>
void HeatHistory::evaluate(const Moment& moment, const Profiles& profiles,
                           const ComplexField& near_spectra, const Into& into) const {
  const HeatPlan& plan = *plan_;
  const HeatQuantity quantity = moment.quantity;
  const std::size_t count = profiles.z.size(), plane = flux_.size();
  std::vector<std::shared_ptr<const NearTables>> tables(count);
  for (std::size_t d = 0; d < count; ++d) {
    if (!near_spectra.empty() && profiles.z[d] < plan.near.depth()) {
      tables[d] = plan.tables(quantity, profiles.z[d]);
    }
  }
  check_interrupt();
  const int components = components_of(quantity);
  const double scale = plan.scale(quantity);
  const auto tasks = static_cast<std::ptrdiff_t>(count) * components;
#pragma omp parallel for schedule(dynamic)
  for (std::ptrdiff_t task = 0; task < tasks; ++task) {
    const std::size_t d = task / components;
    const int c = static_cast<int>(task % components);
    const bool stress = quantity == HeatQuantity::stress;
    // No traction at the surface.
    if (stress && c >= 2 && c <= 4 && profiles.z[d] == 0) continue;
    double* to = into(c, d);
    plan.modes.evaluate(component(moment, profiles, d, c).data(), to);
    if (tables[d]) {
      plan.near.add(tables[d]->components[c], stress && (c == 4 || c == 5),
                    stress && (c == 3 || c == 5), near_spectra, to);
    }
    for (std::size_t i = 0; i < plane; ++i) to[i] *= scale;
  }
  check_interrupt();
}

Field HeatHistory::fields(HeatQuantity quantity, double ahead,
                          std::span<const double> depths) const {
  require(std::isfinite(ahead) && ahead >= 0, "ahead", "finite and >= 0", ahead);
  const HeatPlan& plan = *plan_;
  for (const double z : depths) {
    require(std::isfinite(z) && z >= 0, "depth", "finite and >= 0", z);
    require(plan.settings.in_depth || z == 0, "depth", "0 without in_depth", z);
  }
  const Moment moment{quantity, ahead, newest_by_modes(ahead) && duration_ > 0};
  const std::size_t plane = flux_.size();
  Field out(components_of(quantity) * depths.size() * plane, 0.0);
  const ComplexField near = near_spectra(moment);
  // Profiles of some depths at a time, to limit their memory.
  constexpr std::size_t max_numbers = 1 << 20;
  const std::size_t together =
      std::clamp<std::size_t>(max_numbers / plan.modes.mode_count(), 1, depths.size() + 1);
  for (std::size_t d0 = 0; d0 < depths.size(); d0 += together) {
    std::vector<double> z(std::min(together, depths.size() - d0));
    for (std::size_t d = 0; d < z.size(); ++d) z[d] = depths[d0 + d] / plan.grid.dx;
    evaluate(moment, profiles(moment, std::move(z)), near, [&](int component, std::size_t d) {
      return out.data() + (component * depths.size() + d0 + d) * plane;
    });
  }
  if (!moment.newest && duration_ > 0 && !is_zero(flux_)) add_newest(quantity, ahead, depths, out);
  return out;
}

/// The newest flux by tables: heat since its beginning, less heat since its end.
void HeatHistory::add_newest(HeatQuantity quantity, double ahead, std::span<const double> depths,
                             Field& out) const {
  const HeatPlan& plan = *plan_;
  const Grid& grid = plan.grid;
  const SurfaceConvolution convolution(grid);
  const auto [nx, ny] = convolution.offsets();
  const Offsets offsets = Offsets::lattice(grid.dx, grid.dy, nx, ny);
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
    Heating heating{1.0, {{}, plan.thermal}, plan.speed_x + speed_ * grid.dx, plan.speed_y, age};
    heating.period_x = grid.period.x * grid.dx;
    heating.period_y = grid.period.y * grid.dy;
    if (quantity == HeatQuantity::displacement) {
      add(heat_displacement(heating, plan.elastic.nu, grid.dx, grid.dy, offsets), {}, sign,
          out.data());
      continue;
    }
    for (std::size_t d = 0; d < depths.size(); ++d) {
      check_interrupt();
      if (quantity == HeatQuantity::temperature) {
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

}  // namespace samcontact::operators
