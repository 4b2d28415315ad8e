// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat/heat_near.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/operators/heat/heat_symbols.hpp"

namespace samcontact::operators {
namespace {

using std::numbers::pi;
using RealMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using RealView = Eigen::Map<const RealMatrix>;

using Profiles = std::vector<ThermalProfile<double>>;

/// cos or sin of offset times wavenumber 2 pi a / m, [offset][a]; doubled for all but a = 0.
RealMatrix waves_along(int offsets, int numbers, int m, bool odd) {
  RealMatrix wave(offsets, numbers);
  for (int i = 0; i < offsets; ++i) {
    for (int a = 0; a < numbers; ++a) {
      const double phase = 2 * pi * a * i / m;
      wave(i, a) = (a == 0 ? 1 : 2) * (odd ? std::sin(phase) : std::cos(phase));
    }
  }
  return wave;
}

/// Weights of the rates in a decay at the rate k^2: barycentric interpolation in ln(rate).
class Shares {
 public:
  explicit Shares(const std::vector<double>& rates) {
    for (std::size_t m = 0; m < rates.size(); ++m) {
      log_rates_.push_back(std::log(rates[m]));
      weights_.push_back((m % 2 ? -1 : 1) * std::sin(pi * (static_cast<double>(m) + 0.5) /
                                                     static_cast<double>(rates.size())));
    }
  }

  /// Not normalised; returns the sum of the weights.
  double at(double k, std::vector<double>& shares) const {
    double total = 0;
    for (std::size_t m = 0; m < log_rates_.size(); ++m) {
      const double gap = 2 * std::log(k) - log_rates_[m];
      shares[m] = weights_[m] / (gap == 0 ? 1e-300 : gap);
      total += shares[m];
    }
    return total;
  }

