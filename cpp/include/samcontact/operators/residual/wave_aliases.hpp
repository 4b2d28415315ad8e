// SPDX-License-Identifier: GPL-3.0-or-later
// Blending of modes with their aliases near the highest wavenumber: the wavevectors that a stored
// wavenumber represents, and their weights.
#pragma once

#include <optional>

#include "samcontact/operators/convolution/volume_transform.hpp"
#include "samcontact/operators/residual/residual_stress.hpp"

namespace samcontact::operators {

/// Fraction of the highest wavenumber above which modes are blended with their aliases.
inline constexpr double blended_from = 0.85;

struct WaveAlias {
  double kx, ky, share;  // [1/m], [1/m], [-]
};
/// Wavevector of stored index i of row ky, or of its alias in a direction; none if its weight is
/// zero. share: of ResidualSettings. blends: whether modes are blended with their aliases at all.
std::optional<WaveAlias> wave_alias(const Grid& grid, const VolumeTransform& transform, int i,
                                    int ky, bool alias_x, bool alias_y,
                                    const decltype(ResidualSettings::share)& share,
                                    bool blends = true);

}  // namespace samcontact::operators
