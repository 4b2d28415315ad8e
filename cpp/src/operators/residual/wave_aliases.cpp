// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/residual/wave_aliases.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "samcontact/base/smooth_step.hpp"

namespace samcontact::operators {
namespace {

/// Weight of a wavenumber, relative to the highest; it and that of its alias add up to 1. Three
/// derivatives are continuous.
double blended(double k) { return rising((2 - blended_from - k) / (2 * (1 - blended_from))); }

}  // namespace

std::optional<WaveAlias> wave_alias(const Grid& grid, const VolumeTransform& transform, int i,
                                    int ky, bool alias_x, bool alias_y,
                                    const decltype(ResidualSettings::share)& share, bool blends) {
  // mx and my are even
  const int mx = transform.mx(), my = transform.my();
  // A single cell that is repeated periodically has uniform fields only.
  const bool varies_x = grid.period.x != 1, varies_y = grid.period.y != 1;
  if ((alias_x && !varies_x) || (alias_y && !varies_y)) return std::nullopt;
  const int stored_x = i <= mx / 2 ? i : i - mx;
  if (alias_x && 2 * std::abs(stored_x) <= blended_from * mx) return std::nullopt;
  if (alias_y && 2 * ky <= blended_from * my) return std::nullopt;
  const int own = varies_x ? stored_x : 0;
  const int x = alias_x ? own - (own > 0 ? mx : -mx) : own;
  const int y = !varies_y ? 0 : alias_y ? ky - my : ky;
  const double two_pi = 2 * std::numbers::pi;
  const auto along_x = [&](int n) { return two_pi * n / (mx * grid.dx); };
  const auto along_y = [&](int n) { return two_pi * n / (my * grid.dy); };
  double weight = blends ? blended(std::abs(2.0 * x / mx)) * blended(std::abs(2.0 * y / my)) : 1.0;
  // Factor of the stored mode, also for its alias.
  if (share) weight *= share(along_x(own), along_y(varies_y ? ky : 0));
  return WaveAlias{along_x(x), along_y(y), weight};
}

}  // namespace samcontact::operators
