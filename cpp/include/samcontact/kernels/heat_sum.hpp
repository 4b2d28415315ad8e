// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of a heat source as sums of separable terms: a rectangle convolved with a Gaussian of
// width v, shifted by the motion of the body, is a product f_a(x) f_b(y), and every field of a heat
// source is an integral over such products.
#pragma once

#include <array>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/kernels/heat_source.hpp"

namespace samcontact::kernels {

/// f(x; v) = 1/2 [erf((x + a)/(2 v)) - erf((x - a)/(2 v))] and its first two derivatives at the
/// points of one direction, summed over all repetitions of the source.
class HeatProfile {
 public:
  /// period: distance of the repetitions; 0: a single source.
  HeatProfile(const std::vector<double>& x, double a, double period = 0.0);

  struct Range {
    int first, last;
    bool empty() const { return first >= last; }
  };
  /// Points at which a profile, shifted by any distance from `low` to `high`, is not negligible, if
  /// it has decayed at the distance `reach` from its edges.
  Range support(double low, double high, double reach) const;
  /// out[m][i - first] = m-th derivative of f at x[i] - shift, m = 0..orders - 1.
  void evaluate(double shift, double v, Range range, int orders, double* const* out);
  /// Smallest distance of a point from an edge, except points on an edge; infinity if there are
  /// none.
  double edge_distance() const { return edge_distance_; }
  double min() const { return x_.front(); }
  double max() const { return x_.back(); }
  double half_size() const { return a_; }

 private:
  void evaluate_edges(double shift, double v, int first, int last, int orders);
  void repeat_edges(double v, int first, int last);

  std::vector<double> x_;
  double a_, period_;
  double edge_distance_;
  // Points of a lattice share their edges: x + a of one is x - a of another.
  std::vector<double> edges_;
  std::vector<int> low_edge_, high_edge_;  // of x - a, x + a
  // At the edges: erf u and exp(-u^2), u = edge/(2 v), and exp(-u^2) times the edge.
  std::vector<double> erf_, gauss_, moment_;
};

/// One table: weight `weight` of every term times derivatives of its two profiles.
struct HeatProduct {
  int order_x, order_y, weight;
};

/// Sum of terms for several tables at once. Terms are collected and added a few at a time, so that
/// a table is read and written once for all of them. If the source moves along an axis of the grid
/// or rests, terms of one width have the same profile across the motion: their profiles along the
/// motion are summed first.
class HeatSum {
 public:
  static constexpr int max_weights = 3;
  /// Terms decay within `reach` widths from the edges of the rectangle.
  HeatSum(const HeatSource& source, const HeatPoints& points, std::vector<HeatProduct> products,
          double reach);

  /// Adds a Gaussian of width v; the body has moved for `age` = kappa tau since the heat entered
  /// it.
  void add(double age, double v, const std::array<double, max_weights>& weights);
  /// States that the following terms differ in width and support from the previous ones.
  void end_width();
  /// Adds the collected terms; checks for an interrupt (base/interrupt.hpp).
  void flush();
  /// Age above which terms of width v reach no point; infinity for a stationary source.
  double last_age(double v) const;

  const HeatProfile& along_x() const { return profile_x_; }
  const HeatProfile& along_y() const { return profile_y_; }
  /// Table of a product, [i][j].
  const Field& table(int product) const { return tables_[product]; }

 private:
  static constexpr std::size_t batch = 16, max_widths = 4;
  struct Term {
    double age, v;
    std::array<double, max_weights> weights;
  };
  using Range = HeatProfile::Range;

  bool is_oblique() const { return speed_x_ != 0 && speed_y_ != 0; }
  void flush_terms();
  void begin_width(double v);
  void add_to_width(const Term& term);
  void flush_widths();

  double speed_x_, speed_y_, reach_;
  HeatProfile profile_x_, profile_y_;
  std::vector<HeatProduct> products_;
  int orders_ = 1;
  std::size_t nx_, ny_;
  std::vector<Term> terms_;
  std::vector<Field> tables_;
  Field f_, g_, weighted_;  // [order][term][point]
  // Of a source that is not oblique: weighted sums of the profiles along the motion,
  // [product][width][point], and profiles across it, [order][width][point].
  std::vector<double> widths_;
  Field along_, across_;
  Range rows_{}, columns_{};
};

}  // namespace samcontact::kernels
