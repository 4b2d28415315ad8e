// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/sources/sources.hpp"

#include <algorithm>
#include <optional>

#include "samcontact/simulation/sources/heat_source.hpp"

namespace samcontact::simulation {
namespace {

/// The undeformed surfaces.
class Undeformed : public Source {
 public:
  Undeformed(const Setup& setup, const Travel& travel) : setup_(setup), travel_(travel) {}

  bool acts_on(int /*body*/) const override { return false; }
  bool remains() const override { return true; }
  void separate(Field& gap) const override {
    if (gap_.empty()) gap_ = setup_.gap(travel_);
    for (std::size_t i = 0; i < gap.size(); ++i) gap[i] += gap_[i];
  }

 private:
  const Setup& setup_;
  Travel travel_;
  mutable Field gap_;  // empty until first used
};

/// Initial stress of the bodies. It depends on depth only, and the search for yield obtains it from
/// their strength.
class InitialStress : public Source {
 public:
  InitialStress(const Setup& setup, const Travel& travel) : setup_(setup), travel_(travel) {}

  bool acts_on(int body) const override { return setup_.bodies[body].has_initial_stress(); }
  bool remains() const override { return true; }
  void stress(int body, const Box& box, operators::Tensor tensor, Field& sum) const override {
    if (!acts_on(body)) return;
    auto& strength = strength_[body];
    if (!strength) strength.emplace(setup_.strength(body, travel_));
    strength->add_stress(box, tensor, sum);
  }

 private:
  const Setup& setup_;
  Travel travel_;
  mutable std::array<std::optional<Strength>, 2> strength_;
};

/// Displacement of viscoelastic bodies that past tractions still cause. It has no stress: the
/// stress in these bodies is that of the present tractions.
class Remembered : public Source {
 public:
  Remembered(const Setup& setup, std::array<TrackTractions, 2> tractions)
      : setup_(setup), tractions_(std::move(tractions)) {}

  bool acts_on(int body) const override { return !tractions_[body].empty(); }
  bool remains() const override { return true; }
  fft::Symmetry symmetry() const override { return common(symmetry_of(0), symmetry_of(1)); }
  void displace(int body, Field& sum) const override {
    if (!acts_on(body)) return;
    Field& own = displacement_[body];
    if (own.empty()) {
      own = displacement(tractions_[body], RelaxingBody(setup_, body), operators::normal_axis);
    }
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += own[i];
  }

 private:
  /// A track outside the grid lies on one side of the contact.
  fft::Symmetry symmetry_of(int body) const {
    const auto& [box, tractions] = tractions_[body];
    if (tractions.pressure.empty()) return fft::Symmetry::xy;
    Grid wide = setup_.grid;
    wide.nx = box.nx;
    const fft::Symmetry own = simulation::symmetry_of(tractions, wide);
    return wide.nx == setup_.grid.nx ? own : common(own, fft::Symmetry::y);
  }

  const Setup& setup_;
  std::array<TrackTractions, 2> tractions_;
  mutable std::array<Field, 2> displacement_;  // empty until first used
};

}  // namespace

Sources::Sources(const Setup& setup, const Travel& travel, const std::array<GivenHeat, 2>& heat,
                 const Eigenstrains& eigenstrains, operators::ResidualMethod method,
                 std::array<TrackTractions, 2> memory) {
  all_.push_back(std::make_unique<Undeformed>(setup, travel));
  all_.push_back(std::make_unique<HeatSource>(setup.grid, heat, setup.placement(travel).offset));
  all_.push_back(std::make_unique<InitialStress>(setup, travel));
  all_.push_back(std::make_unique<Eigenstrain>(setup, travel, method, eigenstrains));
  if (!memory[0].empty() || !memory[1].empty()) {
    all_.push_back(std::make_unique<Remembered>(setup, std::move(memory)));
  }
}

bool Sources::all_remain(int body) const {
  return std::none_of(all_.begin(), all_.end(), [body](const auto& source) {
    return source->acts_on(body) && !source->remains();
  });
}

fft::Symmetry Sources::symmetry() const {
  fft::Symmetry symmetry = fft::Symmetry::xy;
  for (const auto& source : all_) symmetry = common(symmetry, source->symmetry());
  return symmetry;
}

bool Sources::all_smooth(int body) const {
  return std::none_of(all_.begin(), all_.end(), [body](const auto& source) {
    return source->acts_on(body) && !source->is_smooth();
  });
}

void Sources::separate(Field& gap) const {
  for (const auto& source : all_) source->separate(gap);
}

void Sources::displace(int body, Field& sum) const {
  for (const auto& source : all_) source->displace(body, sum);
}

void Sources::stress(int body, const Box& box, operators::Tensor tensor, Field& sum) const {
  for (const auto& source : all_) source->stress(body, box, tensor, sum);
}

void Sources::residual_stress(int body, const Box& box, operators::Tensor tensor,
                              Field& sum) const {
  for (const auto& source : all_) {
    if (source->remains()) source->stress(body, box, tensor, sum);
  }
}

Box Sources::box_beyond(int body, const Strength& strength, double softening, double share) const {
  Box found;
  for (const auto& source : all_) {
    found = found.united(source->box_beyond(body, strength, softening, share));
  }
  return found;
}

operators::DeviatorAt Sources::deviator(int body) const {
  std::vector<operators::DeviatorAt> parts;
  for (const auto& source : all_) {
    if (auto part = source->deviator(body)) parts.push_back(std::move(part));
  }
  if (parts.size() < 2) return parts.empty() ? operators::DeviatorAt{} : std::move(parts.front());
  return [parts](std::span<const double> depths) {
    Field sum;
    for (const auto& part : parts) add_to(sum, part(depths));
    return sum;
  };
}

}  // namespace samcontact::simulation
