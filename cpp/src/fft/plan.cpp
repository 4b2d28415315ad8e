// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fft/plan.hpp"

#include <map>
#include <mutex>
#include <tuple>

namespace samcontact::fft {

namespace {

/// Held while a plan is made or destroyed.
std::mutex& planner_mutex() {
  static std::mutex mutex;
  return mutex;
}

void destroy(fftw_plan plan) {
  const std::lock_guard lock(planner_mutex());
  fftw_destroy_plan(plan);
}

enum class Kind { real_lines, half_spectra, line, lines_side_by_side };

/// Plans made so far, for reuse: making them takes a tenth of a first solve.
class Plans {
 public:
  template <class Make>
  Plan get(Kind kind, int m, int count, int sign, const Make& make) {
    const std::lock_guard lock(mutex_);
    Plan& plan = plans_[{kind, m, count, sign}];
    if (plan) return plan;
    {
      const std::lock_guard planning(planner_mutex());
      plan = Plan(make(), destroy);
    }
    const Plan made = plan;
    if (plans_.size() > max_plans) plans_ = {{{kind, m, count, sign}, made}};
    return made;
  }

  void lock() {
    mutex_.lock();
    planner_mutex().lock();
  }
  void unlock() {
    planner_mutex().unlock();
    mutex_.unlock();
  }

 private:
  static constexpr std::size_t max_plans = 200;
  std::mutex mutex_;
  std::map<std::tuple<Kind, int, int, int>, Plan> plans_;
};

/// Never destroyed: FFTW may be unloaded before.
Plans& plans() {
  static auto* const one = new Plans;  // NOLINT(cppcoreguidelines-owning-memory)
  return *one;
}

}  // namespace

void prepare_planner() { plan_line(2, FFTW_FORWARD); }

void lock_plans() { plans().lock(); }
void unlock_plans() { plans().unlock(); }

Plan plan_real_lines(int m, int count) {
  return plans().get(Kind::real_lines, m, count, 0, [&] {
    Field real(static_cast<std::size_t>(count) * m);
    ComplexField half(static_cast<std::size_t>(count) * (m / 2 + 1));
    return fftw_plan_many_dft_r2c(1, &m, count, real.data(), nullptr, 1, m, raw(half.data()),
                                  nullptr, 1, m / 2 + 1, FFTW_ESTIMATE);
  });
}

Plan plan_half_spectra(int m, int count) {
  return plans().get(Kind::half_spectra, m, count, 0, [&] {
    Field real(static_cast<std::size_t>(count) * m);
    ComplexField half(static_cast<std::size_t>(count) * (m / 2 + 1));
    return fftw_plan_many_dft_c2r(1, &m, count, raw(half.data()), nullptr, 1, m / 2 + 1,
                                  real.data(), nullptr, 1, m, FFTW_ESTIMATE);
  });
}

Plan plan_line(int m, int sign) {
  return plans().get(Kind::line, m, 1, sign, [&] {
    ComplexField from(m), to(m);
    return fftw_plan_dft_1d(m, raw(from.data()), raw(to.data()), sign, FFTW_ESTIMATE);
  });
}

Plan plan_lines_side_by_side(int m, int count, int sign) {
  return plans().get(Kind::lines_side_by_side, m, count, sign, [&] {
    ComplexField from(static_cast<std::size_t>(count) * m), to(from.size());
    return fftw_plan_many_dft(1, &m, count, raw(from.data()), nullptr, count, 1, raw(to.data()),
                              nullptr, count, 1, sign, FFTW_ESTIMATE);
  });
}

int good_even_size(int n) {
  for (int m = n + n % 2;; m += 2) {
    int rest = m;
    for (const int p : {2, 3, 5, 7}) {
      while (rest % p == 0) rest /= p;
    }
    if (rest == 1) return m;
  }
}

namespace {

int odd_part(int n) {
  while (n % 2 == 0) n /= 2;
  return n;
}

}  // namespace

int convolution_size(int n, int period, int min_size) {
  const int size = good_even_size(std::max(2 * n - 1, min_size));
  return period > 0 && period % 2 == 0 && period <= size ? period : size;
}

int fast_line_size(int n) {
  for (int m = n + n % 2; m <= n + n / 5; m += 2) {
    const int odd = odd_part(m);
    if (odd == 1 || odd == 3 || odd == 5) return m;
  }
  return good_even_size(n);
}

int fast_plane_size(int n) {
  const int good = good_even_size(n);
  for (int m = good; m <= good + good / 8; m += 2) {
    const int odd = odd_part(m);
    const bool long_too = odd == 1 || odd == 5 || odd == 7 || odd == 25 || odd == 35;
    if (long_too || (odd == 3 && m <= 96) || (odd == 15 && m <= 240)) return m;
  }
  return good;
}

int fast_row_size(int n) {
  if (n > longest_side_by_side) return fast_line_size(n);
  for (int m = n + n % 2; m <= n + n / 8; m += 2) {
    const int odd = odd_part(m);
    if (odd == 1 || odd == 5 || odd == 9) return m;
  }
  return good_even_size(n);
}

}  // namespace samcontact::fft
