// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/working_set.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "samcontact/base/multiversion.hpp"
#include "samcontact/base/reduce.hpp"

namespace samcontact::contact {
namespace {

using Run = CellRuns::Run;

SAMCONTACT_MULTIVERSION
Sums sums_of(const Run* first, const Run* last, const double* a, const double* b) {
  double plain[reduce_lanes] = {}, product[reduce_lanes] = {};
  for (const Run* run = first; run != last; ++run) {
    std::size_t i = run->begin;
    for (; i + reduce_lanes <= run->end; i += reduce_lanes) {
      for (std::size_t l = 0; l < reduce_lanes; ++l) {
        plain[l] += a[i + l];
        product[l] += a[i + l] * b[i + l];
      }
    }
    for (std::size_t l = 0; i < run->end; ++i, ++l) {
      plain[l] += a[i];
      product[l] += a[i] * b[i];
    }
  }
  Sums sums;
  for (std::size_t l = 0; l < reduce_lanes; ++l) {
    sums.plain += plain[l];
    sums.product += product[l];
  }
  return sums;
}

SAMCONTACT_MULTIVERSION
void update_direction_runs(const Run* first, const Run* last, double beta, const double* z,
                           double mean, double* t) {
  for (const Run* run = first; run != last; ++run) {
    for (std::size_t i = run->begin; i < run->end; ++i) t[i] = beta * t[i] - (z[i] - mean);
  }
}

SAMCONTACT_MULTIVERSION
double lowest_of(const Run* first, const Run* last, const double* y) {
  double low[reduce_lanes] = {};
  std::fill_n(low, reduce_lanes, INFINITY);
  for (const Run* run = first; run != last; ++run) {
    std::size_t i = run->begin;
    for (; i + reduce_lanes <= run->end; i += reduce_lanes) {
      for (std::size_t l = 0; l < reduce_lanes; ++l) low[l] = y[i + l] < low[l] ? y[i + l] : low[l];
    }
    for (; i < run->end; ++i) low[0] = y[i] < low[0] ? y[i] : low[0];
  }
  return *std::min_element(low, low + reduce_lanes);
}

SAMCONTACT_MULTIVERSION
double add_to(const Run* first, const Run* last, double factor, const double* x, double* y) {
  double low[reduce_lanes] = {};
  std::fill_n(low, reduce_lanes, INFINITY);
  for (const Run* run = first; run != last; ++run) {
    std::size_t i = run->begin;
    for (; i + reduce_lanes <= run->end; i += reduce_lanes) {
      for (std::size_t l = 0; l < reduce_lanes; ++l) {
        const double value = y[i + l] + factor * x[i + l];
        y[i + l] = value;
        low[l] = value < low[l] ? value : low[l];
      }
    }
    for (; i < run->end; ++i) {
      y[i] += factor * x[i];
      low[0] = y[i] < low[0] ? y[i] : low[0];
    }
  }
  return *std::min_element(low, low + reduce_lanes);
}

SAMCONTACT_MULTIVERSION
double subtract_from(const Run* first, const Run* last, const double* y, double shift, double* r) {
  double high[reduce_lanes] = {};
  for (const Run* run = first; run != last; ++run) {
    std::size_t i = run->begin;
    for (; i + reduce_lanes <= run->end; i += reduce_lanes) {
      for (std::size_t l = 0; l < reduce_lanes; ++l) {
        const double value = y[i + l] - shift, size = std::fabs(value);
        r[i + l] = value;
        high[l] = size > high[l] ? size : high[l];
      }
    }
    for (; i < run->end; ++i) {
      r[i] = y[i] - shift;
      high[0] = std::max(high[0], std::fabs(r[i]));
    }
  }
  return *std::max_element(high, high + reduce_lanes);
}

}  // namespace

void CellRuns::assign(const std::vector<unsigned char>& chosen, bool value) {
  runs_.clear();
  chunks_.assign(1, 0);
  size_ = 0;
  const std::size_t n = chosen.size();
  // memchr() compares many bytes at a time.
  const auto next = [&](bool flag, std::size_t first, std::size_t last) {
    const void* found = std::memchr(chosen.data() + first, flag, last - first);
    return found
               ? static_cast<std::size_t>(static_cast<const unsigned char*>(found) - chosen.data())
               : last;
  };
  std::size_t in_chunk = 0;
  for (std::size_t i = next(value, 0, n); i < n; i = next(value, i, n)) {
    const std::size_t begin = i;
    i = next(!value, begin, std::min(n, begin + reduce_chunk - in_chunk));
    runs_.push_back({begin, i});
    size_ += i - begin;
    in_chunk += i - begin;
    if (in_chunk == reduce_chunk) {
      chunks_.push_back(runs_.size());
      in_chunk = 0;
    }
  }
  if (in_chunk > 0) chunks_.push_back(runs_.size());
}

Sums CellRuns::sums(const Field& a, const Field& b) const {
  const std::ptrdiff_t chunks = std::ssize(chunks_) - 1;
  std::vector<Sums> parts(chunks);
#pragma omp parallel for schedule(static) if (chunks > 1)
  for (std::ptrdiff_t c = 0; c < chunks; ++c) {
    parts[c] = sums_of(&runs_[chunks_[c]], runs_.data() + chunks_[c + 1], a.data(), b.data());
  }
  Sums total;
  for (const Sums& part : parts) {
    total.plain += part.plain;
    total.product += part.product;
  }
  return total;
}

void CellRuns::update_direction(double beta, const Field& z, double mean, Field& t) const {
  const std::ptrdiff_t chunks = std::ssize(chunks_) - 1;
#pragma omp parallel for schedule(static) if (chunks > 1)
  for (std::ptrdiff_t c = 0; c < chunks; ++c) {
    update_direction_runs(&runs_[chunks_[c]], runs_.data() + chunks_[c + 1], beta, z.data(), mean,
                          t.data());
  }
}

/// Maximum of 0 and the parts.
template <class Part>
double CellRuns::extreme(const Part& part) const {
  const std::ptrdiff_t chunks = std::ssize(chunks_) - 1;
  double largest = 0.0;
#pragma omp parallel for schedule(static) reduction(max : largest) if (chunks > 1)
  for (std::ptrdiff_t c = 0; c < chunks; ++c) {
    largest = std::max(largest, part(&runs_[chunks_[c]], runs_.data() + chunks_[c + 1]));
  }
  return largest;
}

double CellRuns::add(double factor, const Field& x, Field& y, double shift) const {
  return -extreme([&](const Run* first, const Run* last) {
    return shift - add_to(first, last, factor, x.data(), y.data());
  });
}

double CellRuns::lowest(const Field& y, double shift) const {
  return -extreme(
      [&](const Run* first, const Run* last) { return shift - lowest_of(first, last, y.data()); });
}

double CellRuns::subtract(const Field& y, double shift, Field& r) const {
  return extreme([&](const Run* first, const Run* last) {
    return subtract_from(first, last, y.data(), shift, r.data());
  });
}

}  // namespace samcontact::contact
