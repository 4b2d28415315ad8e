// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/increment/fixed_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "samcontact/base/errors.hpp"
#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/iteration/anderson.hpp"
#include "samcontact/simulation/increment/plastic_increment.hpp"

namespace samcontact::simulation {
namespace {

using contact::Anderson;
using contact::AndersonOf;
using contact::norm;

/// Number of steps used by the acceleration; smaller for many unknowns, for which the memory
/// matters more than one additional evaluation in ten to thirty.
constexpr int anderson_depth = 8, depth_of_many = 3;
constexpr std::size_t many = 2'000'000;
/// Tolerance of the contact relative to that of the plastic fixed-point iteration.
constexpr double contact_tol_ratio = 1e-2;
/// Largest and smallest tolerance of a contact solve inside the fixed-point iteration.
constexpr double loosest = 1e-6, tightest = 1e-12;
/// The same with an adhesion that depends on the gap, where a contact takes more iterations; the
/// largest tolerance with which an iterate is accepted, for which repulsion can be distinguished
/// from the error of the tension; and this error relative to the tolerance.
constexpr double loosest_adhesive = 1e-4, accepted_adhesive = 5e-8, error_over_tol = 100.0;
/// Plastic strain increments below this fraction of the strain at yield are not resolved further:
/// the relative change refers to the larger of the two.
constexpr double negligible = 1e-2;
/// Error of the stress of a single mixed cell relative to that of all of them.
constexpr double local_ratio = 10.0;
/// Relative change of the plastic strain increment of the matrix, up to which the tolerance refers
/// to all strain together. Smaller ratios cost one more evaluation, and were found to change the
/// plastic strain by less than 1 %.
constexpr double plastic_ratio = 4.0;
constexpr double smallest_strain = 1e-300;
/// If the stress is below yield by this fraction everywhere, the loosest contact tolerance suffices
/// for an elastic increment.
constexpr double safe_headroom = 1e-3;
/// A residual this much larger than the best one indicates that the acceleration diverges.
constexpr double divergence_factor = 10.0;

bool any(const Field& field) {
  return std::any_of(field.begin(), field.end(), [](double v) { return v != 0; });
}

class FixedPoint {
 public:
  explicit FixedPoint(const IncrementTask& task)
      : grid_(task.setup().grid),
        law_(*task.setup().contact_law),
        target_(task.target),
        settings_(task.settings),
        counters_(task.counters),
        problem_(task),
        tol_(std::max(settings_.tol, problem_.mismatch_tol())),
        loosest_(law_.varies() ? loosest_adhesive : loosest),
        elastic_tol_(accepted(std::max(contact_tol_ratio * settings_.tol, tightest))),
        contact_tol_(problem_.has_plastic_body() ? loosest_ : elastic_tol_) {
    // The strain in a void is not unique: rounding errors of the history would grow.
    if (problem_.mismatch_tol() > 0) anderson_.emplace<AndersonOf<double>>(anderson_depth);
  }

  State solve() {
    x_ = problem_.first_guess();
    evaluate();
    if (!any(mapped_) && any(x_)) {
      // No plastic flow in this attempt.
      std::fill(x_.begin(), x_.end(), 0.0);
      evaluate();
    }
    while (result_.grown && !any(mapped_)) evaluate();
    // Plastic flow only widens the contact: a contact that is too large now will not fit later.
    if (settings_.on_border == contact::OnBorder::error && !target_.is_prescribed()) {
      const contact::Solution& contact = result_.contact;
      const Field repulsion =
          without_errors(contact::repulsion(law_, contact.tractions.pressure, contact.gap));
      const auto warning = contact::edge_warning(grid_, repulsion, describe(target_));
      if (!warning.empty()) throw contact::too_small(grid_, repulsion, warning);
    }
    if (problem_.has_plastic_body()) ++counters_.yield_checks;
    if (!any(mapped_) && contact_tol_ > elastic_tol_) {
      contact_tol_ = elastic_tol_;
      if (result_.headroom > safe_headroom) {
        problem_.refine_contact(contact_tol_, result_);
      } else {
        evaluate();
      }
    }
    while (!any(mapped_)) {
      if (!problem_.zones().grow_beyond()) return finish(0);
      evaluate();
    }

    ++counters_.plastic_solves;
    int before = 0;  // until boxes have grown
    bool restarted = false;
    for (int n = 1; n <= settings_.max_iterations; ++n) {
      check_interrupt();
      if (!std::exchange(restarted, false)) advance();
      result_.grown = problem_.zones().grow_when_settled(residual_) || result_.grown;
      const double finest = accepted(contact_tolerance(tol_));
      // Cells outside a box that has grown may flow too: check them before accepting.
      if (!result_.grown && residual_ <= tol_ && yields_within_tolerance()) {
        // The required tolerance changes slightly with every iterate: twice its value is close
        // enough.
        if (contact_tol_ > 2 * finest) {
          contact_tol_ = finest;
          coarse_ = true;
        } else if (!problem_.zones().grow_beyond()) {
          return finish(before + n);
        } else {
          before += std::exchange(n, 0);
          restart();
          restarted = true;
        }
      } else {
        contact_tol_ = std::max(contact_tolerance(residual_), finest);
      }
    }
    throw not_converged();
  }

 private:
  ConvergenceError not_converged() const {
    return {"plastic strain did not converge at " + describe(target_) + ": relative change " +
                to_short_text(residual_) + ", yield violation " + to_short_text(result_.excess) +
                " after " + std::to_string(settings_.max_iterations) + " iterations, tol " +
                to_text(tol_) +
                ": use smaller increments, residual_stress = \"fast\", or a larger max_iterations "
                "or tol",
            settings_.max_iterations, residual_};
  }

