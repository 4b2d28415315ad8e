// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat/layered_response.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <span>
#include <utility>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/kernels/heated_wave.hpp"
#include "samcontact/operators/heat/rate_fit.hpp"

namespace samcontact::operators {
namespace {

using RateMatrix = LevelResponse::Matrix;

/// Wavenumber that stands for 0, times the distance over which heat spreads.
constexpr double least_wave = 1e-6;

/// Fields of one wavenumber in the frame of the wavevector; stress: 11, 22, 33 and i s_13.
constexpr int count_of(HeatQuantity quantity) { return quantity == HeatQuantity::stress ? 4 : 1; }

/// Exponents of time of the growth of fields under a constant flux.
double power_of(HeatQuantity quantity) {
  return quantity == HeatQuantity::displacement ? 1.0 : 0.5;
}

/// A block of modes: Chebyshev points of the logarithm of the wavenumber, and interpolation from
/// them, [mode][point]; fits of fields that grow with the root of time, and with time.
struct RateBlock {
  std::vector<double> waves;
  RateMatrix basis;
  std::array<RateFit, 2> fits;
  bool is_held = false;  // the mean of a periodic surface
  const RateFit& fit(HeatQuantity quantity) const { return fits[power_of(quantity) == 1.0]; }
};

/// Points on [first, last], and barycentric interpolation to `to`.
void add_points(RateBlock& block, double first, double last, std::span<const double> to) {
  constexpr double points_per_octave = 10.0, fewest = 4.0;
  const double octaves = std::log2(last / first);
  const int count = octaves < 1e-9 ? 1 : static_cast<int>(fewest + points_per_octave * octaves);
  std::vector<double> places, weights;
  for (int p = 0; p < count; ++p) {
    const double angle = std::numbers::pi * (p + 0.5) / count;
    places.push_back(count == 1 ? 0.0 : std::cos(angle));
    weights.push_back((p % 2 == 0 ? 1.0 : -1.0) * std::sin(angle));
    block.waves.push_back(first * std::exp2(0.5 * octaves * (1 + places.back())));
  }
  block.basis = RateMatrix::Zero(static_cast<Eigen::Index>(to.size()), count);
  for (std::size_t n = 0; n < to.size(); ++n) {
    const double place = count == 1 ? 0.0 : 2 * std::log2(to[n] / first) / octaves - 1;
    auto row = block.basis.row(static_cast<Eigen::Index>(n));
    for (int p = 0; p < count; ++p) {
      if (place == places[p]) {
        row.setZero();
        row[p] = 1.0;
        break;
      }
      row[p] = weights[p] / (place - places[p]);
    }
    row /= row.sum();
  }
}

/// Weights of one depth: [point and field][node] of each block of all levels.
using RateWeights = std::vector<RateMatrix>;
using SharedWeights = std::shared_ptr<const RateWeights>;

/// Sums over the rates of one level.
class RateSums : public LevelResponse {
 public:
  RateSums(const HeatLevel& level, std::span<const RateBlock> blocks, std::size_t first_block,
           std::size_t first, std::size_t total, HeatQuantity quantity,
           std::vector<SharedWeights> weights)
      : level_(level),
        blocks_(blocks),
        first_block_(first_block),
        first_(first),
        total_(total),
        quantity_(quantity),
        weights_(std::move(weights)) {}

  void add(const HeatBlock& block, const Matrix& amplitudes,
           HeatProfiles& profiles) const override {
    const std::size_t number = &block - level_.blocks.data();
    const RateMatrix& basis = blocks_[number].basis;
    const int count = count_of(quantity_);
    for (std::size_t d = 0; d < weights_.size(); ++d) {
      const Matrix sums = (*weights_[d])[first_block_ + number] * amplitudes;
      for (int f = 0; f < count; ++f) {
        auto& into = quantity_ == HeatQuantity::displacement ? profiles.surface : profiles.below[f];
        Complex* to = into.data() + d * total_ + first_ + block.first;
        for (std::size_t n = 0; n < block.count; ++n) {
          Complex value = 0;
          for (Eigen::Index p = 0; p < basis.cols(); ++p) {
            const Eigen::Index row = p * count + f;
            value += basis(n, p) * Complex(sums(row, 2 * n), sums(row, 2 * n + 1));
          }
          to[n] = value;
        }
      }
    }
  }

 private:
  const HeatLevel& level_;
  std::span<const RateBlock> blocks_;
  std::size_t first_block_, first_, total_;
  HeatQuantity quantity_;
  std::vector<SharedWeights> weights_;  // by depth; of the displacement: one
};

class LayeredResponse : public HeatResponse {
 public:
  LayeredResponse(const HeatModes& modes, double dx, double diffusivity, HeatedStack stack)
      : modes_(modes), dx_(dx), unit_(diffusivity / (dx * dx)), stack_(std::move(stack)) {
    for (const HeatLevel& level : modes.levels()) {
      first_blocks_.push_back(blocks_.size());
      for (const HeatBlock& block : level.blocks) blocks_.push_back(made(level, block));
    }
  }

  double scale(HeatQuantity /*quantity*/) const override { return 1.0; }

  HeatProfiles profiles(HeatQuantity quantity, std::vector<double> depths) const override {
    const std::size_t total = modes_.mode_count(), count = depths.size() * total;
    HeatProfiles profiles{std::move(depths), {}, {}};
    if (quantity == HeatQuantity::displacement) {
      profiles.surface.resize(total);
    } else {
      for (int f = 0; f < count_of(quantity); ++f) profiles.below[f].resize(count);
    }
    return profiles;
  }

