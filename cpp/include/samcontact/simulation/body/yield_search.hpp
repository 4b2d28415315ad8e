// SPDX-License-Identifier: GPL-3.0-or-later
// Search for cells of a body in which the stress due to tractions and sources comes close to the
// yield stress.
#pragma once

#include <optional>
#include <utility>

#include "samcontact/simulation/setup/yield_scan.hpp"
#include "samcontact/simulation/sources/sources.hpp"

namespace samcontact::simulation {

class YieldSearch {
 public:
  /// heating: proportional to the pressure. strength: of the body in the increment.
  YieldSearch(const Setup& setup, int body, operators::Heating heating, Strength strength)
      : setup_(setup), body_(body), heating_(std::move(heating)), strength_(std::move(strength)) {}

  /// Sets the minimum factor of the yield stress due to softening.
  void soften(double weakest) { weakest_ = weakest; }
  // Tractions are those on the body, on its own cells.

  /// Box of all cells in which tractions and sources alone come close to yield.
  Box near_yield(const operators::Tractions& tractions, const YieldScan& scan,
                 const Sources& sources) const;
  /// Columns of the cells that yield.
  const Columns& yielding_columns(const operators::Tractions& tractions, const YieldScan& scan,
                                  const Sources& sources);
  /// Box of all cells below those of the grid that yield due to tractions and sources alone; for a
  /// body with weak layers below, of all cells close to yield.
  Box yield_below(const operators::Tractions& tractions, const YieldScan& scan,
                  const Sources& sources) const;
  /// Whether the body yields down to any depth.
  bool yields_everywhere(const operators::Tractions& tractions, const YieldScan& scan) const;

 private:
  /// Columns in which tractions exceed a limit.
  struct Yielding {
    operators::Tractions tractions;
    double softening;
    Columns columns;
  };

  double sign() const { return operators::shear_sign(body_); }
  Columns columns_beyond(const operators::Tractions& tractions, const YieldLimit& limit,
                         const YieldScan& scan) const;

  const Setup& setup_;
  int body_;
  operators::Heating heating_;
  Strength strength_;
  double weakest_ = 1.0;
  std::optional<Yielding> yielding_;  // result of the last search
};

}  // namespace samcontact::simulation
