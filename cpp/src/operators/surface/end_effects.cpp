// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface/end_effects.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "samcontact/fft/periodic_transform.hpp"
#include "samcontact/kernels/surface_traction.hpp"

namespace samcontact::operators {
namespace {

/// Cells at the face that are as long as those of the grid, and growth of the others.
constexpr int equal_cells = 6;
constexpr double growth = 1.15, growth_beyond = 1.3;
/// Halvings of the first cell towards the edge, where the load that frees the faces is singular.
constexpr int halvings = 3;
/// The free face, and the surface beyond the grid, are followed to this multiple of the grid.
constexpr double depth_over_length = 2.0;
/// Period along x over the length along y, and its maximum in cells.
constexpr double period_over_length = 2.0;
constexpr int longest_period = 8192;
/// Product of wavenumber and distance beyond which a face has no effect: exp(-22) = 3e-10.
constexpr double reach = 22.0;
/// Gauss points for the mean over a cell.
constexpr double gauss_point = std::numbers::inv_sqrt3;

using Matrix = Eigen::MatrixXd;

/// Factor on the mirrored load that approximates a free face: Guilbault (2011), J. Tribol. 133.
double mirror_factor(double nu) { return 1.29 - (0.08 - 0.5 * nu) / (1 - nu); }

std::vector<double> edges_to(double cell, double length) {
  std::vector<double> edges{0.0};
  double width = cell;
  while (edges.back() < length * (1 - 1e-12)) {
    if (static_cast<int>(edges.size()) > equal_cells) width *= growth;
    edges.push_back(edges.back() + width);
  }
  return edges;
}

/// Finer cells for the solution: those of the effect, with the first one divided, and further ones.
std::vector<double> finer(const std::vector<double>& edges) {
  std::vector<double> fine{0.0};
  for (int n = halvings; n > 0; --n) fine.push_back(edges[1] * std::pow(0.5, n));
  for (std::size_t n = 1; n < edges.size(); ++n) fine.push_back(edges[n]);
  const double last = fine.back();
  double width = last - fine[fine.size() - 2];
  while (fine.back() < depth_over_length * last) {
    width *= growth_beyond;
    fine.push_back(fine.back() + width);
  }
  return fine;
}

/// Fourier sums along x of influence coefficients between cells at distances from the face.
class Coefficients {
 public:
  Coefficients(const std::vector<double>& edges, int mx, double dx)
      : edges_(edges), mx_(mx), dx_(dx), plan_(fft::plan_real_lines(mx, cells())) {
    offsets_.push_back(0);
    for (int k = 0; k <= mx_ / 2; ++k) {
      const double q = 2 * std::numbers::pi * k / (mx_ * dx_);
      int count = 0;
      while (count < cells() && q * edges_[count] < reach) ++count;
      counts_.push_back(count);
      offsets_.push_back(offsets_.back() + static_cast<std::size_t>(count) * count);
    }
    for (Field* field : {&direct, &mirrored, &face}) field->assign(offsets_.back(), 0.0);
  }

  int cells() const { return static_cast<int>(edges_.size()) - 1; }
  int count(int k) const { return counts_[k]; }

  void fill(double nu, bool with_face) {
    const int n = cells();
#pragma omp parallel
    {
      Field lines(static_cast<std::size_t>(n) * mx_), row(n + 1), before(n + 1);
      ComplexField spectra(static_cast<std::size_t>(n) * (mx_ / 2 + 1));
#pragma omp for schedule(dynamic)
      for (int t = 0; t < n; ++t) {
        const double at = 0.5 * (edges_[t] + edges_[t + 1]);
        const double half = 0.5 * (edges_[t + 1] - edges_[t]);
        const auto put = [&](Field& to, double factor, const auto& corner) {
          tabulate(corner, lines, row, before);
          fftw_execute_dft_r2c(plan_.get(), lines.data(), fft::raw(spectra.data()));
          store(spectra, t, factor, to);
        };
        put(direct, 1.0,
            [&](double x, double y) { return kernels::pressure_displacement(x, y - at); });
        put(mirrored, 1.0,
            [&](double x, double y) { return kernels::pressure_displacement(x, y + at); });
        if (!with_face) continue;
        for (const double side : {-gauss_point, gauss_point}) {
          const double z = at + side * half;
          put(face, 0.5 / std::numbers::pi,
              [&](double x, double y) { return kernels::pressure_stress(x, y, z, nu)[1]; });
        }
      }
    }
  }

  Eigen::Map<const Matrix> of(const Field& field, int k) const {
    return {field.data() + offsets_[k], counts_[k], counts_[k]};
  }

  Field direct, mirrored, face;  // [wavenumber], each column-major (target, source)

