// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/pulled_layer.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "samcontact/base/errors.hpp"
#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {
namespace {

/// Maximum number of solutions, and of halvings of a step that increases the error.
constexpr int max_solves = 80, max_halvings = 6;
/// Tolerance of the forces in units of that of the contact.
constexpr double force_tol_ratio = 10.0;

/// Motions that cause prescribed forces.
class Pull {
 public:
  Pull(const ThirdBody& law, const Grid& grid, const TangentialDrive& drive,
       const SolveDriven& solve, double tol)
      : law_(law), grid_(grid), drive_(drive), solve_(solve), tol_(force_tol_ratio * tol) {
    for (int k = 0; k < 3; ++k) {
      if (drive[k].is_force()) pulled_.push_back(k);
    }
  }

  /// No value: the friction limit is reached, or no motion is found.
  std::optional<PartialSlipSolution> find(const PartialSlipStart& start) {
    start_ = start;
    const auto n = static_cast<Eigen::Index>(pulled_.size());
    Eigen::VectorXd motion = Eigen::VectorXd::Zero(n);
    Eigen::VectorXd error = solve_at(motion, true);
    if (!is_below_limit()) return std::nullopt;
    Eigen::MatrixXd slopes(n, n);  // of the errors over the motions
    for (Eigen::Index k = 0; k < n; ++k) {
      const double way = compliance_ * scale_[k] * (error[k] < 0 ? 1e-2 : -1e-2);
      Eigen::VectorXd moved = motion;
      moved[k] += way;
      slopes.col(k) = (solve_at(moved) - error) / way;
    }
    while (error.cwiseAbs().maxCoeff() > tol_) {
      const Eigen::VectorXd step = -slopes.fullPivLu().solve(error);
      if (!step.allFinite() || !improve(motion, error, slopes, step)) return std::nullopt;
    }
    return std::move(best_);
  }

 private:
  /// Errors of the forces, relative to their scale, of the solution for motions.
  Eigen::VectorXd solve_at(const Eigen::VectorXd& motion, bool is_first = false) {
    TangentialDrive by = drive_;
    for (std::size_t k = 0; k < pulled_.size(); ++k) {
      by[pulled_[k]] = Given::motion(motion[static_cast<Eigen::Index>(k)]);
    }
    last_ = solve_(by, start_);
    ++solves_;
    if (is_first) measure();
    Eigen::VectorXd error(motion.size());
    for (std::size_t k = 0; k < pulled_.size(); ++k) {
      const int axis = pulled_[k];
      const auto at = static_cast<Eigen::Index>(k);
      error[at] = (last_.tangential.force[axis] - drive_[axis].value) / scale_[at];
    }
    start_.pressure = last_.normal.tractions.pressure;
    start_.shear = last_.tangential.shear;
    return error;
  }

  /// Scales of the forces, and the compliance of a layer that flows everywhere.
  void measure() {
    double area = 0.0, reach = 0.0;
    const Field& pressure = last_.normal.tractions.pressure;
    const std::vector<double> xs = grid_.x(), ys = grid_.y();
    limit_ = 0.0;
    for (std::size_t at = 0; at < pressure.size(); ++at) {
      if (!in_contact(pressure[at])) continue;
      area += grid_.cell_area();
      reach = std::max(reach, std::hypot(xs[at / grid_.ny], ys[at % grid_.ny]));
      limit_ += law_.coefficient * pressure[at] * grid_.cell_area();
    }
    const double length = std::max({reach, grid_.dx, grid_.dy});
    double force = 0.0;
    for (const int axis : pulled_) {
      const double size = std::fabs(drive_[axis].value);
      force = std::hypot(force, axis == 2 ? size / length : size);
    }
    scale_.resize(static_cast<Eigen::Index>(pulled_.size()));
    for (std::size_t k = 0; k < pulled_.size(); ++k) {
      scale_[static_cast<Eigen::Index>(k)] = pulled_[k] == 2 ? force * length : force;
    }
    compliance_ = area > 0 ? (law_.compliance() + 1 / law_.hardening) / area : 0.0;
    force_ = force;
  }

  bool is_below_limit() const { return compliance_ > 0 && force_ > 0 && force_ < limit_; }

  /// A step, shortened until it decreases the error; whether it does.
  bool improve(Eigen::VectorXd& motion, Eigen::VectorXd& error, Eigen::MatrixXd& slopes,
               Eigen::VectorXd step) {
    for (int halving = 0; halving <= max_halvings; ++halving, step *= 0.5) {
      if (solves_ >= max_solves) return false;
      const Eigen::VectorXd found = solve_at(motion + step);
      const Eigen::VectorXd change = found - error;
      slopes += (change - slopes * step) * step.transpose() / step.squaredNorm();
      if (!(found.norm() < error.norm())) continue;
      motion += step;
      error = found;
      best_ = last_;
      return true;
    }
    return false;
  }

  const ThirdBody& law_;
  const Grid& grid_;
  const TangentialDrive& drive_;
  const SolveDriven& solve_;
  double tol_;
  std::vector<int> pulled_;  // axes with a prescribed force
  PartialSlipStart start_;
  PartialSlipSolution last_, best_;
  Eigen::VectorXd scale_;
  double compliance_ = 0.0, limit_ = 0.0, force_ = 0.0;  // [m/N], [N], [N]
  int solves_ = 0;
};

}  // namespace

PartialSlipSolution solve_pulled(const FrictionLaw& friction, const Grid& grid,
                                 const TangentialDrive& drive, const SolveDriven& solve,
                                 const PartialSlipStart& start, double tol) {
  const ThirdBody* law = friction.hardening();
  const bool is_pulled = std::any_of(drive.begin(), drive.end(), [](const Given& given) {
    return given.is_force() && given.value != 0;
  });
  if (law == nullptr || law->hardening < 0 || !is_pulled) return solve(drive, start);
  std::exception_ptr error;
  try {
    return solve(drive, start);
  } catch (const std::invalid_argument&) {  // above the strength before the increment
    error = std::current_exception();
  } catch (const ConvergenceError&) {  // close to it
    error = std::current_exception();
  }
  std::optional<PartialSlipSolution> found = Pull(*law, grid, drive, solve, tol).find(start);
  if (!found) std::rethrow_exception(error);
  return std::move(*found);
}

}  // namespace samcontact::contact
