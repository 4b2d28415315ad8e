// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fft/mirrored_transform.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "samcontact/base/multiversion.hpp"

namespace samcontact::fft {
namespace {

/// Buffers of one thread, kept between calls.
struct Work {
  Field real, middle, zeros;
  ComplexField half;

  /// The numbers, or zeros if there are none.
  const double* or_zeros(const double* values, std::size_t count) {
    if (values != nullptr) return values;
    if (zeros.size() < count) zeros.assign(count, 0.0);
    return zeros.data();
  }
};

/// Spectrum z of a whole row, from those of its even and odd part.
SAMCONTACT_MULTIVERSION
void merge(const double* c, const double* s, const double* even, const double* odd, double* z,
           int count) {
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    z[2 * k] = c[k] * even[k] + s[k] * odd[k];
    z[2 * k + 1] = s[k] * even[k] - c[k] * odd[k];
  }
}
SAMCONTACT_MULTIVERSION
void take_even(const double* c, const double* s, const double* z, double* even, int count) {
  for (std::ptrdiff_t k = 0; k < count; ++k) even[k] = c[k] * z[2 * k] + s[k] * z[2 * k + 1];
}
SAMCONTACT_MULTIVERSION
void take_odd(const double* c, const double* s, const double* z, double* odd, int count) {
  for (std::ptrdiff_t k = 0; k < count; ++k) odd[k] = s[k] * z[2 * k] - c[k] * z[2 * k + 1];
}
/// image: mirror image of the first number; those of the others are below.
SAMCONTACT_MULTIVERSION
void join_rows(const double* even, const double* odd, double* row, double* image, int count) {
  for (int i = 0; i < count; ++i) {
    image[-i] = even[i] - odd[i];
    row[i] = even[i] + odd[i];
  }
}
SAMCONTACT_MULTIVERSION
void even_part(const double* row, const double* image, double* even, int count) {
  for (int i = 0; i < count; ++i) even[i] = 0.5 * (row[i] + image[-i]);
}
SAMCONTACT_MULTIVERSION
void odd_part(const double* row, const double* image, double* odd, int count) {
  for (int i = 0; i < count; ++i) odd[i] = 0.5 * (row[i] - image[-i]);
}

Work& work() {
  static thread_local Work w;
  return w;
}

template <class T>
T* moved(T* values, std::size_t by) {
  return values == nullptr ? nullptr : values + by;
}

/// Whether the numbers are all zero; null: no numbers.
bool are_zero(const double* values, std::size_t count) {
  return values == nullptr || std::all_of(values, values + count, [](double v) { return v == 0; });
}

}  // namespace

MirroredTransform::Mirror::Mirror(int n, int m_)
    : stored(stored_cells(n, true)),
      m(m_),
      shifted(n % 2 == 0),
      cos_(m_ / 2 + 1),
      sin_(m_ / 2 + 1) {
  for (int k = 0; k <= m / 2; ++k) {
    const double angle = shifted ? std::numbers::pi * k / m : 0.0;
    cos_[k] = std::cos(angle);
    sin_[k] = std::sin(angle);
  }
}

void MirroredTransform::Mirror::join(const double* even, const double* odd, double* row) const {
  even = work().or_zeros(even, stored);
  odd = work().or_zeros(odd, stored);
  if (shifted) return join_rows(even, odd, row, row + m - 1, stored);
  row[0] = even[0];
  join_rows(even + 1, odd + 1, row + 1, row + m - 1, stored - 1);
}

void MirroredTransform::Mirror::divide(const double* row, int count, double* even,
                                       double* odd) const {
  const int first = shifted ? 0 : 1;
  if (even) {
    if (!shifted) even[0] = row[0];
    even_part(row + first, row + m - 1, even + first, count - first);
  }
  if (odd) {
    if (!shifted) odd[0] = 0.0;
    odd_part(row + first, row + m - 1, odd + first, count - first);
  }
}

MirroredTransform::MirroredTransform(int nx, int ny, int mx, int my, bool mirror_x)
    : hx_(stored_cells(nx, mirror_x)),
      hy_(stored_cells(ny, true)),
      mx_(mx),
      my_(my),
      mh_(my / 2 + 1),
      mk_(mx / 2 + 1),
      mirror_x_(mirror_x),
      x_(nx, mx),
      y_(ny, my),
      rows_forward_(plan_real_lines(my, block)),
      rows_inverse_(plan_half_spectra(my, block)),
      columns_forward_(plan_real_lines(mx, block)),
      columns_inverse_(plan_half_spectra(mx, block)) {}

/// Pairs of an odd and an even plane; -1 if there is no partner.
std::vector<std::array<int, 2>> MirroredTransform::pairs(std::span<const Plane> planes,
                                                         bool along_x) {
  std::vector<int> even, odd;
  for (int p = 0; p < static_cast<int>(planes.size()); ++p) {
    ((along_x ? planes[p].odd_x : planes[p].odd_y) ? odd : even).push_back(p);
  }
  std::vector<std::array<int, 2>> result(std::max(even.size(), odd.size()), {-1, -1});
  for (std::size_t n = 0; n < even.size(); ++n) result[n][0] = even[n];
  for (std::size_t n = 0; n < odd.size(); ++n) result[n][1] = odd[n];
  return result;
}

