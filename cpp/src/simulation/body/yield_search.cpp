// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/body/yield_search.hpp"

#include <algorithm>

namespace samcontact::simulation {
namespace {

/// Cells with elastic stress above this fraction of the yield stress belong to the box. A larger
/// margin is needed for a weak layer below the zone of plastic flow and apart from it: no flow in
/// the outermost cells indicates its yield.
constexpr double near = 0.9, near_weak = 0.7;
/// Counterpart of near_weak for zones and for layers below the grid, which need to contain only
/// cells that yield.
constexpr double beyond_weak = 0.8;

/// Number of surface cells above which a bound of the stress is used to find yield.
constexpr std::size_t large_surface = 65000;

}  // namespace

Box YieldSearch::near_yield(const operators::Tractions& tractions, const YieldScan& scan,
                            const Sources& sources) const {
  const YieldLimit limit{strength_, weakest_, near, near_weak, sources.deviator(body_)};
  // If stress unknown to the scan is smaller than the rest, the scan finds the cells that may
  // yield.
  return scan.box(tractions, sign(), limit)
      .united(sources.box_beyond(body_, strength_, weakest_, 1 - near));
}

Box YieldSearch::yield_below(const operators::Tractions& tractions, const YieldScan& scan,
                             const Sources& sources) const {
  const double share = sources.all_smooth(body_) ? 1.0 : near;
  const YieldLimit limit{strength_, 1.0, share, std::min(share, beyond_weak),
                         sources.deviator(body_)};
  const Box below = scan.box_below(tractions, sign(), limit);
  // Plastic flow above may have brought a weak layer to yield in the grid as well.
  return strength_.weakens() ? below.united(scan.box(tractions, sign(), limit)) : below;
}

bool YieldSearch::yields_everywhere(const operators::Tractions& tractions,
                                    const YieldScan& scan) const {
  return scan.is_beyond_everywhere(tractions, sign(), {strength_, 1.0, 1.0, 1.0});
}

const Columns& YieldSearch::yielding_columns(const operators::Tractions& tractions,
                                             const YieldScan& scan, const Sources& sources) {
  const bool known =
      yielding_ && yielding_->softening == weakest_ && yielding_->tractions == tractions;
  if (!known) {
    const YieldLimit limit{strength_, weakest_, 1.0, beyond_weak, sources.deviator(body_)};
    yielding_ = Yielding{tractions, weakest_, columns_beyond(tractions, limit, scan)};
  }
  return yielding_->columns;
}

Columns YieldSearch::columns_beyond(const operators::Tractions& tractions, const YieldLimit& limit,
                                    const YieldScan& scan) const {
  if (setup_.grid.surface_size() <= large_surface) {
    return scan.columns(tractions, sign(), limit);
  }
  return setup_.cache.zone_scan(body_, setup_.strength(body_, {}), heating_)
      ->columns(tractions, sign(), limit);
}

}  // namespace samcontact::simulation
