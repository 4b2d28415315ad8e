// SPDX-License-Identifier: GPL-3.0-or-later
// What the heat of the past does to a half-space: temperature, displacement and stress at a later
// moment, for a flux that was constant during each time step. Neither memory nor work depend on the
// number of steps.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/elastic.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/base/thermal.hpp"
#include "samcontact/operators/heat/heat_modes.hpp"

namespace samcontact::operators {

struct HeatHistorySettings {
  /// Shortest `ahead`, commonly the shortest time step [s]; flux may be added over any time. Fields
  /// at an earlier moment take the newest flux from tables, and are right if it was added over at
  /// least this time.
  double shortest = 0.0;
  /// How long heat is followed [s]. Errors of displacement and stress grow slowly beyond.
  double longest = 0.0;
  double tolerance = 1e-6;  // roughly, relative to the largest value
  bool in_depth = true;     // false: only the surface's displacement and fields at z = 0
};

enum class HeatQuantity { temperature, displacement, stress };
struct HeatPlan;

/// Copies share what does not change.
class HeatHistory {
 public:
  /// The body moves through the grid with (speed_x, speed_y) [m/s].
  HeatHistory(const Grid& grid, const Thermal& thermal, const Elastic& elastic, double speed_x,
              double speed_y, const HeatHistorySettings& settings);

  /// The clock advances by dt [s], with the flux [i][j] into the body [W/m^2].
  void add(const double* flux, double dt);

  // Fields `ahead` seconds from now, if no heat enters until then.

  /// Rise of temperature [depth][i][j] [K].
  Field temperature(double ahead, std::span<const double> depths) const;
  /// u_z of the surface [i][j] [m], positive into the body, zero at infinity.
  Field displacement(double ahead) const;
  /// Stress [component][depth][i][j] [Pa], components xx, yy, zz, yz, xz, xy.
  Field stress(double ahead, std::span<const double> depths) const;

  /// What add() changes; set_state() takes what state() of an equal history gave.
  std::vector<double> state() const;
  void set_state(std::span<const double> state);
  /// Numbers of 8 bytes that a copy owns.
  std::size_t size() const;

 private:
  struct Moment;
  struct Profiles;
  class LevelSum;
  Field fields(HeatQuantity quantity, double ahead, std::span<const double> depths) const;
  void add_newest(HeatQuantity quantity, double ahead, std::span<const double> depths,
                  Field& out) const;
  bool newest_by_modes(double ahead) const;
  std::vector<const Complex*> generations_of(std::size_t number, double ahead) const;
  double newest_part(const HeatLevel& level, double ahead) const;
  Profiles profiles(const Moment& moment, std::vector<double> z) const;
  ComplexField component(const Moment& moment, const Profiles& profiles, std::size_t d,
                         int component) const;
  ComplexField near_spectra(const Moment& moment) const;
  template <class Into>
  void evaluate(const Moment& moment, const Profiles& profiles, const ComplexField& near_spectra,
                const Into& into) const;
  void age_near(double x, Field& fields) const;
  void absorb(const HeatLevel& level, std::size_t number, std::size_t first_mode);

  std::shared_ptr<const HeatPlan> plan_;

  /// Of all heat before the newest flux, by generation.
  std::vector<ComplexField> modes_;
  std::vector<double> filled_;  // time collected in a level's youngest generation
  std::vector<int> youngest_;   // of a level
  Field near_;                  // fields of NearHeat, [rate][i][j]
  ComplexField newest_;         // amplitudes of the newest flux
  Field flux_;                  // the newest flux, constant over the time
  double duration_ = 0;         // [s]
};

}  // namespace samcontact::operators