void MirroredTransform::forward(std::span<const Plane> planes, std::size_t stride) const {
  Work& w = work();
  w.middle.resize(planes.size() * middle_size());
  w.half.resize(static_cast<std::size_t>(block) * std::max(mk_, mh_));
  forward_rows(planes);
  w.real.assign(static_cast<std::size_t>(block) * mx_, 0.0);
  if (mirror_x_) {
    forward_mirrored_columns(planes, stride);
  } else {
    forward_columns(planes, stride);
  }
}

void MirroredTransform::forward_rows(std::span<const Plane> planes) const {
  Work& w = work();
  w.real.assign(static_cast<std::size_t>(block) * my_, 0.0);
  for (const auto& [even, odd] : pairs(planes, false)) {
    const double* e = even < 0 ? nullptr : planes[even].values;
    const double* o = odd < 0 ? nullptr : planes[odd].values;
    for (int i0 = 0; i0 < hx_; i0 += block) {
      const int rows = std::min(block, hx_ - i0);
      const std::size_t first = static_cast<std::size_t>(i0) * hy_;
      if (are_zero(moved(e, first), static_cast<std::size_t>(rows) * hy_) &&
          are_zero(moved(o, first), static_cast<std::size_t>(rows) * hy_)) {
        for (const int plane : {even, odd}) {
          if (plane < 0) continue;
          double* to = w.middle.data() + plane * middle_size() + i0;
          for (int ky = 0; ky < mh_; ++ky, to += hx_) std::fill_n(to, rows, 0.0);
        }
        continue;
      }
      for (int r = 0; r < rows; ++r) {
        const std::size_t from = static_cast<std::size_t>(i0 + r) * hy_;
        y_.join(moved(e, from), moved(o, from), w.real.data() + static_cast<std::size_t>(r) * my_);
      }
      fftw_execute_dft_r2c(rows_forward_.get(), w.real.data(), raw(w.half.data()));
      for (int ky = 0; ky < mh_; ++ky) {
        const double c = y_.cos_[ky], s = y_.sin_[ky];
        for (int r = 0; r < rows; ++r) {
          const Complex z = w.half[static_cast<std::size_t>(r) * mh_ + ky];
          const std::size_t to = static_cast<std::size_t>(ky) * hx_ + i0 + r;
          if (e) w.middle[even * middle_size() + to] = c * z.real() + s * z.imag();
          if (o) w.middle[odd * middle_size() + to] = s * z.real() - c * z.imag();
        }
      }
    }
  }
}

void MirroredTransform::forward_columns(std::span<const Plane> planes, std::size_t stride) const {
  Work& w = work();
  for (std::size_t p = 0; p < planes.size(); ++p) {
    for (int ky0 = 0; ky0 < mh_; ky0 += block) {
      const int rows = std::min(block, mh_ - ky0);
      for (int r = 0; r < rows; ++r) {
        std::copy_n(w.middle.data() + p * middle_size() + static_cast<std::size_t>(ky0 + r) * hx_,
                    hx_, w.real.data() + static_cast<std::size_t>(r) * mx_);
      }
      fftw_execute_dft_r2c(columns_forward_.get(), w.real.data(), raw(w.half.data()));
      for (int r = 0; r < rows; ++r) {
        std::copy_n(w.half.data() + static_cast<std::size_t>(r) * mk_, mk_,
                    reinterpret_cast<Complex*>(planes[p].spectrum + (ky0 + r) * stride));
      }
    }
  }
}

void MirroredTransform::forward_mirrored_columns(std::span<const Plane> planes,
                                                 std::size_t stride) const {
  Work& w = work();
  for (const auto& [even, odd] : pairs(planes, true)) {
    const double* e = even < 0 ? nullptr : w.middle.data() + even * middle_size();
    const double* o = odd < 0 ? nullptr : w.middle.data() + odd * middle_size();
    for (int ky0 = 0; ky0 < mh_; ky0 += block) {
      const int rows = std::min(block, mh_ - ky0);
      for (int r = 0; r < rows; ++r) {
        const std::size_t from = static_cast<std::size_t>(ky0 + r) * hx_;
        x_.join(moved(e, from), moved(o, from), w.real.data() + static_cast<std::size_t>(r) * mx_);
      }
      fftw_execute_dft_r2c(columns_forward_.get(), w.real.data(), raw(w.half.data()));
      for (int r = 0; r < rows; ++r) {
        const Complex* z = w.half.data() + static_cast<std::size_t>(r) * mk_;
        if (even >= 0) {
          take_even(x_.cos_.data(), x_.sin_.data(), reinterpret_cast<const double*>(z),
                    planes[even].spectrum + (ky0 + r) * stride, mk_);
        }
        if (odd >= 0) {
          take_odd(x_.cos_.data(), x_.sin_.data(), reinterpret_cast<const double*>(z),
                   planes[odd].spectrum + (ky0 + r) * stride, mk_);
        }
      }
    }
  }
}

