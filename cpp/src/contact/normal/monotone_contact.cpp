// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/monotone_contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"
#include "samcontact/contact/iteration/gmres.hpp"
#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {
namespace {

/// Error reduction of a linear solve while cells change sides, the maximum number of vectors it
/// stores, and the number of times it starts again.
constexpr double set_gain = 1e-2;
constexpr int max_linear_steps = 60, max_restarts = 4;
/// Fraction of tol that a linear solve on the final cells aims at.
constexpr double safety = 0.1;
/// Steps without a smaller error before fewer cells change sides at once, and the factor.
constexpr int patience = 6;
constexpr double caution = 0.5, most_cautious = 1e-3;
/// If that does not help: compliance of springs from the last pressure (proximal points), relative
/// to that of a cell, and its factors after each solution and if the cells do not settle.
constexpr double springs_below = 0.2, first_spring = 1.0, slackening = 0.3, last_spring = 1e-4;
constexpr double tightening = 10.0;
/// Error at which a solution with springs becomes the next start.
constexpr double spring_tol = 1e-3;

class MonotoneContact {
 public:
  MonotoneContact(const operators::CreepingDisplacement& displacement, const Grid& grid,
                  const Field& initial_gap, const Given& normal, Field pressure, double rounding)
      : displacement_(displacement),
        grid_(grid),
        initial_gap_(initial_gap),
        normal_(normal),
        n_(initial_gap.size()),
        rounding_(rounding),
        p_(std::move(pressure)),
        u_(n_),
        box_(n_),
        touching_(n_, 0),
        inverse_(displacement.inverse(0.0)) {
    start();
  }

  Solution run(double tol, int max_iterations);

 private:
  bool driven_by_load() const { return normal_.is_force(); }
  double sum() const { return normal_.value / grid_.cell_area(); }
  double true_gap(std::size_t i) const { return initial_gap_[i] + u_[i] - approach_; }
  double gap(std::size_t i) const {
    return spring_ > 0 ? true_gap(i) + spring_ * (p_[i] - anchor_[i]) : true_gap(i);
  }
  double largest_pressure() const {
    return largest_of(n_, [this](std::size_t i) { return p_[i]; });
  }
  double largest_displacement() const {
    return largest_of(n_, [this](std::size_t i) { return std::fabs(u_[i]); });
  }

  void start();
  double local_compliance();
  void set_springs(double compliance);
  void settle() {
    displacement_.apply(p_.data(), u_.data(), work_);
    ++applications_;
  }
  std::size_t choose_cells(double share);
  double set_error() const;
  Field residual() const;
  void solve_cells(double gain);
  Field scattered(const Field& v);
  void apply(const Field& v, Field& out);
  void precondition(const Field& r, Field& z);
  void prepare_border();
  Solution solution();

