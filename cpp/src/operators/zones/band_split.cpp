// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/zones/band_split.hpp"

#include <utility>

#include "samcontact/base/errors.hpp"

namespace samcontact::operators {

void require_valid(const BandSplit& split) {
  const int middle = split.middle_spacing, far = split.far_spacing, width = split.window_width;
  require(middle > 0 && middle % 2 == 0, "middle_spacing", "an even number of cells", middle);
  require(far > middle && far % (2 * middle) == 0, "far_spacing",
          "an even multiple of middle_spacing", far);
  require(split.near_range > middle, "near_range", "more than middle_spacing", split.near_range);
  require(split.wide_margin > 0, "wide_margin", "> 0", split.wide_margin);
  require(split.middle_range > split.near_range && split.middle_range > far, "middle_range",
          "more than near_range and far_spacing", split.middle_range);
  for (const auto& [name, a] : {std::pair{"middle_sharpness", split.middle_sharpness},
                                {"far_sharpness", split.far_sharpness}}) {
    require(a > 0 && a <= 5, name, "in (0, 5]", a);
  }
  for (const auto& [name, part] : {std::pair{"cutoff_fraction", split.cutoff_fraction},
                                   {"passband_fraction", split.passband_fraction},
                                   {"margin_fade_fraction", split.margin_fade_fraction}}) {
    require(part > 0 && part < 1, name, "in (0, 1)", part);
  }
  require(width == 4 || width == 6 || width == 8 || width == 10, "window_width", "4, 6, 8 or 10",
          width);
  require(split.middle_gap * middle > split.middle_range, "middle_gap", "longer than middle_range",
          split.middle_gap);
  require(split.fading_nodes > 0, "fading_nodes", "> 0", split.fading_nodes);
  for (const auto& [name, depth] :
       {std::pair{"near_displacement_depth", split.near_displacement_depth},
        {"middle_displacement_depth", split.middle_displacement_depth},
        {"near_stress_depth", split.near_stress_depth},
        {"middle_stress_depth", split.middle_stress_depth},
        {"near_bound_depth", split.near_bound_depth},
        {"middle_bound_depth", split.middle_bound_depth}}) {
    require(depth > 0, name, "> 0", depth);
  }
}

}  // namespace samcontact::operators
