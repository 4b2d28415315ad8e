// SPDX-License-Identifier: GPL-3.0-or-later
// Transforms against sums written out from the definition.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include "samcontact/fft/padded_transform.hpp"
#include "samcontact/fft/parity_spectrum.hpp"
#include "samcontact/fft/periodic_transform.hpp"

using namespace samcontact;
using Threads = fft::PaddedTransform::Threads;

namespace {

Field sample(int n) {
  Field f(n);
  for (int i = 0; i < n; ++i) f[i] = std::sin(1.7 * i + 0.3) + 0.1 * i;
  return f;
}

Complex phase(int a, int m) {
  return std::polar(1.0, -2 * std::numbers::pi * (static_cast<double>(a % m) / m));
}

}  // namespace

TEST_CASE("good sizes are even, have small prime factors and are not smaller") {
  for (int n = 1; n < 400; ++n) {
    const int m = fft::good_even_size(n);
    CHECK(m >= n);
    CHECK(m % 2 == 0);
    int rest = m;
    for (const int p : {2, 3, 5, 7}) {
      while (rest % p == 0) rest /= p;
    }
    CHECK(rest == 1);
  }
}

TEST_CASE("fast sizes are even, not smaller and slightly longer") {
  for (int n = 1; n < 3000; ++n) {
    for (const int m : {fft::fast_line_size(n), fft::fast_row_size(n)}) {
      CHECK(m >= n);
      CHECK(m % 2 == 0);
      CHECK(m <= std::max(n + n / 5, fft::good_even_size(n)));
    }
  }
  for (int n = 1; n < 1000; ++n) {
    const int m = fft::fast_plane_size(n), good = fft::good_even_size(n);
    CHECK(m >= good);
    CHECK(m % 2 == 0);
    CHECK(m <= good + good / 8);
  }
  CHECK(fft::fast_plane_size(143) == 160);
  CHECK(fft::fast_row_size(288) == 320);
  CHECK(fft::fast_row_size(462) == 512);
}

TEST_CASE("the padded transform is the discrete Fourier transform of the padded plane") {
  const std::vector<std::pair<int, int>> shapes{{1, 1}, {1, 6}, {5, 1}, {7, 4}, {9, 17}, {9, 131}};
  for (const auto& [nx, ny] : shapes) {
    const fft::PaddedTransform transform(nx, ny);
    const Field plane = sample(nx * ny);
    // A stride larger than a column, as in a block of many planes.
    const std::size_t stride = transform.mx() + 3;
    ComplexField spectrum(transform.mh() * stride);
    transform.forward(plane.data(), spectrum.data(), stride, Threads::one);
    for (int ky = 0; ky < transform.mh(); ++ky) {
      for (int kx = 0; kx < transform.mx(); ++kx) {
        Complex sum{};
        for (int i = 0; i < nx; ++i) {
          for (int j = 0; j < ny; ++j) {
            sum +=
                plane[i * ny + j] * phase(kx * i, transform.mx()) * phase(ky * j, transform.my());
          }
        }
        CHECK(std::abs(spectrum[ky * stride + kx] - sum) < 1e-12 * nx * ny);
      }
    }
    Field back(plane.size());
    transform.inverse(spectrum.data(), back.data(), stride, Threads::one);
    const double scale = 1.0 / (transform.mx() * transform.my());
    for (std::size_t i = 0; i < plane.size(); ++i) {
      CHECK(scale * back[i] == doctest::Approx(plane[i]).epsilon(1e-13));
    }
  }
}

TEST_CASE("a transform through a lent plane gives the same digits in the requested rows") {
  const int nx = 21, ny = 18, first = 3, count = 11;
  const fft::PaddedTransform transform(nx, ny, 28, 30);
  for (const int empty : {0, 2, 9, nx}) {
    Field plane = sample(nx * ny);
    std::fill_n(plane.begin(), empty * ny, 0.0);
    std::fill_n(plane.end() - empty * ny, empty * ny, 0.0);
    if (empty == 2) std::fill_n(plane.begin() + 5 * ny, 9 * ny, 0.0);
    const std::size_t stride = transform.mx() + 4;
    ComplexField direct(transform.mh() * stride), through(direct.size()), lent;
    transform.forward(plane.data(), direct.data(), stride, Threads::one);
    transform.forward(plane.data(), lent, through.data(), stride);
    for (std::size_t n = 0; n < direct.size(); ++n) REQUIRE(through[n] == direct[n]);

    const double untouched = 7.0;
    Field some(plane.size(), untouched), all(plane.size());
    const fft::RowRun rows{first, count};
    transform.inverse(through.data(), stride, lent, {&rows, 1}, some.data());
    CHECK(through == direct);
    transform.inverse(direct.data(), all.data(), stride, Threads::one);
    for (int n = 0; n < nx * ny; ++n) {
      const bool requested = n / ny >= first && n / ny < first + count;
      REQUIRE(some[n] == doctest::Approx(requested ? all[n] : untouched).epsilon(1e-14));
    }
  }
}