 private:
  std::vector<double> log_rates_, weights_;
};

/// Sum for each rate, at depth z, of modes of wavenumber w along the surface.
void sum_profiles(const HeatModes& modes, const Shares& shares, double z, double w,
                  Profiles& sums) {
  std::vector<double> at(sums.size());
  std::fill(sums.begin(), sums.end(), ThermalProfile<double>{});
  const double step = modes.scales().step;
  for (int j = 0; j == 0 || w * std::cosh(j * step) <= modes.scales().cutoff; ++j) {
    const double s = w * std::sinh(j * step), k = w * std::cosh(j * step);
    const double weight = (j == 0 ? 1 : 2) / pi * step * k;
    const double faded = z == 0 ? weight : weight * modes.scales().fade(s * z);
    const double c = faded * std::cos(s * z), d = -faded * s * std::sin(s * z) / (k * k);
    const double total = shares.at(k, at);
    for (std::size_t m = 0; m < sums.size(); ++m) {
      const double share = at[m] / total;
      sums[m].t += c * share;
      sums[m].p += c / (k * k) * share;
      sums[m].slope += d * share;
      sums[m].base += weight * w / (k * k) * share;
    }
  }
}

}  // namespace

NearHeat::NearHeat(const HeatModes& modes) : modes_(modes) {
  if (!modes.scales().is_split) return;
  offsets_x_ = static_cast<int>(std::ceil(modes.scales().split_reach())) + 1;
  offsets_y_ = static_cast<int>(std::ceil(modes.scales().split_reach() / modes.cell_y())) + 1;
  // Chebyshev points in ln(rate). The function is analytic where |Im ln(rate)| < pi/2.
  const double low = 2 * std::log(HeatScales::split_begin),
               high = 2 * std::log(modes.scales().cutoff);
  const double strip = pi / (high - low);
  const double gain = std::log(strip + std::hypot(1, strip));
  const int count =
      static_cast<int>(std::ceil(modes.scales().sharpness * modes.scales().sharpness / gain));
  for (int m = 0; m < count; ++m) {
    const double at = std::cos(pi * (m + 0.5) / count);
    rates_.push_back(std::exp(0.5 * (low + high) + 0.5 * (high - low) * at));
  }
  const double negligible = 0.01 * std::exp(-modes.scales().sharpness * modes.scales().sharpness);
  const auto left = [&](double z) {
    double maximum = 0;
    for (double w = HeatScales::split_begin; w < 20; w += 0.1) {
      maximum = std::max(maximum, (1 - modes.scales().split(w)) * std::exp(-w * z));
    }
    return maximum;
  };
  while (left(depth_) > negligible) depth_ += 0.5;
}

template <class Symbol>
NearTables NearHeat::tabulate(double z, int components, const Symbol& symbol) const {
  const auto count = static_cast<int>(rates_.size());
  const double begin = HeatScales::split_begin, cutoff = modes_.scales().cutoff;
  const double deepest = 1.5 * modes_.scales().sharpness * modes_.scales().sharpness / z;
  // A lattice whose images are out of range.
  const int mx = 2 * offsets_x_, my = 2 * offsets_y_;
  const double dw1 = 2 * pi / mx, dw2 = 2 * pi / (my * modes_.cell_y());
  const int na = static_cast<int>(cutoff / dw1) + 1, nb = static_cast<int>(cutoff / dw2) + 1;
  const Shares shares(rates_);
  // [component][rate][offset along x][b]: summed over a.
  std::vector<RealMatrix> along_x(static_cast<std::size_t>(components) * count,
                                  RealMatrix::Zero(offsets_x_, nb));
  const auto odd_x = [components](int c) { return components == 6 && (c == 4 || c == 5); };
  const auto odd_y = [components](int c) { return components == 6 && (c == 3 || c == 5); };
  const RealMatrix cos_x = waves_along(offsets_x_, na, mx, false);
  const RealMatrix sin_x = waves_along(offsets_x_, na, mx, true);
  check_interrupt();
#pragma omp parallel for schedule(dynamic)
  for (int b = 0; b < nb; ++b) {
    std::vector<RealMatrix> values(components, RealMatrix::Zero(na, count));
    Profiles sums(count);
    for (int a = 0; a < na; ++a) {
      const double w1 = a * dw1, w2 = b * dw2, w = std::hypot(w1, w2);
      // Short waves do not reach a depth, and the nodes would not resolve their cosines.
      if (w < begin || w > std::min(cutoff, deepest)) continue;
      sum_profiles(modes_, shares, z, w, sums);
      const double source = (1 - modes_.scales().split(w)) * sinc(w1 / 2) *
                            sinc(w2 * modes_.cell_y() / 2) / (static_cast<double>(mx) * my);
      for (int c = 0; c < components; ++c) {
        for (int m = 0; m < count; ++m) values[c](a, m) = source * symbol(c, w1, w2, sums[m]);
      }
    }
    for (int c = 0; c < components; ++c) {
      const RealMatrix rows = (odd_x(c) ? sin_x : cos_x) * values[c];
      for (int m = 0; m < count; ++m) along_x[c * count + m].col(b) = rows.col(m);
    }
  }
  check_interrupt();
  NearTables tables;
  for (int c = 0; c < components; ++c) {
    const RealMatrix wave = waves_along(offsets_y_, nb, my, odd_y(c)).transpose();
    const double sign = odd_x(c) && odd_y(c) ? -1 : 1;  // i^2
    for (int m = 0; m < count; ++m) {
      const RealMatrix table = sign * (along_x[c * count + m] * wave);
      tables.components[c].insert(tables.components[c].end(), table.data(),
                                  table.data() + table.size());
    }
  }
  return tables;
}

NearTables NearHeat::temperature(double z) const {
  return tabulate(z, 1, [](int, double, double, const auto& at) { return at.t; });
}

NearTables NearHeat::displacement() const {
  return tabulate(0, 1, [](int, double, double, const auto& at) { return at.base; });
}

NearTables NearHeat::stress(double z, double nu) const {
  return tabulate(z, 6, [z, nu](int c, double w1, double w2, const auto& at) {
    return heat_stress_symbol(c, nu, z, w1, w2, at);
  });
}

ComplexField NearHeat::spectra(const Field& fields, double age) const {
  const fft::PaddedTransform& transform = modes_.transform();
  const std::size_t plane =
      static_cast<std::size_t>(modes_.transform().nx()) * modes_.transform().ny();
  const std::size_t size = transform.spectrum_size();
  ComplexField out(rates_.size() * size);
  for (std::size_t m = 0; m < rates_.size(); ++m) {
    const double factor = std::exp(-rates_[m] * age);
    Field aged(fields.begin() + m * plane, fields.begin() + (m + 1) * plane);
    for (double& value : aged) value *= factor;
    transform.forward(aged.data(), out.data() + m * size, transform.mx(),
                      fft::PaddedTransform::Threads::many);
  }
  return out;
}

Field NearHeat::waves(int m, int offsets, bool odd) {
  Field out;
  for (int i = 0; i < offsets; ++i) {
    for (int n = 0; n <= m / 2; ++n) {
      const double phase = 2 * pi * (static_cast<long long>(i) * n % m) / m;
      out.push_back((i == 0 ? 1 : 2) * (odd ? std::sin(phase) : std::cos(phase)));
    }
  }
  return out;
}

void NearHeat::add(const Field& tables, bool odd_x, bool odd_y, const ComplexField& spectra,
                   double* plane) const {
  const fft::PaddedTransform& transform = modes_.transform();
  const int mx = transform.mx(), mh = transform.mh(), hx = mx / 2 + 1;
  // Offsets beyond the grid have no effect, and would wrap around.
  const int use_x = std::min(offsets_x_, modes_.transform().nx()),
            use_y = std::min(offsets_y_, modes_.transform().ny());
  const Field wave_x = waves(mx, use_x, odd_x), wave_y = waves(transform.my(), use_y, odd_y);
  const RealView cx(wave_x.data(), use_x, hx), cy(wave_y.data(), use_y, mh);
  ComplexField sum(transform.spectrum_size(), Complex{});
  for (std::size_t m = 0; m < rates_.size(); ++m) {
    const RealView table(tables.data() + m * offsets_x_ * offsets_y_, offsets_x_, offsets_y_);
    const RealMatrix half = cy.transpose() * table.topLeftCorner(use_x, use_y).transpose();
    const RealMatrix kernel = half * cx;  // [ky][kx]
    const Complex* from = spectra.data() + m * transform.spectrum_size();
    for (int ky = 0; ky < mh; ++ky) {
      const std::size_t row = static_cast<std::size_t>(ky) * mx;
      for (int kx = 0; kx < mx; ++kx) {
        const double k = kx < hx ? kernel(ky, kx) : (odd_x ? -1 : 1) * kernel(ky, mx - kx);
        sum[row + kx] += k * from[row + kx];
      }
    }
  }
  // The spectrum of an odd kernel is -i times its sine transform.
  Complex factor = 1.0 / (static_cast<double>(mx) * transform.my());
  if (odd_x) factor *= Complex{0, -1};
  if (odd_y) factor *= Complex{0, -1};
  for (Complex& value : sum) value *= factor;
  Field out(static_cast<std::size_t>(modes_.transform().nx()) * modes_.transform().ny());
  transform.inverse(sum.data(), out.data(), mx, fft::PaddedTransform::Threads::one);
  for (std::size_t i = 0; i < out.size(); ++i) plane[i] += out[i];
}

}  // namespace samcontact::operators