 private:
  template <class Corner>
  void tabulate(const Corner& corner, Field& lines, Field& row, Field& before) const {
    const int n = cells();
    for (int i = 0; i <= mx_ / 2 + 1; ++i) {
      const double x = (i - 0.5) * dx_;
      for (int s = 0; s <= n; ++s) row[s] = corner(x, edges_[s]);
      for (int s = 0; i > 0 && s < n; ++s) {
        const double value = row[s + 1] - row[s] - (before[s + 1] - before[s]);
        const std::size_t line = static_cast<std::size_t>(s) * mx_;
        lines[line + i - 1] = value;
        if (i > 1) lines[line + mx_ - i + 1] = value;
      }
      std::swap(row, before);
    }
  }

  void store(const ComplexField& spectra, int t, double factor, Field& to) const {
    for (int k = 0; k <= mx_ / 2; ++k) {
      for (int s = 0; t < counts_[k] && s < counts_[k]; ++s) {
        to[offsets_[k] + static_cast<std::size_t>(s) * counts_[k] + t] +=
            factor * spectra[static_cast<std::size_t>(s) * (mx_ / 2 + 1) + k].real();
      }
    }
  }

  const std::vector<double>& edges_;
  int mx_;
  double dx_;
  fft::Plan plan_;
  std::vector<int> counts_;
  std::vector<std::size_t> offsets_;
};

}  // namespace

EndEffect::EndEffect(const Grid& grid, const std::vector<double>& distance,
                     const std::vector<EndingBody>& bodies)
    : nx_(grid.nx), ny_(grid.ny), dy_(grid.dy) {
  const double length = *std::max_element(distance.begin(), distance.end()) + 0.5 * dy_;
  edges_ = edges_to(dy_, length);
  for (std::size_t n = 1; n < edges_.size(); ++n) {
    centres_.push_back(0.5 * (edges_[n - 1] + edges_[n]));
  }
  const int cells = static_cast<int>(centres_.size());
  for (int j = 0; j < ny_; ++j) {
    if (distance[j] <= 0) continue;
    const auto above = std::upper_bound(centres_.begin(), centres_.end(), distance[j]);
    const int cell =
        std::clamp(static_cast<int>(above - centres_.begin()) - 1, 0, std::max(cells - 2, 0));
    const double step = cells > 1 ? centres_[cell + 1] - centres_[cell] : 1.0;
    places_.push_back({j, cell, std::clamp((distance[j] - centres_[cell]) / step, 0.0, 1.0)});
  }
  const double wanted = std::min(period_over_length * length / grid.dx, 1.0 * longest_period);
  mx_ = fft::good_even_size(std::max(2 * nx_, static_cast<int>(std::ceil(wanted))));
  forward_ = fft::plan_real_lines(mx_, cells);
  inverse_ = fft::plan_half_spectra(mx_, cells);
  offsets_.push_back(0);
  for (int k = 0; k <= mx_ / 2; ++k) {
    const double q = 2 * std::numbers::pi * k / (mx_ * grid.dx);
    int count = 0;
    while (count < cells && q * edges_[count] < reach) ++count;
    counts_.push_back(count);
    offsets_.push_back(offsets_.back() + static_cast<std::size_t>(count) * count);
  }
  matrices_.assign(offsets_.back(), 0.0);
  for (const EndingBody& body : bodies) add_body(grid, body);
}

void EndEffect::add_body(const Grid& grid, const EndingBody& body) {
  const bool exact = body.method == FaceMethod::exact;
  const std::vector<double> fine = finer(edges_);
  Coefficients of(fine, mx_, grid.dx);
  of.fill(body.elastic.nu, exact);
  const double factor = body.elastic.normal_compliance() / (std::numbers::pi * mx_);
  const double mirror = mirror_factor(body.elastic.nu);
#pragma omp parallel for schedule(dynamic)
  for (int k = 0; k <= mx_ / 2; ++k) {
    const int n = of.count(k), cells = counts_[k];
    const auto direct = of.of(of.direct, k), mirrored = of.of(of.mirrored, k);
    Matrix effect;
    if (exact) {
      const auto face = of.of(of.face, k);
      const Matrix freed = (Matrix::Identity(n, n) - face * face).inverse();
      effect = (direct + mirrored) * freed - direct;
    } else {
      effect = mirror * mirrored;
    }
    // Means over the cells of the effect, under a unit force per length on each.
    Matrix mean = Matrix::Zero(cells, n), load = Matrix::Zero(n, cells);
    for (int i = 0; i < n; ++i) {
      const int cell = std::max(i - halvings, 0);
      if (cell >= cells) break;
      const double width = edges_[cell + 1] - edges_[cell];
      mean(cell, i) = (fine[i + 1] - fine[i]) / width;
      load(i, cell) = 1 / width;
    }
    const Matrix reduced = mean * effect * load;
    Eigen::Map<Matrix> to(matrices_.data() + offsets_[k], cells, cells);
    to += 0.5 * factor * (reduced + reduced.transpose());
  }
}

void EndEffect::gather(const double* pressure, double* lines) const {
  for (const auto& [row, cell, share] : places_) {
    double* near = lines + static_cast<std::size_t>(cell) * mx_;
    for (int i = 0; i < nx_; ++i) {
      const double force = pressure[static_cast<std::size_t>(i) * ny_ + row] * dy_;
      near[i] += (1 - share) * force;
      if (share > 0) near[mx_ + i] += share * force;
    }
  }
}

void EndEffect::scatter(const double* lines, double* displacement) const {
  for (const auto& [row, cell, share] : places_) {
    const double* near = lines + static_cast<std::size_t>(cell) * mx_;
    for (int i = 0; i < nx_; ++i) {
      const double far = share > 0 ? share * near[mx_ + i] : 0.0;
      displacement[static_cast<std::size_t>(i) * ny_ + row] += (1 - share) * near[i] + far;
    }
  }
}

void EndEffect::add(const double* pressure, double* displacement) const {
  const int cells = static_cast<int>(centres_.size()), mh = mx_ / 2 + 1;
  Field lines(static_cast<std::size_t>(cells) * mx_, 0.0);
  ComplexField spectra(static_cast<std::size_t>(cells) * mh);
  gather(pressure, lines.data());
  fftw_execute_dft_r2c(forward_.get(), lines.data(), fft::raw(spectra.data()));
  Eigen::MatrixX2d in(cells, 2), out(cells, 2);
  for (int k = 0; k < mh; ++k) {
    const int count = counts_[k];
    for (int s = 0; s < count; ++s) {
      const Complex value = spectra[static_cast<std::size_t>(s) * mh + k];
      in(s, 0) = value.real();
      in(s, 1) = value.imag();
    }
    const Eigen::Map<const Matrix> matrix(matrices_.data() + offsets_[k], count, count);
    out.topRows(count).noalias() = matrix * in.topRows(count);
    for (int s = 0; s < cells; ++s) {
      spectra[static_cast<std::size_t>(s) * mh + k] =
          s < count ? Complex(out(s, 0), out(s, 1)) : Complex();
    }
  }
  fftw_execute_dft_c2r(inverse_.get(), fft::raw(spectra.data()), lines.data());
  scatter(lines.data(), displacement);
}

double EndEffect::cost() const {
  const double products = 2.0 * static_cast<double>(matrices_.size());
  return fft::filter_cost(static_cast<int>(centres_.size()), 2, mx_) + products;
}

SharedEndEffects EndEffects::of(const Grid& grid,
                                const std::vector<std::pair<Elastic, FreeFaces>>& bodies) {
  std::map<std::tuple<bool, double>, std::vector<EndingBody>> faces;
  for (const auto& [elastic, own] : bodies) {
    if (own.has_low()) faces[{false, own.low}].push_back({elastic, own.method});
    if (own.has_high()) faces[{true, own.high}].push_back({elastic, own.method});
  }
  if (faces.empty()) return nullptr;
  auto effects = std::make_shared<EndEffects>();
  effects->size_ = grid.surface_size();
  for (auto& [place, ending] : faces) {
    const auto [is_high, face] = place;
    std::vector<double> distance = grid.y();
    for (double& y : distance) y = is_high ? face - y : y - face;
    if (*std::max_element(distance.begin(), distance.end()) <= 0) continue;
    // Bodies of one Poisson's ratio differ by a factor only.
    std::vector<EndingBody> distinct;
    for (const EndingBody& body : ending) {
      const auto same = std::find_if(distinct.begin(), distinct.end(), [&](const EndingBody& d) {
        return d.elastic.nu == body.elastic.nu && d.method == body.method;
      });
      if (same == distinct.end()) {
        distinct.push_back(body);
      } else {
        same->elastic.E = 1 / (1 / same->elastic.E + 1 / body.elastic.E);
      }
    }
    effects->effects_.emplace_back(grid, distance, distinct);
  }
  std::map<std::tuple<double, double, double>, double> pairs;  // low, high, nu
  for (const auto& [elastic, own] : bodies) {
    if (!own.has_low() || !own.has_high() || own.method != FaceMethod::exact) continue;
    pairs[{own.low, own.high, elastic.nu}] += 1 / elastic.E;
  }
  for (const auto& [key, softness] : pairs) {
    const auto [low, high, nu] = key;
    effects->pairs_.emplace_back(grid, low, high, nu, softness);
  }
  return effects;
}

Field EndEffects::displacement(const double* pressure) const {
  Field sum(size_, 0.0);
  for (const EndEffect& effect : effects_) effect.add(pressure, sum.data());
  for (const FacePair& pair : pairs_) pair.add(pressure, sum.data());
  return sum;
}

double EndEffects::cost() const {
  double sum = 0.0;
  for (const EndEffect& effect : effects_) sum += effect.cost();
  for (const FacePair& pair : pairs_) sum += pair.cost();
  return sum;
}

}  // namespace samcontact::operators