TEST_CASE("one and many threads give the same digits") {
  const int n = 150;
  const fft::PaddedTransform transform(n, n);
  const Field plane = sample(n * n);
  ComplexField one(transform.spectrum_size()), many(transform.spectrum_size());
  transform.forward(plane.data(), one.data(), transform.mx(), Threads::one);
  transform.forward(plane.data(), many.data(), transform.mx(), Threads::many);
  CHECK(one == many);
}

TEST_CASE("a filter with many threads convolves with its kernel") {
  // With the kernel of a unit impulse it returns the plane.
  const int n = 200, m = 288;
  const fft::PeriodicTransform transform(n, n, m, m);
  const Field plane = sample(n * n);
  Field spectrum(transform.quarter_size(), 0.0), out(plane.size());
  spectrum[0] = 1.0;
  transform.spectrum(spectrum.data());
  ComplexField work;
  transform.filter(plane.data(), spectrum.data(), out.data(), work);
  for (std::size_t i = 0; i < plane.size(); ++i) REQUIRE(out[i] == doctest::Approx(plane[i]));
}

TEST_CASE("quarter spectra of kernels of any parity") {
  const std::vector<std::pair<int, int>> shapes{{1, 1}, {2, 5}, {6, 3}, {1, 8}};
  for (const auto& [nx, ny] : shapes) {
    const fft::PaddedTransform transform(nx, ny);
    const fft::ParitySpectrum parity(transform);
    const int mx = transform.mx(), my = transform.my();
    for (int odd = 0; odd < 4; ++odd) {
      const bool odd_x = odd & 1, odd_y = odd & 2;
      const auto kernel = [&](int i, int j) {
        // Vanishes with an odd index, as an odd function must.
        const double x = odd_x ? i : 1.0 / (1 + i * i), y = odd_y ? j : 1.0 / (2 + j * j);
        return x * y;
      };
      Field quarter(parity.size(), 0.0);
      for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) quarter[j * parity.hx() + i] = kernel(i, j);
      }
      parity.transform(quarter.data(), odd_x, odd_y);
      for (int ky = 0; ky < parity.hy(); ++ky) {
        for (int kx = 0; kx < parity.hx(); ++kx) {
          Complex sum{};
          for (int i = 1 - nx; i < nx; ++i) {
            for (int j = 1 - ny; j < ny; ++j) {
              sum += kernel(i, j) * phase(kx * (i + mx), mx) * phase(ky * (j + my), my);
            }
          }
          Complex factor(1.0 / (mx * my), 0);
          for (int n = odd_x + odd_y; n > 0; --n) factor *= Complex(0, 1);
          CHECK(std::abs(factor * sum - quarter[ky * parity.hx() + kx]) < 1e-13);
        }
      }
    }
  }
}

TEST_CASE("a filter is the convolution with its even kernel on the periodic grid") {
  for (const auto& [nx, ny, mx, my] :
       {std::tuple{1, 1, 2, 2}, {5, 7, 8, 8}, {9, 4, 10, 6}, {6, 3, 6, 14}}) {
    const fft::PeriodicTransform transform(nx, ny, mx, my);
    const Field plane = sample(nx * ny),
                kernel = sample(static_cast<int>(transform.quarter_size()));
    Field spectrum = kernel, out(nx * ny);
    transform.spectrum(spectrum.data());
    ComplexField work;
    transform.filter(plane.data(), spectrum.data(), out.data(), work);
    const auto folded = [](int d, int m) { return std::min(std::abs(d), m - std::abs(d)); };
    for (int i = 0; i < nx; ++i) {
      for (int j = 0; j < ny; ++j) {
        double sum = 0.0;
        for (int k = 0; k < nx; ++k) {
          for (int l = 0; l < ny; ++l) {
            sum +=
                kernel[folded(j - l, my) * transform.hx() + folded(i - k, mx)] * plane[k * ny + l];
          }
        }
        CHECK(std::abs(out[i * ny + j] - sum) < 1e-12 * nx * ny);
      }
    }
  }
}
