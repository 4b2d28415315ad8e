// SPDX-License-Identifier: GPL-3.0-or-later
// Temperature, displacement and stress of a body due to its heat history, for a flux that was
// constant during each time step. Neither memory nor work depend on the number of steps.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/base/stack.hpp"
#include "samcontact/operators/heat/heat_modes.hpp"
#include "samcontact/operators/heat/heat_response.hpp"

namespace samcontact::operators {

struct HeatHistorySettings {
  /// Shortest `ahead`, usually the shortest time step [s]; flux may be added over any time. Fields
  /// at an earlier time contain the newest flux through tables, and are correct if this flux was
  /// added over at least this time.
  double shortest = 0.0;
  /// Time for which heat is taken into account [s]. After it, errors of displacement and stress
  /// grow slowly.
  double longest = 0.0;
  double tolerance = 1e-6;  // approximate, relative to the largest value
  bool in_depth = true;     // false: only the surface displacement and fields at z = 0
  /// Longest distances along x and y between two positions of a body that move() moves along a path
  /// that may turn [m]; such a body has no constant speed. 0: it moves at constant speed, or not at
  /// all.
  PlaneVector track{};
  bool follows() const { return track != PlaneVector{}; }
};

struct Heating;
struct HeatPlan;

/// Copies share the constant data.
class HeatHistory {
 public:
  /// heating: thermal constants of the body, and its speed through the grid.
  HeatHistory(const Grid& grid, const Stack& elastic, const Heating& heating,
              const HeatHistorySettings& settings);

  /// Advances the time by dt [s], with the flux [i][j] into the body [W/m^2]. speed: with a track,
  /// speed along x and y at which move() has just moved the body in this time [m/s].
  void add(const double* flux, double dt, const PlaneVector& speed = {});
  /// Moves the body, with its heat, along x and y [dx]. Throws std::invalid_argument beyond the
  /// track.
  void move(const PlaneVector& by);

  // Fields `ahead` seconds after the present time, without heat flux until then.

  /// Temperature rise [depth][i][j] [K].
  Field temperature(double ahead, std::span<const double> depths) const;
  /// u_z of the surface [i][j] [m], positive into the body, zero at infinity.
  Field displacement(double ahead) const;
  /// Stress [component][depth][i][j] [Pa], components xx, yy, zz, yz, xz, xy.
  Field stress(double ahead, std::span<const double> depths) const;

  /// Data that add() changes; set_state() accepts the result of state() of an equal history.
  std::vector<double> state() const;
  void set_state(std::span<const double> state);
  /// Size of a copy in numbers of 8 bytes.
  std::size_t size() const;

 private:
  struct Moment;
  class LevelSum;
  Field fields(HeatQuantity quantity, double ahead, std::span<const double> depths) const;
  void add_newest(HeatQuantity quantity, double ahead, std::span<const double> depths,
                  Field& out) const;
  bool newest_by_modes(double ahead) const;
  void extend_to(const PlaneVector& position);
  PlaneVector aged_speed() const;
  std::vector<const Complex*> generations_of(std::size_t number, double ahead) const;
  double newest_part(const HeatLevel& level, double ahead) const;
  HeatProfiles profiles(const Moment& moment, std::vector<double> depths) const;
  ComplexField near_spectra(const Moment& moment) const;
  template <class Into>
  void evaluate(const Moment& moment, const HeatProfiles& profiles,
                const ComplexField& near_spectra, const Into& into) const;
  void age_near(double x, Field& fields) const;
  void absorb(const HeatLevel& level, std::size_t number, std::size_t first_mode);

  std::shared_ptr<const HeatPlan> plan_;

  /// Modes of all heat before the newest flux, by generation.
  std::vector<ComplexField> modes_;
  std::vector<double> filled_;  // time collected in the youngest generation of a level
  std::vector<int> youngest_;   // generation of a level
  Field near_;                  // fields of NearHeat, [rate][i][j]
  ComplexField newest_;         // amplitudes of the newest flux
  Field flux_;                  // the newest flux, constant over the time
  double duration_ = 0;         // [s]

  // With a track: speed of the body during the newest flux [dx/s], its motion since then, its
  // position, and the ends of its path along x and y [dx].
  PlaneVector speed_{}, moved_{}, position_{}, first_{}, last_{};
};

}  // namespace samcontact::operators
