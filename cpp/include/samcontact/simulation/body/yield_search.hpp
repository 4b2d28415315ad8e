// SPDX-License-Identifier: GPL-3.0-or-later
// Where the stress of tractions and sources comes near the yield stress of a body.
#pragma once

#include <optional>
#include <utility>

#include "samcontact/simulation/scene/yield_scan.hpp"
#include "samcontact/simulation/sources/sources.hpp"

namespace samcontact::simulation {

class YieldSearch {
 public:
  /// heating: that goes with the pressure. strength: of the body in the increment.
  YieldSearch(const Scene& scene, int body, const operators::Heating& heating, Strength strength)
      : scene_(scene), body_(body), heating_(heating), strength_(std::move(strength)) {}

  /// The least factor of the yield stress by softening.
  void soften(double weakest) { weakest_ = weakest; }
  // Tractions are those that act on the body, in its own cells.

  /// The box of all cells where tractions and sources alone come near yielding.
  Box near_yield(const operators::Tractions& tractions, const YieldScan& scan,
                 const Sources& sources) const;
  /// The columns of those that yield.
  const Columns& yielding_columns(const operators::Tractions& tractions, const YieldScan& scan,
                                  const Sources& sources);
  /// The box of all cells below those of the grid where these alone make it yield; of a body that
  /// is weak somewhere below, of all cells where they come near.
  Box yield_below(const operators::Tractions& tractions, const YieldScan& scan,
                  const Sources& sources) const;
  /// Whether it yields down to any depth.
  bool yields_everywhere(const operators::Tractions& tractions, const YieldScan& scan) const;

 private:
  /// The columns where some tractions go beyond a limit.
  struct Yielding {
    operators::Tractions tractions;
    double softening;
    Columns columns;
  };

  double sign() const { return operators::shear_sign(body_); }
  Columns columns_beyond(const operators::Tractions& tractions, const YieldLimit& limit,
                         const YieldScan& scan) const;

  const Scene& scene_;
  int body_;
  operators::Heating heating_;
  Strength strength_;
  double weakest_ = 1.0;
  std::optional<Yielding> yielding_;  // as last looked for
};

}  // namespace samcontact::simulation
