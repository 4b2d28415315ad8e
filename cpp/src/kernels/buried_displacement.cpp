// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/buried_displacement.hpp"

#include <cmath>

#include "samcontact/kernels/corners.hpp"

namespace samcontact::kernels {
namespace {

double radius(double x, double y, double d) { return std::sqrt(x * x + y * y + d * d); }

/// Angle whose derivative with respect to d is x y/(R (x^2 + d^2)).
double angle(double x, double y, double d) {
  const double vertical = x * x + d * d + d * radius(x, y, d);
  return vertical > 0 ? std::atan(x * y / vertical) : 0.0;
}

}  // namespace

double buried_displacement(double x, double y, double d) {
  return x * log_ratio(y, x, d) + y * log_ratio(x, y, d) -
         d * std::atan2(x * y, d * radius(x, y, d));
}

double buried_along(double x, double y, double d) {
  return x * log_ratio(y, x, d) - d * angle(x, y, d);
}

double buried_across(double x, double y, double d) {
  const double R = radius(x, y, d);
  return d > 0 ? d * std::log1p(R / d) - R : -R;
}

double buried_coupling(double x, double y, double d) {
  return y * std::log(radius(x, y, d) + d) + d * log_ratio(y, x, d) + x * angle(x, y, d);
}

}  // namespace samcontact::kernels
