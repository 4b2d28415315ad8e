// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fft/parity_spectrum.hpp"

#include <algorithm>

namespace samcontact::fft {

ParitySpectrum::ParitySpectrum(int mx, int my) : mx_(mx), my_(my) {
  Field quarter(size());
  const std::lock_guard lock(planner_mutex());
  for (int odd = 0; odd < 4; ++odd) {
    const bool odd_x = odd & 1, odd_y = odd & 2;
    // An odd sequence is zero at both of its self-mirrored ends; these are left out.
    const int n[2] = {odd_y ? my_ / 2 - 1 : hy(), odd_x ? mx_ / 2 - 1 : hx()};
    if (n[0] < 1 || n[1] < 1) continue;
    const fftw_r2r_kind kind[2] = {odd_y ? FFTW_RODFT00 : FFTW_REDFT00,
                                   odd_x ? FFTW_RODFT00 : FFTW_REDFT00};
    const int embed[2] = {hy(), hx()};
    plans_[odd].reset(fftw_plan_many_r2r(2, n, 1, quarter.data(), embed, 1, 0, quarter.data(),
                                         embed, 1, 0, kind, FFTW_ESTIMATE | FFTW_UNALIGNED));
  }
}

void ParitySpectrum::transform(double* quarter, bool odd_x, bool odd_y) const {
  const int h = hx();
  for (int j = 0; j < hy(); ++j) {
    double* row = quarter + static_cast<std::size_t>(j) * h;
    const bool end = odd_y && (j == 0 || j == hy() - 1);
    if (end) std::fill(row, row + h, 0.0);
    if (odd_x) row[0] = row[h - 1] = 0.0;
  }
  const auto& plan = plans_[odd_x + 2 * odd_y];
  if (plan) {
    double* start = quarter + (odd_y ? h : 0) + (odd_x ? 1 : 0);
    fftw_execute_r2r(plan.get(), start, start);
  } else {
    std::fill(quarter, quarter + size(), 0.0);
  }
  const double scale = 1.0 / (static_cast<double>(mx_) * my_);
  std::for_each(quarter, quarter + size(), [scale](double& v) { v *= scale; });
}

}  // namespace samcontact::fft