  /// Repulsion without values below the error of an adhesive contact.
  Field without_errors(Field repulsion) const {
    if (!law_.varies()) return repulsion;
    const double largest =
        std::max(law_.largest_attraction(),
                 largest_of(repulsion.size(), [&](std::size_t i) { return repulsion[i]; }));
    const double error = error_over_tol * contact_tol_ * largest;
    for (double& r : repulsion) r = r > error ? r : 0.0;
    return repulsion;
  }

  /// Tolerance of the contact of an accepted iterate.
  double accepted(double tol) const {
    return law_.varies() ? std::min(tol, accepted_adhesive) : tol;
  }

  /// The effect of an error of the contact pressure is relative to the excess of the trial stress
  /// over the yield stress, which drives plastic flow: the smaller the excess, the smaller the
  /// contact tolerance must be.
  double contact_tolerance(double residual) const {
    // Mismatch of elastic cells is driven by the whole stress.
    const bool elastic = result_.mismatch_norm > 0 && result_.overshoot == 0;
    const double share = elastic ? 1.0 : std::clamp(result_.overshoot, negligible, 1.0);
    return std::clamp(contact_tol_ratio * share * residual, tightest, loosest_);
  }

  /// mapped = G(x).
  void evaluate() {
    result_ = problem_.evaluate(x_, contact_tol_, mapped_);
    change_ = std::sqrt(ordered_chunks(x_.size(), [this](std::size_t begin, std::size_t end) {
      std::array<double, reduce_chunk> f;
      for (std::size_t i = begin; i < end; ++i) f[i - begin] = mapped_[i] - x_[i];
      return ordered_dot(f.data(), f.data(), end - begin);
    }));
    const double mixed = result_.mixed_change;
    const double change = mixed > 0 ? result_.plastic_change : change_;
    const double increment = mixed > 0 ? result_.increment_norm : norm(mapped_);
    const double scale = std::max(increment, negligible * result_.yield_strain_norm);
    residual_ = scale > 0 ? change / scale : (change > 0 ? 1.0 : 0.0);
    if (mixed > 0) residual_ = std::max(residual_ / plastic_ratio, joint_residual(scale));
  }

  bool yields_within_tolerance() const {
    return result_.excess <= tol_ && result_.mixed_excess <= local_ratio * tol_;
  }

  /// Change of the strain of mixed cells and of the plastic strain increment of all others,
  /// relative to both. scale: norm of this increment.
  double joint_residual(double scale) const {
    const double size = std::hypot(scale, result_.mismatch_norm);
    return std::hypot(result_.plastic_change, result_.mixed_change) /
           std::max(size, smallest_strain);
  }

  template <class Use>
  void accelerate(const Use& use) {
    std::visit(use, anderson_);
  }
  void reset_acceleration() {
    accelerate([](auto& anderson) { anderson.reset(); });
  }

  void advance() {
    if (std::exchange(coarse_, false)) {
      best_ = INFINITY;
      is_best_ = false;
    } else if (change_ < best_) {
      best_ = change_;
      is_best_ = true;
      best_x_ = Field{};
      best_f_ = Field{};
    } else if (std::exchange(is_best_, false)) {
      accelerate([&](const auto& anderson) {
        best_x_ = anderson.last_x(x_);
        best_f_ = anderson.last_f();
      });
    }
    // Vectors of unknowns are most of the memory of large contacts: f replaces G(x).
    Field f = std::move(mapped_);
    for (std::size_t i = 0; i < f.size(); ++i) f[i] -= x_[i];
    if (change_ > divergence_factor * best_) {
      // Restart from the best point with a damped plain step.
      reset_acceleration();
      const std::size_t n = x_.size();
      x_ = best_x_;
      f = best_f_;
      x_.resize(n, 0.0);
      f.resize(n, 0.0);
      for (double& v : f) v *= 0.5;
    }
    accelerate([&](auto& anderson) {
      if (x_.size() > many) anderson.set_depth(depth_of_many);
      anderson.next(x_, std::move(f));
    });
    evaluate();
    ++counters_.plastic_iterations;
  }

  /// Restart in boxes that have grown.
  void restart() {
    reset_acceleration();
    best_ = INFINITY;
    is_best_ = false;
    evaluate();
    ++counters_.plastic_iterations;
  }

  State finish(int iterations) {
    reset_acceleration();
    x_ = best_x_ = best_f_ = Field{};
    State state = problem_.finish(mapped_, result_);
    state.plastic_iterations = iterations;
    state.plastic_residual = iterations > 0 ? residual_ : 0.0;
    state.yield_excess = result_.excess;
    return state;
  }

  const Grid& grid_;
  const contact::ContactLaw& law_;
  const Target& target_;
  const Settings& settings_;
  Counters& counters_;
  PlasticIncrement problem_;
  std::variant<Anderson, AndersonOf<double>> anderson_{Anderson{anderson_depth}};
  Field x_, mapped_, best_x_, best_f_;
  PlasticIncrement::Result result_;
  const double tol_;          // with inclusions larger than that of the settings
  const double loosest_;      // of the contact
  const double elastic_tol_;  // of the contact in an elastic increment
  double contact_tol_, change_ = 0.0, residual_ = 1.0, best_ = INFINITY;
  bool is_best_ = false;  // whether the best point is the last one, which the acceleration stores
  bool coarse_ = false;   // whether the last residual is unreliable because the tolerance of its
                          // contact was too large
};

}  // namespace

State solve_increment(const IncrementTask& task) { return FixedPoint(task).solve(); }

}  // namespace samcontact::simulation
