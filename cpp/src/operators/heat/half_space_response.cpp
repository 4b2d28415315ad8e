// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat/half_space_response.hpp"

#include <cmath>
#include <utility>

#include "samcontact/operators/heat/heat_symbols.hpp"

namespace samcontact::operators {
namespace {

using ResponseMatrix = LevelResponse::Matrix;

/// Indices among the profiles below the surface: temperature, and potential with its slope. The
/// profile of the surface is the potential there, times w.
constexpr int temperature_at = 0, potential_at = 1, slope_at = 2;

/// Sums over the wavenumbers s along the depth.
class DepthSums : public LevelResponse {
 public:
  DepthSums(const HeatModes& modes, double dx, double mean_share, std::size_t number,
            std::size_t first, HeatQuantity quantity, const std::vector<double>& depths)
      : level_(modes.levels()[number]),
        quantity_(quantity),
        mean_share_(mean_share),
        first_(first),
        total_(modes.mode_count()),
        cosines_(depths.size() + 1, level_.s.size()),
        sines_(depths.size(), level_.s.size()) {
    // Rows: T or P of each depth, slope of each depth, P(0).
    for (std::size_t j = 0; j < level_.s.size(); ++j) {
      for (std::size_t d = 0; d < depths.size(); ++d) {
        const double z = depths[d] / dx, sz = level_.s[j] * z;
        const double weight = level_.weight[j] * modes.scales().fade(sz);
        cosines_(d, j) = z == 0 ? level_.weight[j] : weight * std::cos(sz);
        sines_(d, j) = -weight * level_.s[j] * std::sin(sz);
      }
      cosines_(depths.size(), j) = level_.weight[j];
    }
  }

  void add(const HeatBlock& block, const Matrix& c, HeatProfiles& profiles) const override {
    const auto used = static_cast<Eigen::Index>(block.nodes);
    const std::size_t depths = profiles.depths.size();
    if (quantity_ != HeatQuantity::displacement) {
      const Matrix sums = cosines_.topRows(depths).leftCols(used) * c;
      store(block, sums, depths, profiles.below[temperature_at]);
    }
    if (quantity_ == HeatQuantity::temperature) return;
    const Matrix over = over_squares(block, c);
    const Matrix sums = cosines_.leftCols(used) * over;
    for (std::size_t n = 0; n < block.count; ++n) {
      const double w = level_.modes[block.first + n].w;
      const Complex at_surface(sums(depths, 2 * n), sums(depths, 2 * n + 1));
      // The limit of w P(0) at w = 0 is the heat itself.
      profiles.surface[first_ + block.first + n] =
          w > 0 ? w * at_surface : mean_share_ * Complex(c(0, 2 * n), c(0, 2 * n + 1));
    }
    if (quantity_ == HeatQuantity::displacement) return;
    store(block, sums, depths, profiles.below[potential_at]);
    const Matrix slopes = sines_.leftCols(used) * over;
    store(block, slopes, depths, profiles.below[slope_at]);
  }

 private:
  /// Amplitudes over w^2 + s^2.
  Matrix over_squares(const HeatBlock& block, const Matrix& c) const {
    Matrix over(c.rows(), c.cols());
    for (std::size_t j = 0; j < block.nodes; ++j) {
      const double s2 = level_.rates[j];
      for (std::size_t n = 0; n < block.count; ++n) {
        const double w = level_.modes[block.first + n].w;
        const double k2 = w * w + s2, inverse = w > 0 ? 1 / k2 : 0;
        over(j, 2 * n) = inverse * c(j, 2 * n);
        over(j, 2 * n + 1) = inverse * c(j, 2 * n + 1);
      }
    }
    return over;
  }

  void store(const HeatBlock& block, const Matrix& sums, std::size_t depths,
             ComplexField& into) const {
    for (std::size_t d = 0; d < depths; ++d) {
      for (std::size_t n = 0; n < block.count; ++n) {
        into[d * total_ + first_ + block.first + n] = {sums(d, 2 * n), sums(d, 2 * n + 1)};
      }
    }
  }

  const HeatLevel& level_;
  HeatQuantity quantity_;
  double mean_share_;
  std::size_t first_, total_;
  ResponseMatrix cosines_, sines_;
};

class HalfSpaceResponse : public HeatResponse {
 public:
  HalfSpaceResponse(const HeatModes& modes, double dx, const Thermal& thermal,
                    const Elastic& elastic)
      : modes_(modes), dx_(dx), thermal_(thermal), elastic_(elastic) {}

  double scale(HeatQuantity quantity) const override {
    const double nu = elastic_.nu, k = thermal_.conductivity, alpha = thermal_.expansion;
    switch (quantity) {
      case HeatQuantity::temperature:
        return dx_ / k;
      case HeatQuantity::displacement:
        return -2 * alpha * (1 + nu) / k * dx_ * dx_;
      default:
        return elastic_.E * alpha / (1 - nu) / k * dx_;
    }
  }

  HeatProfiles profiles(HeatQuantity quantity, std::vector<double> depths) const override {
    const std::size_t total = modes_.mode_count(), count = depths.size() * total;
    HeatProfiles profiles{std::move(depths), {ComplexField(count)}, ComplexField(total)};
    if (quantity == HeatQuantity::stress) {
      profiles.below[potential_at].resize(count);
      profiles.below[slope_at].resize(count);
    }
    return profiles;
  }

  std::unique_ptr<LevelResponse> level(std::size_t number, std::size_t first, HeatQuantity quantity,
                                       const std::vector<double>& depths) const override {
    return std::make_unique<DepthSums>(modes_, dx_, mean_share(), number, first, quantity, depths);
  }

  ComplexField component(HeatQuantity quantity, const HeatProfiles& profiles, std::size_t d,
                         int component) const override {
    const std::size_t total = modes_.mode_count();
    const auto& below = profiles.below;
    if (quantity == HeatQuantity::displacement) return profiles.surface;
    if (quantity == HeatQuantity::temperature) {
      const Complex* first = below[temperature_at].data() + d * total;
      return ComplexField(first, first + total);
    }
    ComplexField values(total);
    const double z = profiles.depths[d] / dx_;
    std::size_t n = 0;
    for (const HeatLevel& level : modes_.levels()) {
      for (const HeatMode& mode : level.modes) {
        const std::size_t at = d * total + n;
        const ThermalProfile<Complex> profile{below[temperature_at][at], below[potential_at][at],
                                              below[slope_at][at], profiles.surface[n]};
        const Complex v = heat_stress_symbol(component, elastic_.nu, z, mode.w1, mode.w2, profile);
        values[n++] = component == 3 || component == 4 ? Complex{v.imag(), -v.real()} : v;
      }
    }
    return values;
  }

 private:
  /// u_z of a laterally held half-space that is heated uniformly, over the limit of long waves.
  double mean_share() const { return modes_.periods().is_double() ? 0.5 / (1 - elastic_.nu) : 1.0; }

  const HeatModes& modes_;
  double dx_;
  Thermal thermal_;
  Elastic elastic_;
};

}  // namespace

std::unique_ptr<const HeatResponse> half_space_response(const HeatModes& modes, double dx,
                                                        const Thermal& thermal,
                                                        const Elastic& elastic) {
  return std::make_unique<HalfSpaceResponse>(modes, dx, thermal, elastic);
}

}  // namespace samcontact::operators
