// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/tilt_search.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace samcontact::contact {
namespace {

constexpr int max_solves = 120, max_halvings = 8;
/// Tolerance of the moments in units of that of the contact, and its minimum.
constexpr double moment_tol_ratio = 10.0, min_moment_tol = 1e-12;

class TiltSearch {
 public:
  TiltSearch(const Grid& grid, const Drive& drive, const TiltSteps& steps, double tol,
             const SolveHeld& solve)
      : grid_(grid),
        drive_(drive),
        steps_(steps),
        tol_(std::max(moment_tol_ratio * tol, min_moment_tol)),
        solve_(solve) {
    for (int k = 0; k < 2; ++k) {
      if (drive.tilt[k].is_force()) free_.push_back(k);
    }
  }

  Solution run(const AboutAxes& first, const Field& initial_pressure) {
    const auto n = static_cast<Eigen::Index>(free_.size());
    Eigen::VectorXd tilt(n);
    for (Eigen::Index k = 0; k < n; ++k) tilt[k] = first[free_[k]];
    start_ = initial_pressure;
    Eigen::VectorXd error = error_at(tilt);
    accept();
    Eigen::MatrixXd slopes(n, n);  // of the errors over the tilts times the size of the contact
    while (best_.converged && error.cwiseAbs().maxCoeff() > tol_) {
      if (solves_ == 1) slopes = differences(tilt, error);
      if (!improve(tilt, error, slopes)) {
        best_.converged = false;
        break;
      }
    }
    return finished(error);
  }

 private:
  /// Errors of the moments, relative to the forces times the size of the contact.
  Eigen::VectorXd error_at(const Eigen::VectorXd& tilt) {
    Drive held = drive_;
    for (std::size_t k = 0; k < free_.size(); ++k) {
      held.tilt[free_[k]] = Given::motion(tilt[static_cast<Eigen::Index>(k)]);
    }
    last_ = solve_(held, start_);
    iterations_ += last_.iterations;
    applications_ += last_.operator_applications;
    work_ += last_.work;
    if (++solves_ == 1) measure();
    Eigen::VectorXd error(tilt.size());
    for (std::size_t k = 0; k < free_.size(); ++k) {
      const double missing = last_.moment[free_[k]] - drive_.tilt[free_[k]].value;
      error[static_cast<Eigen::Index>(k)] = missing / scale_;
    }
    return error;
  }

  /// Size of the contact and scale of its moments.
  void measure() {
    const Field& pressure = last_.tractions.pressure;
    const std::vector<double> xs = grid_.x(), ys = grid_.y();
    double force = 0.0, second = 0.0, x = 0.0, y = 0.0;
    for (std::size_t at = 0; at < pressure.size(); ++at) {
      const double p = std::fabs(pressure[at]) * grid_.cell_area();
      const double px = xs[at / grid_.ny], py = ys[at % grid_.ny];
      force += p;
      x += p * px;
      y += p * py;
      second += p * (px * px + py * py);
    }
    const double mean = force > 0 ? (x * x + y * y) / force : 0.0;
    size_ = force > 0 ? std::sqrt(std::max(second - mean, 0.0) / force) : 0.0;
    size_ = std::max({size_, grid_.dx, grid_.dy});
    double given = 0.0;
    for (const int k : free_) given = std::max(given, std::fabs(drive_.tilt[k].value));
    scale_ = std::max(force * size_, given);
    if (!(scale_ > 0)) scale_ = 1.0;
  }

  void accept() {
    best_ = last_;
    start_ = best_.tractions.pressure;
  }

  Eigen::MatrixXd differences(const Eigen::VectorXd& tilt, const Eigen::VectorXd& error) {
    Eigen::MatrixXd slopes(tilt.size(), tilt.size());
    for (Eigen::Index k = 0; k < tilt.size(); ++k) {
      Eigen::VectorXd moved = tilt;
      moved[k] += steps_.first / size_;
      slopes.col(k) = (error_at(moved) - error) / steps_.first;
    }
    return slopes;
  }

  /// A step of limited length, shortened until it decreases the error; whether it does.
  bool improve(Eigen::VectorXd& tilt, Eigen::VectorXd& error, Eigen::MatrixXd& slopes) {
    Eigen::VectorXd step = -slopes.fullPivLu().solve(error);  // times the size
    const double length = step.cwiseAbs().maxCoeff();
    if (!(length > 0) || !step.allFinite()) return false;
    if (length > steps_.largest) step *= steps_.largest / length;
    for (int halving = 0; halving <= max_halvings; ++halving, step *= 0.5) {
      if (solves_ >= max_solves) return false;
      const Eigen::VectorXd found = error_at(tilt + step / size_);
      if (!last_.converged) return false;
      const Eigen::VectorXd change = found - error;
      slopes += (change - slopes * step) * step.transpose() / step.squaredNorm();
      if (!(found.norm() < error.norm())) continue;
      tilt += step / size_;
      error = found;
      accept();
      return true;
    }
    return false;
  }

  Solution finished(const Eigen::VectorXd& error) {
    best_.error = std::max(best_.error, error.cwiseAbs().maxCoeff() / moment_tol_ratio);
    best_.iterations = iterations_;
    best_.operator_applications = applications_;
    best_.work = work_;
    return std::move(best_);
  }

  const Grid& grid_;
  const Drive& drive_;
  const TiltSteps& steps_;
  double tol_;
  const SolveHeld& solve_;
  std::vector<int> free_;  // axes with a prescribed moment
  Field start_;
  Solution last_, best_;
  double size_ = 0.0, scale_ = 1.0, work_ = 0.0;
  int solves_ = 0, iterations_ = 0, applications_ = 0;
};

}  // namespace

Solution find_tilts(const Grid& grid, const Drive& drive, const AboutAxes& first,
                    const Field& initial_pressure, const TiltSteps& steps, double tol,
                    const SolveHeld& solve) {
  return TiltSearch(grid, drive, steps, tol, solve).run(first, initial_pressure);
}

AboutAxes tilts_of(const Grid& grid, const Field& field, const Field& pressure) {
  const std::vector<double> xs = grid.x(), ys = grid.y();
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const double unit = std::max(grid.dx, grid.dy);
  for (std::size_t at = 0; at < field.size(); ++at) {
    if (!in_contact(pressure[at]) || !std::isfinite(field[at])) continue;
    const Eigen::Vector3d row(1.0, ys[at % grid.ny] / unit, -xs[at / grid.ny] / unit);
    normal += row * row.transpose();
    right += field[at] * row;
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(normal);
  if (!solver.isInvertible()) return {};
  const Eigen::Vector3d plane = solver.solve(right);
  return {plane[1] / unit, plane[2] / unit};
}

}  // namespace samcontact::contact