  const operators::CreepingDisplacement& displacement_;
  const Grid& grid_;
  const Field& initial_gap_;
  const Given normal_;
  const std::size_t n_;
  const double rounding_;
  Field p_, u_, box_;
  std::vector<unsigned char> touching_;
  std::vector<std::size_t> cells_;
  Field border_;  // preconditioner applied to a uniform displacement of the cells
  double border_mean_ = 0.0, approach_ = 0.0;
  double local_ = 0.0;   // displacement of a cell due to a unit pressure on it, with creep [m/Pa]
  double spring_ = 0.0;  // [m/Pa]
  Field anchor_;         // pressure at which the springs have no force
  std::vector<operators::ParityKernel> inverse_;
  ComplexField work_;
  int iterations_ = 0, applications_ = 0, filters_ = 0;
};

/// Relative to the cell that moves least.
double MonotoneContact::local_compliance() {
  Field unit(n_, 0.0);
  const std::size_t middle = static_cast<std::size_t>(grid_.nx / 2) * grid_.ny + grid_.ny / 2;
  unit[middle] = 1.0;
  displacement_.apply(unit.data(), unit.data(), work_);
  ++applications_;
  const double least = *std::min_element(unit.begin(), unit.end());
  return std::max(unit[middle] - least, displacement_.self_influence());
}

/// Springs of this compliance from the present pressure; 0: none.
void MonotoneContact::set_springs(double compliance) {
  for (double& p : p_) p = std::max(p, 0.0);
  settle();
  anchor_ = p_;
  spring_ = compliance < last_spring * local_ ? 0.0 : compliance;
  inverse_ = displacement_.inverse(spring_);
}

void MonotoneContact::start() {
  local_ = local_compliance();
  for (std::size_t i = 0; i < n_; ++i) {
    if (std::isinf(initial_gap_[i])) p_[i] = 0.0;
  }
  const bool given = std::any_of(p_.begin(), p_.end(), in_contact);
  if (driven_by_load()) {
    if (!given) {
      for (std::size_t i = 0; i < n_; ++i) p_[i] = std::isinf(initial_gap_[i]) ? 0.0 : 1.0;
    }
    scale_to_sum(p_, sum());
  } else {
    approach_ = normal_.value;
    for (std::size_t i = 0; i < n_ && !given; ++i) {
      p_[i] = std::max(0.0, approach_ - initial_gap_[i]) / displacement_.self_influence();
      p_[i] /= std::sqrt(static_cast<double>(n_));
    }
  }
  settle();
  for (std::size_t i = 0; i < n_; ++i) {
    touching_[i] = in_contact(p_[i]);
    if (touching_[i]) cells_.push_back(i);
  }
  if (!driven_by_load() || cells_.empty()) return;
  approach_ = 0.0;
  approach_ = ordered_sum(cells_.size(), [this](std::size_t c) { return gap(cells_[c]); }) /
              static_cast<double>(cells_.size());
}

/// Cells whose pressure, less the pressure that would open their gap, is positive; returns the
/// number of cells that change sides. share < 1: only the cells furthest on the wrong side change.
std::size_t MonotoneContact::choose_cells(double share) {
  const double stiffness = 1 / (local_ + spring_);
  const auto excess = [&](std::size_t i) { return p_[i] - stiffness * gap(i); };
  double least = 0.0;
  if (share < 1) {
    least = (1 - share) * largest_of(n_, [&](std::size_t i) {
              return (excess(i) > 0) != (touching_[i] != 0) ? std::fabs(excess(i)) : 0.0;
            });
  }
  std::size_t changed = 0;
  cells_.clear();
  for (std::size_t i = 0; i < n_; ++i) {
    const double e = excess(i);
    const bool touches =
        (e > 0) != (touching_[i] != 0) && std::fabs(e) < least ? touching_[i] != 0 : e > 0;
    changed += touches != (touching_[i] != 0);
    touching_[i] = touches;
    if (touches) {
      cells_.push_back(i);
    } else {
      p_[i] = 0.0;
    }
  }
  return changed;
}

/// Largest tension, gap of a touching cell and interpenetration of another one, each relative to
/// its scale, and the relative error of the load.
double MonotoneContact::set_error() const {
  const double over_p = 1 / largest_pressure(), over_u = 1 / largest_displacement();
  const double worst = largest_of(n_, [&](std::size_t i) {
    const double g = std::fabs(gap(i)) > rounding_ ? gap(i) : 0.0;
    return touching_[i] ? std::max(-p_[i] * over_p, std::fabs(g) * over_u) : -g * over_u;
  });
  if (!driven_by_load()) return worst;
  const double total = ordered_sum(n_, [this](std::size_t i) { return p_[i]; });
  return std::max(worst, std::fabs(total / sum() - 1));
}

Field MonotoneContact::scattered(const Field& v) {
  Field box(n_, 0.0);
  for_each_cell(std::ssize(cells_), [&](std::ptrdiff_t c) { box[cells_[c]] = v[c]; });
  return box;
}

/// (K v - s b, mean of v): pressure v of the cells, change b of the approach over the scale s of
/// displacement per pressure; all in units of pressure. Without a prescribed load b is absent.
void MonotoneContact::apply(const Field& v, Field& out) {
  const std::size_t m = cells_.size();
  Field box = scattered(v);
  displacement_.apply(box.data(), box.data(), work_);
  ++applications_;
  const double over = 1 / displacement_.self_influence();
  out.resize(v.size());
  for_each_cell(std::ssize(cells_),
                [&](std::ptrdiff_t c) { out[c] = over * (box[cells_[c]] + spring_ * v[c]); });
  if (!driven_by_load()) return;
  for (std::size_t c = 0; c < m; ++c) out[c] -= v[m];
  out[m] = ordered_sum(m, [&](std::size_t c) { return v[c]; }) / static_cast<double>(m);
}

/// Inverse of the bordered system with the inverse of each mode in place of K^-1.
void MonotoneContact::precondition(const Field& r, Field& z) {
  const std::size_t m = cells_.size();
  Field box = scattered(r);
  displacement_.precondition(inverse_, box.data(), box.data(), work_);
  ++filters_;
  const double self = displacement_.self_influence();
  z.resize(r.size());
  for_each_cell(std::ssize(cells_), [&](std::ptrdiff_t c) { z[c] = self * box[cells_[c]]; });
  if (!driven_by_load()) return;
  const double mean = ordered_sum(m, [&](std::size_t c) { return z[c]; }) / static_cast<double>(m);
  z[m] = (r[m] - mean) / border_mean_;
  for (std::size_t c = 0; c < m; ++c) z[c] += z[m] * border_[c];
}

void MonotoneContact::prepare_border() {
  if (!driven_by_load()) return;
  const std::size_t m = cells_.size();
  Field box = scattered(Field(m, displacement_.self_influence()));
  displacement_.precondition(inverse_, box.data(), box.data(), work_);
  ++filters_;
  border_.resize(m);
  for (std::size_t c = 0; c < m; ++c) border_[c] = box[cells_[c]];
  border_mean_ = ordered_sum(m, [&](std::size_t c) { return border_[c]; }) / static_cast<double>(m);
}

/// Gaps of the touching cells over the scale of displacement, and the missing load.
Field MonotoneContact::residual() const {
  const std::size_t m = cells_.size();
  Field right(m + (driven_by_load() ? 1 : 0));
  for (std::size_t c = 0; c < m; ++c) {
    right[c] = -gap(cells_[c]) / displacement_.self_influence();
  }
  if (driven_by_load()) {
    const double total = ordered_sum(n_, [this](std::size_t i) { return p_[i]; });
    right[m] = (sum() - total) / static_cast<double>(m);
  }
  return right;
}

/// Closes the gap of the touching cells, under the prescribed load.
void MonotoneContact::solve_cells(double gain) {
  prepare_border();
  const std::size_t m = cells_.size();
  const auto length = [](const Field& v) {
    return std::sqrt(ordered_dot(v.data(), v.data(), v.size()));
  };
  Field right = residual(), change;
  double left = length(right);
  const double goal = gain * left;
  for (int n = 0; n <= max_restarts && left > goal; ++n) {
    const int steps = gmres([this](const Field& v, Field& out) { apply(v, out); },
                            [this](const Field& r, Field& z) { precondition(r, z); }, right,
                            goal / left, max_linear_steps, change);
    iterations_ += steps;
    for (std::size_t c = 0; c < m; ++c) p_[cells_[c]] += change[c];
    if (driven_by_load()) approach_ += change[m] * displacement_.self_influence();
    settle();
    if (steps < max_linear_steps) break;
    right = residual();
    left = length(right);
  }
}

Solution MonotoneContact::solution() {
  spring_ = 0.0;
  for (double& p : p_) p = std::max(p, 0.0);
  if (driven_by_load()) scale_to_sum(p_, sum());
  settle();
  Solution found;
  found.motion.approach = approach_;
  found.gap.resize(n_);
  for (std::size_t i = 0; i < n_; ++i) found.gap[i] = gap(i);
  found.rounding = rounding_;
  found.error = complementarity_error(p_, u_, found.gap, rounding_);
  found.load = driven_by_load()
                   ? normal_.value
                   : grid_.cell_area() * ordered_sum(n_, [this](std::size_t i) { return p_[i]; });
  found.moment = moments(grid_, p_);
  found.iterations = iterations_;
  found.operator_applications = applications_;
  found.work = applications_ + filters_;
  found.tractions.pressure = p_;
  return found;
}

Solution MonotoneContact::run(double tol, int max_iterations) {
  double lowest = INFINITY, share = 1.0;
  int stalled = 0;
  for (bool first = true;; first = false) {
    check_interrupt();
    const std::size_t changed = first ? n_ : choose_cells(share);
    if (cells_.empty()) {  // separated, or a start far from the solution
      std::fill(p_.begin(), p_.end(), 0.0);
      settle();
      if (driven_by_load()) {
        cells_.push_back(std::min_element(initial_gap_.begin(), initial_gap_.end()) -
                         initial_gap_.begin());
        touching_[cells_[0]] = 1;
      } else if (choose_cells(1.0) == 0) {
        return solution();
      }
    } else if (changed > 0 && !first) {
      settle();  // without the pressure of cells that were left
    }
    const double error = set_error();
    stalled = error < 0.9 * lowest ? 0 : stalled + 1;
    lowest = std::min(lowest, error);
    if (spring_ == 0 && changed == 0 && error <= tol) {
      Solution found = solution();
      found.converged = found.error <= tol;
      if (found.converged || iterations_ >= max_iterations) return found;
    }
    if (iterations_ >= max_iterations) {
      Solution found = solution();
      found.converged = false;
      return found;
    }
    if (spring_ > 0 && changed == 0 && error <= spring_tol) {
      set_springs(slackening * spring_);
      share = 1.0;
      stalled = 0;
      lowest = INFINITY;
      continue;
    }
    if (stalled > patience) {
      share = std::max(caution * share, most_cautious);
      stalled = 0;
      lowest = error;
      if (share < springs_below) {
        set_springs(std::max(first_spring * local_, tightening * spring_));
        share = 1.0;
        lowest = INFINITY;
      }
    }
    const double gain = changed > 0 ? set_gain : std::clamp(safety * tol / error, 1e-4, set_gain);
    solve_cells(gain);
    ++iterations_;
  }
}

}  // namespace

Solution solve_monotone(const operators::CreepingDisplacement& displacement, const Grid& grid,
                        const Field& initial_gap, const Given& normal, Field pressure,
                        double rounding, double tol, int max_iterations) {
  return MonotoneContact(displacement, grid, initial_gap, normal, std::move(pressure), rounding)
      .run(tol, max_iterations);
}

}  // namespace samcontact::contact
