// SPDX-License-Identifier: GPL-3.0-or-later
// Fields due to a heat history at a later time.
#include "samcontact/operators/heat/heat_history.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/errors.hpp"
#include "samcontact/base/interrupt.hpp"
#include "samcontact/operators/convolution/surface_convolution.hpp"
#include "samcontact/operators/heat/heat_decay.hpp"
#include "samcontact/operators/heat/heat_plan.hpp"
#include "samcontact/operators/heat/heating.hpp"
#include "samcontact/operators/heat/layered_heat.hpp"

namespace samcontact::operators {
namespace {

int components_of(HeatQuantity quantity) { return quantity == HeatQuantity::stress ? 6 : 1; }

}  // namespace

/// Quantities that are evaluated from the modes together.
struct HeatHistory::Moment {
  HeatQuantity quantity;
  double ahead;
  bool newest;  // whether the newest flux is in the modes
};

/// Contribution of a level to the profiles: amplitudes of its modes, weighted by the response of
/// the body.
class HeatHistory::LevelSum {
 public:
  LevelSum(const HeatHistory& history, std::size_t number, std::size_t first, const Moment& moment,
           const std::vector<double>& depths)
      : history_(history),
        moment_(moment),
        level_(history.plan_->modes.levels()[number]),
        first_(first),
        old_(history.generations_of(number, moment.ahead)),
        since_(level_, history.plan_->aged(history.duration_ + moment.ahead)),
        after_(level_, history.plan_->aged(moment.ahead)),
        during_(level_, history.newest_part(level_, moment.ahead), history.aged_speed()),
        phases_(phases_of(level_, history.moved_)),
        response_(history.plan_->response->level(number, first, moment.quantity, depths)) {}

  void add(HeatProfiles& profiles) const {
    const auto count = static_cast<std::ptrdiff_t>(level_.blocks.size());
#pragma omp parallel for schedule(dynamic)
    for (std::ptrdiff_t k = 0; k < count; ++k) {
      response_->add(level_.blocks[k], amplitudes(level_.blocks[k]), profiles);
    }
  }

 private:
  /// Amplitudes of the modes of a block, [node][mode, real and imaginary].
  LevelResponse::Matrix amplitudes(const HeatBlock& block) const {
    LevelResponse::Matrix c(block.nodes, 2 * block.count);
    for (std::size_t j = 0; j < block.nodes; ++j) {
      const std::size_t row = block.offset + j * block.count, node = block.first_node + j;
      const double rate = level_.rates[node];
      for (std::size_t n = 0; n < block.count; ++n) {
        const std::size_t mode = block.first + n;
        Complex value = 0;
        for (const Complex* kept : old_) value += kept[row + n];
        value *= since_.factor(mode, node);
        if (moment_.newest) {
          value += phases_[mode] * history_.newest_[first_ + mode] * after_.factor(mode, node) *
                   during_.integral(mode, node, rate);
        }
        c(j, 2 * n) = value.real();
        c(j, 2 * n + 1) = value.imag();
      }
    }
    return c;
  }

  const HeatHistory& history_;
  const Moment& moment_;
  const HeatLevel& level_;
  std::size_t first_;  // mode of the level
  std::vector<const Complex*> old_;
  Decay since_, after_, during_;
  ComplexField phases_;  // of the newest flux
  std::unique_ptr<LevelResponse> response_;
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

HeatProfiles HeatHistory::profiles(const Moment& moment, std::vector<double> depths) const {
  HeatProfiles profiles = plan_->response->profiles(moment.quantity, std::move(depths));
  std::size_t first = 0, number = 0;
  for (const HeatLevel& level : plan_->modes.levels()) {
    check_interrupt();
    LevelSum(*this, number++, first, moment, profiles.depths).add(profiles);
    first += level.modes.size();
  }
  return profiles;
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
void HeatHistory::evaluate(const Moment& moment, const HeatProfiles& profiles,
                           const ComplexField& near_spectra, const Into& into) const {
  const HeatPlan& plan = *plan_;
  const HeatQuantity quantity = moment.quantity;
  const std::size_t count = profiles.depths.size(), plane = flux_.size();
  std::vector<std::shared_ptr<const NearTables>> tables(count);
  for (std::size_t d = 0; d < count; ++d) {
    const double z = profiles.depths[d] / plan.grid.dx;
    if (!near_spectra.empty() && z < plan.near.depth()) {
      tables[d] = plan.tables(quantity, z);
    }
  }
  check_interrupt();
  const int components = components_of(quantity);
  const double scale = plan.response->scale(quantity);
  const auto tasks = static_cast<std::ptrdiff_t>(count) * components;
#pragma omp parallel for schedule(dynamic)
  for (std::ptrdiff_t task = 0; task < tasks; ++task) {
    const std::size_t d = task / components;
    const int c = static_cast<int>(task % components);
    const bool stress = quantity == HeatQuantity::stress;
    // No traction at the surface.
    if (stress && c >= 2 && c <= 4 && profiles.depths[d] == 0) continue;
    double* to = into(c, d);
    plan.modes.evaluate(plan.response->component(quantity, profiles, d, c).data(), to);
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
    std::copy_n(depths.begin() + d0, z.size(), z.begin());
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
    Heating heating = plan.heating;
    heating.speed_x += speed_[0] * grid.dx;
    heating.speed_y += speed_[1] * grid.dx;
    heating.age = age;
    heating.period_x = grid.period.x * grid.dx;
    heating.period_y = grid.period.y * grid.dy;
    if (quantity == HeatQuantity::displacement) {
      add(layered_heat_displacement(plan.elastic, heating, grid.dx, grid.dy, offsets), {}, sign,
          out.data());
      continue;
    }
    for (std::size_t d = 0; d < depths.size(); ++d) {
      check_interrupt();
      if (quantity == HeatQuantity::temperature) {
        add(layered_heat_temperature(heating, grid.dx, grid.dy, depths[d], offsets), {}, sign,
            out.data() + d * plane);
        continue;
      }
      auto stress =
          layered_heat_stress(plan.elastic, heating, grid.dx, grid.dy, depths[d], offsets);
      for (int c = 0; c < 6; ++c) {
        const kernels::Parity parity{c == 4 || c == 5, c == 3 || c == 5, false};
        add(std::move(stress[c]), parity, sign, out.data() + (c * depths.size() + d) * plane);
      }
    }
  }
}

}  // namespace samcontact::operators