void MirroredTransform::inverse(std::span<const Plane> planes, std::size_t stride,
                                std::span<const RowRun> rows) const {
  const RowRun all{0, hx_};
  if (rows.empty()) rows = {&all, 1};
  const int end = rows.back().first + rows.back().count;
  Work& w = work();
  w.middle.resize(planes.size() * middle_size());
  w.half.resize(static_cast<std::size_t>(block) * std::max(mk_, mh_));
  w.real.resize(static_cast<std::size_t>(block) * std::max(mx_, my_));
  if (mirror_x_) {
    inverse_mirrored_columns(planes, stride, end);
  } else {
    inverse_columns(planes, stride, end);
  }
  inverse_rows(planes, rows);
}

void MirroredTransform::inverse_columns(std::span<const Plane> planes, std::size_t stride,
                                        int end) const {
  Work& w = work();
  for (std::size_t p = 0; p < planes.size(); ++p) {
    for (int ky0 = 0; ky0 < mh_; ky0 += block) {
      const int rows = std::min(block, mh_ - ky0);
      for (int r = 0; r < rows; ++r) {
        std::copy_n(reinterpret_cast<const Complex*>(planes[p].spectrum + (ky0 + r) * stride), mk_,
                    w.half.data() + static_cast<std::size_t>(r) * mk_);
      }
      fftw_execute_dft_c2r(columns_inverse_.get(), raw(w.half.data()), w.real.data());
      for (int r = 0; r < rows; ++r) {
        std::copy_n(w.real.data() + static_cast<std::size_t>(r) * mx_, end,
                    w.middle.data() + p * middle_size() + static_cast<std::size_t>(ky0 + r) * hx_);
      }
    }
  }
}

void MirroredTransform::inverse_mirrored_columns(std::span<const Plane> planes, std::size_t stride,
                                                 int end) const {
  Work& w = work();
  for (const auto& [even, odd] : pairs(planes, true)) {
    double* const to_even = even < 0 ? nullptr : w.middle.data() + even * middle_size();
    double* const to_odd = odd < 0 ? nullptr : w.middle.data() + odd * middle_size();
    for (int ky0 = 0; ky0 < mh_; ky0 += block) {
      const int rows = std::min(block, mh_ - ky0);
      for (int r = 0; r < rows; ++r) {
        const double* e = even < 0 ? nullptr : planes[even].spectrum + (ky0 + r) * stride;
        const double* o = odd < 0 ? nullptr : planes[odd].spectrum + (ky0 + r) * stride;
        auto* z = reinterpret_cast<double*>(w.half.data() + static_cast<std::size_t>(r) * mk_);
        merge(x_.cos_.data(), x_.sin_.data(), w.or_zeros(e, mk_), w.or_zeros(o, mk_), z, mk_);
      }
      fftw_execute_dft_c2r(columns_inverse_.get(), raw(w.half.data()), w.real.data());
      for (int r = 0; r < rows; ++r) {
        const std::size_t to = static_cast<std::size_t>(ky0 + r) * hx_;
        x_.divide(w.real.data() + static_cast<std::size_t>(r) * mx_, end, moved(to_even, to),
                  moved(to_odd, to));
      }
    }
  }
}

void MirroredTransform::inverse_rows(std::span<const Plane> planes,
                                     std::span<const RowRun> runs) const {
  for (const auto& [even, odd] : pairs(planes, false)) {
    for (const auto& [first, count] : runs) {
      for (int i0 = first; i0 < first + count; i0 += block) {
        inverse_rows(planes, even, odd, i0, std::min(block, first + count - i0));
      }
    }
  }
}

void MirroredTransform::inverse_rows(std::span<const Plane> planes, int even, int odd, int i0,
                                     int rows) const {
  Work& w = work();
  const double* e = even < 0 ? nullptr : w.middle.data() + even * middle_size();
  const double* o = odd < 0 ? nullptr : w.middle.data() + odd * middle_size();
  double* const to_even = even < 0 ? nullptr : planes[even].values;
  double* const to_odd = odd < 0 ? nullptr : planes[odd].values;
  for (int ky = 0; ky < mh_; ++ky) {
    const double c = y_.cos_[ky], s = y_.sin_[ky];
    const std::size_t from = static_cast<std::size_t>(ky) * hx_ + i0;
    const double *a = w.or_zeros(moved(e, from), block), *b = w.or_zeros(moved(o, from), block);
    Complex* to = w.half.data() + ky;
    for (int r = 0; r < rows; ++r, to += mh_) *to = {c * a[r] + s * b[r], s * a[r] - c * b[r]};
  }
  fftw_execute_dft_c2r(rows_inverse_.get(), raw(w.half.data()), w.real.data());
  for (int r = 0; r < rows; ++r) {
    const std::size_t to = static_cast<std::size_t>(i0 + r) * hy_;
    y_.divide(w.real.data() + static_cast<std::size_t>(r) * my_, y_.stored, moved(to_even, to),
              moved(to_odd, to));
  }
}

}  // namespace samcontact::fft
