// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/laws/adhesion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "samcontact/base/errors.hpp"

namespace samcontact::contact {
namespace {

/// Attraction relative to its maximum that is negligible.
constexpr double negligible = 1e-9;

void require_positive(const std::string& name, double value) {
  require(std::isfinite(value) && value > 0, name, "a finite number > 0", value);
}

class Exponential final : public ContactLaw {
 public:
  Exponential(double work, double range) : work_(work), range_(range) {
    require_positive("work", work);
    require_positive("range", range);
  }

  double attraction(double gap) const override { return work_ / range_ * std::exp(-gap / range_); }
  double largest_attraction() const override { return work_ / range_; }
  double fall(double gap) const override { return attraction(gap) / range_; }
  double steepest_fall() const override { return work_ / (range_ * range_); }
  double reach() const override { return -std::log(negligible) * range_; }
  double energy(double gap) const override {
    return std::isinf(gap) ? 0.0 : -work_ * std::expm1(-gap / range_);
  }

 private:
  double work_, range_;
};

/// 9-3 law; s = 1 + g/z0.
class LennardJones final : public ContactLaw {
 public:
  LennardJones(double work, double z0) : work_(work), z0_(z0) {
    require_positive("work", work);
    require_positive("z0", z0);
  }

  double attraction(double gap) const override {
    const double c = cube(gap);
    return 8.0 / 3.0 * work_ / z0_ * (c - c * c * c);
  }
  double largest_attraction() const override {
    return 16.0 / (9.0 * std::numbers::sqrt3) * work_ / z0_;  // at s^6 = 3
  }
  double fall(double gap) const override {
    if (std::isinf(gap)) return 0.0;
    const double c = cube(gap);
    return 8.0 * work_ / (z0_ * z0_) * (c - 3.0 * c * c * c) / (1.0 + gap / z0_);
  }
  double steepest_fall() const override {
    const double s = std::pow(7.5, 1.0 / 6.0);  // where the slope is steepest
    return fall((s - 1.0) * z0_);
  }
  double reach() const override { return (std::cbrt(1.0 / negligible) - 1.0) * z0_; }
  double energy(double gap) const override {
    if (std::isinf(gap)) return 0.0;
    const double s2 = 1.0 / ((1.0 + gap / z0_) * (1.0 + gap / z0_));
    return work_ / 3.0 * (4.0 * (1.0 - s2) - (1.0 - s2 * s2 * s2 * s2));
  }

 private:
  double cube(double gap) const {
    const double s = 1.0 + gap / z0_;
    return 1.0 / (s * s * s);
  }

  double work_, z0_;
};

/// Constant up to half the drop before work/stress, then half a cosine wave to zero. Without kinks,
/// the edge of the attraction moves from cell to cell without jumps.
class Dugdale final : public ContactLaw {
 public:
  Dugdale(double work, double stress, double drop)
      : stress_(stress), drop_(drop), start_(std::max(0.0, work / stress - 0.5 * drop)) {}

  double attraction(double gap) const override {
    if (gap <= start_) return stress_;
    return gap >= start_ + drop_ ? 0.0 : 0.5 * stress_ * (1.0 + std::cos(phase(gap)));
  }
  double largest_attraction() const override { return stress_; }
  double fall(double gap) const override {
    if (gap <= start_ || gap >= start_ + drop_) return 0.0;
    return steepest_fall() * std::sin(phase(gap));
  }
  double steepest_fall() const override { return 0.5 * std::numbers::pi * stress_ / drop_; }
  double reach() const override { return start_ + drop_; }
  double energy(double gap) const override {
    if (std::isinf(gap)) return 0.0;
    if (gap <= start_) return stress_ * gap;
    if (gap >= start_ + drop_) return stress_ * (start_ + 0.5 * drop_);
    const double wave = drop_ / std::numbers::pi * std::sin(phase(gap));
    return stress_ * (start_ + 0.5 * (gap - start_ + wave));
  }

