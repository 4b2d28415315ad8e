// SPDX-License-Identifier: GPL-3.0-or-later
// Near the highest wavenumber a mode and its alias go over into each other: which waves a stored
// wavenumber stands for, and their shares.
#pragma once

#include <optional>

#include "samcontact/operators/convolution/volume_transform.hpp"
#include "samcontact/operators/residual/residual_stress.hpp"

namespace samcontact::operators {

/// Wavenumbers from here on, of the highest one, share their place with their aliases.
inline constexpr double blended_from = 0.85;

struct WaveAlias {
  double kx, ky, share;  // [1/m], [1/m], [-]
};
/// Of stored place i of row ky, or of its alias in a direction; none where it has no share. share:
/// of ResidualSettings. blends: whether waves share their place with aliases at all.
std::optional<WaveAlias> wave_alias(const Grid& grid, const VolumeTransform& transform, int i,
                                    int ky, bool alias_x, bool alias_y,
                                    const decltype(ResidualSettings::share)& share,
                                    bool blends = true);

}  // namespace samcontact::operators
