// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/heat_sum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/multiversion.hpp"

namespace samcontact::kernels {
namespace {

/// out[i][j] += sum_t f[t][i] g[t][j], four terms at a time; `terms` is a multiple of four.
SAMCONTACT_MULTIVERSION void add_products(const double* f, std::size_t f_stride, const double* g,
                                          std::size_t g_stride, int terms, int rows, int columns,
                                          double* out, std::size_t out_stride) {
  for (int i = 0; i < rows; ++i) {
    double* row = out + i * out_stride;
    for (int t = 0; t < terms; t += 4) {
      const double f0 = f[t * f_stride + i], f1 = f[(t + 1) * f_stride + i],
                   f2 = f[(t + 2) * f_stride + i], f3 = f[(t + 3) * f_stride + i];
      const double* g0 = g + t * g_stride;
      const double *g1 = g0 + g_stride, *g2 = g1 + g_stride, *g3 = g2 + g_stride;
#ifdef __clang__
#pragma clang loop vectorize(assume_safety)
#else
#pragma GCC ivdep
#endif
      for (int j = 0; j < columns; ++j) {
        row[j] += (f0 * g0[j] + f1 * g1[j]) + (f2 * g2[j] + f3 * g3[j]);
      }
    }
  }
}

void unite(HeatProfile::Range range, HeatProfile::Range& all) {
  all = {std::min(all.first, range.first), std::max(all.last, range.last)};
}

}  // namespace

HeatProfile::HeatProfile(const std::vector<double>& x, double a, double period)
    : x_(x), a_(a), period_(period), edge_distance_(std::numeric_limits<double>::infinity()) {
  const double largest = std::max(std::fabs(x_.front()), std::fabs(x_.back())) + a;
  const double rounding = 1e-14 * largest;
  std::vector<double> all;
  for (const double point : x_) {
    all.push_back(point - a);
    all.push_back(point + a);
  }
  std::sort(all.begin(), all.end());
  for (const double edge : all) {
    if (edges_.empty() || edge - edges_.back() > rounding) edges_.push_back(edge);
  }
  // Index of an edge, up to rounding.
  const auto index = [&](double edge) {
    return static_cast<int>(std::upper_bound(edges_.begin(), edges_.end(), edge) - edges_.begin()) -
           1;
  };
  for (const double point : x_) {
    low_edge_.push_back(index(point - a));
    high_edge_.push_back(index(point + a));
  }
  for (const double edge : edges_) {
    if (std::fabs(edge) > rounding) edge_distance_ = std::min(edge_distance_, std::fabs(edge));
  }
  erf_.resize(edges_.size());
  gauss_.resize(edges_.size());
  moment_.resize(edges_.size());
}

HeatProfile::Range HeatProfile::support(double low, double high, double reach) const {
  if (period_ > 0) return {0, static_cast<int>(x_.size())};
  const auto first = std::lower_bound(x_.begin(), x_.end(), low - a_ - reach);
  const auto last = std::upper_bound(x_.begin(), x_.end(), high + a_ + reach);
  return {static_cast<int>(first - x_.begin()), static_cast<int>(last - x_.begin())};
}

void HeatProfile::evaluate_edges(double shift, double v, int first, int last, int orders) {
  const double unit = 1 / (2 * v);
  for (int e = first; e <= last; ++e) {
    const double u = (edges_[e] - shift) * unit;
    erf_[e] = std::erf(u);
    if (orders > 1) gauss_[e] = std::exp(-u * u);
    if (orders > 2) moment_[e] = (edges_[e] - shift) * gauss_[e];
  }
}

/// Sums over the repetitions, without a constant of erf_, which is odd about the source: of the
/// images for narrow, and of the Fourier series for wide Gaussians.
void HeatProfile::repeat_edges(double v, int first, int last) {
  // erfc(negligible) and exp(-negligible^2) are below rounding errors.
  constexpr double negligible = 6.2;
  const double unit = 1 / (2 * v);
  if (v < 0.28 * period_) {
    const double farthest = std::max(std::fabs(edges_.front()), std::fabs(edges_.back()));
    const int images = static_cast<int>(std::ceil((farthest + negligible / unit) / period_));
    for (int e = first; e <= last; ++e) {
      erf_[e] = gauss_[e] = moment_[e] = 0;
      for (int n = -images; n <= images; ++n) {
        const double edge = edges_[e] + n * period_, gauss = std::exp(-edge * edge * unit * unit);
        erf_[e] += std::erf(edge * unit);
        gauss_[e] += gauss;
        moment_[e] += edge * gauss;
      }
    }
    return;
  }
  const double wave = 2 * std::numbers::pi / period_;
  const double mean = 2 * v / (period_ * std::numbers::inv_sqrtpi);
  const int waves = static_cast<int>(std::ceil(negligible / (wave * v)));
  for (int e = first; e <= last; ++e) {
    erf_[e] = 2 * edges_[e] / period_;
    gauss_[e] = mean;
    moment_[e] = 0;
    for (int n = 1; n <= waves; ++n) {
      const double k = n * wave, decay = std::exp(-k * k * v * v);
      const double sine = std::sin(k * edges_[e]) * decay;
      erf_[e] += 4 / (period_ * k) * sine;
      gauss_[e] += 2 * mean * std::cos(k * edges_[e]) * decay;
      moment_[e] += 4 * mean * v * v * k * sine;
    }
  }
}

void HeatProfile::evaluate(double shift, double v, Range range, int orders, double* const* out) {
  const double unit = 1 / (2 * v);
  const int first = low_edge_[range.first], last = high_edge_[range.last - 1];
  if (period_ > 0) {
    repeat_edges(v, first, last);
  } else {
    evaluate_edges(shift, v, first, last, orders);
  }
  const double slope = unit * std::numbers::inv_sqrtpi;
  for (int i = range.first; i < range.last; ++i) {
    const int low = low_edge_[i], high = high_edge_[i], to = i - range.first;
    out[0][to] = 0.5 * (erf_[high] - erf_[low]);
    if (orders > 1) out[1][to] = slope * (gauss_[high] - gauss_[low]);
    if (orders > 2) {
      out[2][to] = -2 * slope * unit * unit * (moment_[high] - moment_[low]);
    }
  }
}

HeatSum::HeatSum(const HeatSource& source, const HeatPoints& points,
                 std::vector<HeatProduct> products, double reach)
    : speed_x_(source.speed_x),
      speed_y_(source.speed_y),
      reach_(reach),
      profile_x_(points.x, source.a, source.period_x),
      profile_y_(points.y, source.b, source.period_y),
      products_(std::move(products)),
      nx_(points.x.size()),
      ny_(points.y.size()),
      tables_(products_.size(), Field(nx_ * ny_)) {
  for (const auto& p : products_) orders_ = std::max({orders_, p.order_x + 1, p.order_y + 1});
  if (!is_oblique()) {
    const bool by_x = speed_y_ == 0;
    along_.resize(products_.size() * max_widths * (by_x ? nx_ : ny_));
    across_.resize(orders_ * max_widths * (by_x ? ny_ : nx_));
    f_.resize(orders_ * std::max(nx_, ny_));
    return;
  }
  f_.resize(orders_ * batch * nx_);
  g_.resize(orders_ * batch * ny_);
  weighted_.resize(batch * nx_);
  terms_.reserve(batch);
}

void HeatSum::add(double age, double v, const std::array<double, max_weights>& weights) {
  if (!is_oblique()) {
    if (widths_.empty() || widths_.back() != v) begin_width(v);
    add_to_width({age, v, weights});
    return;
  }
  terms_.push_back({age, v, weights});
  if (terms_.size() == batch) flush();
}

void HeatSum::end_width() {
  check_interrupt();
  if (is_oblique()) flush();
}

void HeatSum::flush() {
  check_interrupt();
  if (is_oblique()) {
    flush_terms();
  } else {
    flush_widths();
  }
}

/// Begins the sum of terms of width v.
void HeatSum::begin_width(double v) {
  if (widths_.size() == max_widths) flush();
  const bool by_x = speed_y_ == 0;
  const std::size_t width = widths_.size(), m = by_x ? ny_ : nx_;
  if (width == 0) {
    std::ranges::fill(along_, 0.0);
    std::ranges::fill(across_, 0.0);
    rows_ = {static_cast<int>(nx_), 0};
    columns_ = {static_cast<int>(ny_), 0};
  }
  widths_.push_back(v);
  HeatProfile& profile = by_x ? profile_y_ : profile_x_;
  const Range range = profile.support(0, 0, reach_ * v);
  if (range.empty()) return;
  double* to[3];
  for (int order = 0; order < orders_; ++order) {
    to[order] = &across_[(order * max_widths + width) * m + range.first];
  }
  profile.evaluate(0, v, range, orders_, to);
  unite(range, by_x ? columns_ : rows_);
}

/// Adds a term to the sums of the last width.
void HeatSum::add_to_width(const Term& term) {
  const bool by_x = speed_y_ == 0;
  const std::size_t width = widths_.size() - 1, n = by_x ? nx_ : ny_;
  const double shift = (by_x ? speed_x_ : speed_y_) * term.age;
  HeatProfile& profile = by_x ? profile_x_ : profile_y_;
  const Range range = profile.support(shift, shift, reach_ * term.v);
  if (range.empty()) return;
  double* to[3];
  for (int order = 0; order < orders_; ++order) to[order] = &f_[order * n];
  profile.evaluate(shift, term.v, range, orders_, to);
  for (std::size_t p = 0; p < products_.size(); ++p) {
    const auto [order_x, order_y, weight] = products_[p];
    const double* from = to[by_x ? order_x : order_y];
    double* sum = &along_[(p * max_widths + width) * n + range.first];
    const double factor = term.weights[weight];
    for (int i = 0; i < range.last - range.first; ++i) sum[i] += factor * from[i];
  }
  unite(range, by_x ? rows_ : columns_);
}

/// Adds the products of the sums along the motion and the profiles across it.
void HeatSum::flush_widths() {
  const bool by_x = speed_y_ == 0;
  if (!widths_.empty() && !rows_.empty() && !columns_.empty()) {
    for (std::size_t p = 0; p < products_.size(); ++p) {
      const auto [order_x, order_y, weight] = products_[p];
      const double* f = by_x ? &along_[p * max_widths * nx_] : &across_[order_x * max_widths * nx_];
      const double* g = by_x ? &across_[order_y * max_widths * ny_] : &along_[p * max_widths * ny_];
      add_products(f + rows_.first, nx_, g + columns_.first, ny_, max_widths,
                   rows_.last - rows_.first, columns_.last - columns_.first,
                   &tables_[p][rows_.first * ny_ + columns_.first], ny_);
    }
  }
  widths_.clear();
}

void HeatSum::flush_terms() {
  if (terms_.empty()) return;
  double youngest = terms_[0].age, oldest = youngest, widest = 0;
  for (const Term& term : terms_) {
    youngest = std::min(youngest, term.age);
    oldest = std::max(oldest, term.age);
    widest = std::max(widest, term.v);
  }
  const auto range = [&](const HeatProfile& profile, double speed) {
    const double from = speed * youngest, to = speed * oldest;
    return profile.support(std::min(from, to), std::max(from, to), reach_ * widest);
  };
  const auto rows = range(profile_x_, speed_x_), columns = range(profile_y_, speed_y_);
  if (rows.empty() || columns.empty()) return terms_.clear();

  // Terms of zero weight complete the last group of four.
  while (terms_.size() % 4 != 0) terms_.push_back({terms_.back().age, terms_.back().v, {}});
  const int count = static_cast<int>(terms_.size());
  for (int t = 0; t < count; ++t) {
    double *to_f[3], *to_g[3];
    for (int m = 0; m < orders_; ++m) {
      to_f[m] = &f_[(m * batch + t) * nx_];
      to_g[m] = &g_[(m * batch + t) * ny_];
    }
    profile_x_.evaluate(speed_x_ * terms_[t].age, terms_[t].v, rows, orders_, to_f);
    profile_y_.evaluate(speed_y_ * terms_[t].age, terms_[t].v, columns, orders_, to_g);
  }
  const int height = rows.last - rows.first, width = columns.last - columns.first;
  for (std::size_t p = 0; p < products_.size(); ++p) {
    const auto [order_x, order_y, weight] = products_[p];
    for (int t = 0; t < count; ++t) {
      const double* f = &f_[(order_x * batch + t) * nx_];
      for (int i = 0; i < height; ++i) weighted_[t * nx_ + i] = terms_[t].weights[weight] * f[i];
    }
    add_products(weighted_.data(), nx_, &g_[order_y * batch * ny_], ny_, count, height, width,
                 &tables_[p][rows.first * ny_ + columns.first], ny_);
  }
  terms_.clear();
}

double HeatSum::last_age(double v) const {
  const auto passed = [&](const HeatProfile& profile, double speed) {
    if (speed == 0) return std::numeric_limits<double>::infinity();
    const double path = (speed > 0 ? profile.max() : -profile.min()) + profile.half_size();
    return std::max(0.0, path + reach_ * v) / std::fabs(speed);
  };
  return std::min(passed(profile_x_, speed_x_), passed(profile_y_, speed_y_));
}

}  // namespace samcontact::kernels