 private:
  double phase(double gap) const { return std::numbers::pi * (gap - start_) / drop_; }

  double stress_, drop_, start_;
};

class Tabulated final : public ContactLaw {
 public:
  Tabulated(std::vector<double> gaps, std::vector<double> attractions)
      : gaps_(std::move(gaps)), attractions_(std::move(attractions)), energies_{0.0} {
    for (std::size_t k = 0; k + 1 < gaps_.size(); ++k) {
      const double length = gaps_[k + 1] - gaps_[k];
      energies_.push_back(energies_[k] + 0.5 * length * (attractions_[k] + attractions_[k + 1]));
      steepest_ = std::max(steepest_, (attractions_[k] - attractions_[k + 1]) / length);
    }
    largest_ = *std::max_element(attractions_.begin(), attractions_.end());
  }

  double attraction(double gap) const override {
    if (gap >= gaps_.back()) return 0.0;
    const std::size_t k = interval(gap);
    return attractions_[k] - fall_in(k) * (gap - gaps_[k]);
  }
  double largest_attraction() const override { return largest_; }
  double fall(double gap) const override {
    return gap >= gaps_.back() ? 0.0 : fall_in(interval(gap));
  }
  double steepest_fall() const override { return steepest_; }
  double reach() const override { return gaps_.back(); }
  double energy(double gap) const override {
    if (std::isinf(gap)) return 0.0;
    if (gap >= gaps_.back()) return energies_.back();
    const std::size_t k = interval(gap);
    const double rest = gap - gaps_[k];
    return energies_[k] + rest * (attractions_[k] - 0.5 * fall_in(k) * rest);
  }

 private:
  std::size_t interval(double gap) const {
    const auto above = std::upper_bound(gaps_.begin() + 1, gaps_.end() - 1, gap);
    return static_cast<std::size_t>(above - gaps_.begin()) - 1;
  }
  double fall_in(std::size_t k) const {
    return (attractions_[k] - attractions_[k + 1]) / (gaps_[k + 1] - gaps_[k]);
  }

  std::vector<double> gaps_, attractions_, energies_;
  double steepest_ = 0.0, largest_ = 0.0;
};

}  // namespace

SharedContactLaw exponential_adhesion(double work, double range) {
  return std::make_shared<const Exponential>(work, range);
}

SharedContactLaw dugdale_adhesion(double work, double stress, double drop) {
  require_positive("work", work);
  require_positive("stress", stress);
  require_positive("drop", drop);
  require(drop <= 2 * work / stress, "drop",
          "at most 2 work/stress = " + to_short_text(2 * work / stress, 6) + " m", drop);
  return std::make_shared<const Dugdale>(work, stress, drop);
}

SharedContactLaw lennard_jones_adhesion(double work, double z0) {
  return std::make_shared<const LennardJones>(work, z0);
}

SharedContactLaw tabulated_adhesion(const std::vector<double>& points) {
  if (points.size() < 4 || points.size() % 2 != 0) {
    throw std::invalid_argument(
        "a tabulated adhesion requires at least two pairs of gap and stress");
  }
  std::vector<double> gaps, attractions;
  for (std::size_t k = 0; k < points.size(); k += 2) {
    require(std::isfinite(points[k]) && (k == 0 ? points[k] == 0 : points[k] > gaps.back()), "gap",
            k == 0 ? "0 first" : "increasing", points[k]);
    require(std::isfinite(points[k + 1]) && points[k + 1] >= 0, "stress", "finite and >= 0",
            points[k + 1]);
    gaps.push_back(points[k]);
    attractions.push_back(points[k + 1]);
  }
  require(attractions.back() == 0, "stress", "0 at the last gap", attractions.back());
  auto law = std::make_shared<const Tabulated>(std::move(gaps), std::move(attractions));
  require(law->attracts(), "stress", "> 0 at one gap at least", 0.0);
  return law;
}

}  // namespace samcontact::contact