  std::unique_ptr<LevelResponse> level(std::size_t number, std::size_t first, HeatQuantity quantity,
                                       const std::vector<double>& depths) const override {
    const HeatLevel& level = modes_.levels()[number];
    std::vector<SharedWeights> all;
    all.reserve(depths.size());
    for (const double z : depths) all.push_back(weights(quantity, z));
    return std::make_unique<RateSums>(
        level, std::span(blocks_).subspan(first_blocks_[number], level.blocks.size()),
        first_blocks_[number], first, modes_.mode_count(), quantity, std::move(all));
  }

  ComplexField component(HeatQuantity quantity, const HeatProfiles& profiles, std::size_t d,
                         int component) const override {
    if (quantity == HeatQuantity::displacement) return profiles.surface;
    const std::size_t total = modes_.mode_count();
    const auto at = [&](int field) { return profiles.below[field].data() + d * total; };
    if (quantity == HeatQuantity::temperature) return ComplexField(at(0), at(0) + total);
    const Complex *s11 = at(0), *s22 = at(1), *s33 = at(2), *shear = at(3);
    ComplexField values;
    values.reserve(total);
    std::size_t n = 0;
    for (const HeatLevel& level : modes_.levels()) {
      for (const HeatMode& mode : level.modes) {
        const double c = mode.w > 0 ? mode.w1 / mode.w : 1.0, s = mode.w > 0 ? mode.w2 / mode.w : 0;
        const std::array<Complex, 6> all{c * c * s11[n] + s * s * s22[n],
                                         s * s * s11[n] + c * c * s22[n],
                                         s33[n],
                                         Complex(0, -s) * shear[n],
                                         Complex(0, -c) * shear[n],
                                         c * s * (s11[n] - s22[n])};
        values.push_back(all[component]);
        ++n;
      }
    }
    return values;
  }

 private:
  RateBlock made(const HeatLevel& level, const HeatBlock& block) const {
    const HeatResolution& resolution = modes_.resolution();
    const double least = least_wave / std::sqrt(resolution.longest * resolution.contrast);
    std::vector<double> waves;
    waves.reserve(block.count);
    for (std::size_t n = 0; n < block.count; ++n) {
      waves.push_back(std::max(level.modes[block.first + n].w, least));
    }
    RateBlock made;
    add_points(made, waves.front(), waves.back(), waves);
    made.is_held = modes_.periods().is_double() && level.modes[block.first].w == 0;
    const std::span rates = std::span(level.rates).subspan(block.first_node, block.nodes);
    const ResponseAges ages{resolution.shortest, resolution.longest, waves.front() * waves.front(),
                            resolution.tolerance};
    made.fits = {fit_rates(rates, ages, 0.5), fit_rates(rates, ages, 1.0)};
    return made;
  }

  /// Cached: a simulation uses the same depths in every step.
  SharedWeights weights(HeatQuantity quantity, double z) const {
    const std::lock_guard lock(mutex_);
    const std::pair key(static_cast<int>(quantity), z);
    if (const auto found = kept_.find(key); found != kept_.end()) return found->second;
    constexpr std::size_t max_depths = 128;
    if (kept_.size() >= max_depths) kept_.clear();
    return kept_[key] = std::make_shared<const RateWeights>(computed(quantity, z));
  }

  RateWeights computed(HeatQuantity quantity, double z) const {
    check_interrupt();
    RateWeights weights(blocks_.size());
    const int layer = stack_.elastic.layer_at(z), count = count_of(quantity);
#pragma omp parallel
    {
      kernels::HeatedWave<Complex> wave(stack_);
#pragma omp for schedule(dynamic)
      for (std::ptrdiff_t b = 0; b < static_cast<std::ptrdiff_t>(blocks_.size()); ++b) {
        const RateBlock& block = blocks_[b];
        const RateFit& fit = block.fit(quantity);
        const auto points = static_cast<Eigen::Index>(block.waves.size());
        Eigen::MatrixXcd transforms(points * count, fit.weights.cols());
        for (Eigen::Index p = 0; p < points; ++p) {
          for (Eigen::Index n = 0; n < fit.weights.cols(); ++n) {
            wave.set(block.waves[p] / dx_, fit.s[n] * unit_);
            auto column = transforms.col(n).segment(p * count, count);
            if (quantity == HeatQuantity::displacement) {
              column[0] = block.is_held ? wave.held_displacement() : wave.displacement();
              continue;
            }
            const auto field = wave.at(layer, z);
            if (quantity == HeatQuantity::temperature) {
              column[0] = field.temperature;
            } else {
              column << field.s11, field.s22, field.s33, field.shear;
            }
          }
        }
        weights[b] = transforms.real() * fit.weights.imag().transpose() +
                     transforms.imag() * fit.weights.real().transpose();
      }
    }
    return weights;
  }

  const HeatModes& modes_;
  double dx_, unit_;  // [m]; of the rates [1/s]
  HeatedStack stack_;
  std::vector<RateBlock> blocks_;          // of all levels
  std::vector<std::size_t> first_blocks_;  // of each level
  mutable std::mutex mutex_;
  mutable std::map<std::pair<int, double>, SharedWeights> kept_;
};

}  // namespace

std::unique_ptr<const HeatResponse> layered_response(const HeatModes& modes, double dx,
                                                     double diffusivity, const HeatedStack& stack) {
  return std::make_unique<LayeredResponse>(modes, dx, diffusivity, stack);
}

}  // namespace samcontact::operators
