// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/plasticity/return_mapping.hpp"

#include <algorithm>
#include <cmath>

namespace samcontact::plasticity {
namespace {

double equivalent(const Tensor& deviator) {
  const Tensor& s = deviator;
  return std::sqrt(1.5 * (s[0] * s[0] + s[1] * s[1] + s[2] * s[2]) +
                   3.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

Tensor deviator(const Tensor& stress) {
  const double mean = (stress[0] + stress[1] + stress[2]) / 3;
  return {stress[0] - mean, stress[1] - mean, stress[2] - mean, stress[3], stress[4], stress[5]};
}

/// Components of a + factor b.
Tensor plus(const Tensor& a, double factor, const Tensor& b) {
  Tensor sum;
  for (int c = 0; c < 6; ++c) sum[c] = a[c] + factor * b[c];
  return sum;
}

/// Smooth law in the range in which an increment from g ends: the law itself, or its segment found
/// by beyond(strain, stress), which returns whether the increment passes a kink.
template <class Law, class Beyond>
decltype(auto) smooth(const Law& law, double g, const Beyond& beyond) {
  if constexpr (requires { law.piece(g, beyond); }) {
    return law.piece(g, beyond);
  } else {
    // NOLINTNEXTLINE(readability-redundant-parentheses): the parentheses make it a reference
    return (law);
  }
}

/// Scalar equation of the return with backstresses: the trial stress less the recovered
/// backstresses, |trial - sum X/(1 + recovery d)|, equals (stiffness + sum modulus/(1 + recovery
/// d)) d + yield stress(g + d). The norm needs only their inner products.
class KinematicEquation {
 public:
  /// product(a, b): inner product of tensors a and b: the trial stress (0) and the backstresses.
  template <class Product>
  KinematicEquation(const Material& material, double stiffness, double g, const Product& product)
      : material_(material), stiffness_(stiffness), g_(g) {
    const int count = static_cast<int>(material.backstresses.size()) + 1;
    for (int a = 0; a < count; ++a) {
      for (int b = 0; b <= a; ++b) gram_[a][b] = gram_[b][a] = product(a, b);
    }
  }

  /// The norm on the left, and its derivative.
  struct Left {
    double value, slope;
  };
  Left left(double d) const {
    std::array<double, max_backstresses + 1> factor{1.0}, slope{};
    const int count = static_cast<int>(material_.backstresses.size()) + 1;
    for (int a = 1; a < count; ++a) {
      const double recovery = material_.backstresses[a - 1].recovery;
      factor[a] = -1 / (1 + recovery * d);
      slope[a] = recovery * factor[a] * factor[a];
    }
    double square = 0.0, half_slope = 0.0;
    for (int a = 0; a < count; ++a) {
      for (int b = 0; b < count; ++b) {
        square += factor[a] * gram_[a][b] * factor[b];
        half_slope += slope[a] * gram_[a][b] * factor[b];
      }
    }
    const double value = std::sqrt(std::max(0.0, square));
    return {value, value > 0 ? half_slope / value : 0.0};
  }

  /// 3 G d plus the change of the backstresses.
  double taken_up(double d) const {
    double stiffness = stiffness_;
    for (const Backstress& x : material_.backstresses)
      stiffness += x.modulus / (1 + x.recovery * d);
    return stiffness * d;
  }

  /// 0 inside the yield surface. The difference of the sides decreases monotonically as long as no
  /// backstress exceeds its limit modulus/recovery: Newton's method between bounds.
  template <class Law>
  double solve(const Law& whole, double start) const {
    double low = 0.0, high = left(0.0).value, d = start;
    if (high <= whole.at(g_).yield_stress) return 0.0;
    const auto& law = smooth(whole, g_, [this](double strain, double stress) {
      return left(strain - g_).value - taken_up(strain - g_) > stress;
    });
    for (const Backstress& x : material_.backstresses) {
      if (x.recovery > 0) high += x.modulus / x.recovery;
    }
    high /= stiffness_;
    if (!(d > low && d < high)) d = 0.0;
    for (int n = 0; n < 200; ++n) {
      const auto [value, value_slope] = left(d);
      const auto [yield_stress, yield_slope] = law.at(g_ + d);
      const double difference = value - taken_up(d) - yield_stress;
      double slope = value_slope - stiffness_ - yield_slope;
      for (const Backstress& x : material_.backstresses) {
        const double recovered = 1 + x.recovery * d;
        slope -= x.modulus / (recovered * recovered);
      }
      (difference > 0 ? low : high) = d;
      double next = d - difference / slope;
      // More than a few steps indicate a cycle: every second one then bisects the bounds.
      const bool newton = next >= low && next <= high && (n < 40 || n % 2 == 0);
      if (!newton) next = 0.5 * (low + high);
      const double step = std::fabs(next - d);
      d = next;
      // The step after a Newton step is of the order of its square.
      if (step <= (newton ? 1e-8 : 1e-16) * d) break;
    }
    return d;
  }

 private:
  const Material& material_;
  double stiffness_, g_;
  std::array<std::array<double, max_backstresses + 1>, max_backstresses + 1> gram_{};
};

/// 3/2 a:b.
double inner(const Tensor& a, const Tensor& b) {
  return 1.5 * (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) +
         3.0 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

/// Newton's method, see equivalent_increment, for a trial stress above yield.
template <class Law>
double solve(const Law& whole, double trial, double g, double stiffness, double start) {
  const auto& law = smooth(whole, g, [=](double strain, double stress) {
    return trial - stiffness * (strain - g) > stress;
  });
  // The yield stress is concave in g: from an estimate that is too large the first Newton iterate
  // is too small, and from there the iterates increase monotonically to the root.
  double d = start;
  for (int n = 0; n < 100; ++n) {
    const auto [yield_stress, slope] = law.at(g + d);
    const double step = (trial - stiffness * d - yield_stress) / (stiffness + slope);
    if (step < 0 && n > 0) break;
    d = std::max(0.0, d + step);
    // The next step would be of the order of this one squared.
    if (std::fabs(step) <= 1e-8 * d) break;
  }
  return d;
}

template <class Law>
Return isotropic_return(const Tensor& stress, const Tensor& guess, double g, double shear_modulus,
                        const Law& law) {
  const Tensor s = deviator(stress);
  Tensor trial = s;
  for (int c = 0; c < 6; ++c) trial[c] += 2 * shear_modulus * guess[c];
  const double q = equivalent(trial), yield_before = law.at(g).yield_stress;
  Return result{};
  double yield = yield_before;
  if (q > yield_before) {
    // For a plastic strain, sqrt(2/3 e:e) is 2/3 of the result of `equivalent`.
    const double estimate = 2.0 / 3 * equivalent(guess);
    result.equivalent = solve(law, q, g, 3 * shear_modulus, estimate);
    const double scale = 1.5 * result.equivalent / q;
    for (int c = 0; c < 6; ++c) result.increment[c] = scale * trial[c];
    yield = q - 3 * shear_modulus * result.equivalent;
  }
  result.overshoot = std::max(0.0, q / yield_before - 1.0);
  result.excess = std::max(0.0, equivalent(s) / yield - 1.0);
  return result;
}

/// Sum of the yield stresses of two phases. It has kinks if one of the curves has, where Newton's
/// method still converges from one side, because the sum is concave.
struct YieldSum {
  const std::array<PhaseYield, 2>& phases;

  Point at(double g) const {
    Point sum{0.0, 0.0};
    for (const auto& [material, factor] : phases) {
      const Point point = material.hardening.at(g);
      sum.yield_stress += factor * point.yield_stress;
      sum.slope += factor * point.slope;
    }
    return sum;
  }
};

template <class Law>
Return kinematic_return(const Tensor& stress, const Tensor& guess, double g, double shear_modulus,
                        const Material& material, const Law& law, std::span<const Tensor> before) {
  const Tensor s = deviator(stress), trial = plus(s, 2 * shear_modulus, guess);
  const double yield_before = law.at(g).yield_stress;
  const auto tensor = [&](int a) -> const Tensor& { return a == 0 ? trial : before[a - 1]; };
  const KinematicEquation equation(material, 3 * shear_modulus, g,
                                   [&](int a, int b) { return inner(tensor(a), tensor(b)); });
  const auto& terms = material.backstresses;
  Return result{};
  result.overshoot = std::max(0.0, equation.left(0.0).value / yield_before - 1.0);
  const double d = equation.solve(law, 2.0 / 3 * equivalent(guess));
  Tensor direction = trial, centred = s;
  if (d > 0) {
    for (std::size_t n = 0; n < terms.size(); ++n) {
      direction = plus(direction, -1 / (1 + terms[n].recovery * d), before[n]);
    }
    const double scale = 1.5 * d / equivalent(direction);
    for (int c = 0; c < 6; ++c) result.increment[c] = scale * direction[c];
    result.equivalent = d;
  }
  for (std::size_t n = 0; n < terms.size(); ++n) {
    centred = plus(centred, -1.0, advanced(before[n], terms[n], result.increment, d));
  }
  const double yield = d > 0 ? equivalent(direction) - equation.taken_up(d) : yield_before;
  result.excess = std::max(0.0, equivalent(centred) / yield - 1.0);
  return result;
}

}  // namespace

double von_mises(const Tensor& stress) { return equivalent(deviator(stress)); }

double equivalent_increment(double trial, double g, double shear_modulus,
                            const Hardening& hardening, double start) {
  return hardening.visit([&](const auto& law) {
    return trial > law.at(g).yield_stress ? solve(law, trial, g, 3 * shear_modulus, start) : 0.0;
  });
}

Tensor advanced(const Tensor& backstress, const Backstress& law, const Tensor& increment,
                double equivalent) {
  Tensor after = plus(backstress, 2.0 / 3 * law.modulus, increment);
  for (double& v : after) v /= 1 + law.recovery * equivalent;
  return after;
}

Return radial_return(const Tensor& stress, const Tensor& guess, double g, const Material& material,
                     std::span<const Tensor> before, double softening) {
  return radial_return(stress, guess, g, material.elastic.shear_modulus(), material, before,
                       softening);
}

Return radial_return(const Tensor& stress, const Tensor& guess, double g, double shear_modulus,
                     const Material& material, std::span<const Tensor> before, double softening) {
  const auto with = [&](const auto& law) {
    return before.empty()
               ? isotropic_return(stress, guess, g, shear_modulus, law)
               : kinematic_return(stress, guess, g, shear_modulus, material, law, before);
  };
  return material.hardening.visit([&]<class Law>(const Law& law) {
    return softening == 1 ? with(law) : with(Scaled<Law>{law, softening});
  });
}

Return radial_return(const Tensor& stress, const Tensor& guess, double g, double shear_modulus,
                     const std::array<PhaseYield, 2>& phases) {
  return isotropic_return(stress, guess, g, shear_modulus, YieldSum{phases});
}

std::vector<double> uniaxial_stress(const Material& material, std::span<const double> strain) {
  const double E = material.elastic.E;
  const auto& terms = material.backstresses;
  std::vector<double> stress, x(terms.size(), 0.0);
  double plastic = 0.0, g = 0.0;
  for (const double total : strain) {
    const double trial = E * (total - plastic);
    const auto value = [&](int a) { return a == 0 ? trial : x[a - 1]; };
    const KinematicEquation equation(material, E, g,
                                     [&](int a, int b) { return value(a) * value(b); });
    const double d =
        material.hardening.visit([&](const auto& law) { return equation.solve(law, 0.0); });
    double left = trial;
    for (std::size_t n = 0; n < terms.size(); ++n) left -= x[n] / (1 + terms[n].recovery * d);
    const double flow = std::copysign(d, left);
    for (std::size_t n = 0; n < terms.size(); ++n) {
      x[n] = (x[n] + terms[n].modulus * flow) / (1 + terms[n].recovery * d);
    }
    plastic += flow;
    g += d;
    stress.push_back(E * (total - plastic));
  }
  return stress;
}

}  // namespace samcontact::plasticity
