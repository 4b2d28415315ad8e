// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/plasticity/material.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "samcontact/base/errors.hpp"

namespace samcontact::plasticity {
namespace {

void require_positive(const char* name, double value, const char* allowed) {
  require(std::isfinite(value) && value > 0, name, allowed, value);
}

}  // namespace

Material Material::with_law(double E, double nu, Hardening::Laws law) {
  const Elastic elastic = Elastic::isotropic(E, nu);
  return {elastic, Hardening(std::move(law), elastic)};
}

Material Material::with_law(double E, double nu, const std::string& name,
                            const Hardening::Values& values) {
  const Elastic elastic = Elastic::isotropic(E, nu);
  return {elastic, Hardening::named(name, values, elastic)};
}

Material Material::make_rigid() {
  return {Elastic::rigid(), Hardening(NoYield{}, Elastic::rigid())};
}

Material Material::with_backstresses(const std::vector<Backstress>& terms) const {
  if (!is_plastic()) {
    throw std::invalid_argument("kinematic hardening needs a body that yields, not an elastic one");
  }
  const auto count = static_cast<double>(terms.size());
  require(count >= 1 && count <= max_backstresses, "number of backstresses",
          "from 1 to " + std::to_string(max_backstresses), count);
  for (const Backstress& term : terms) {
    require_positive("modulus", term.modulus, "a finite number > 0 [Pa]");
    require(std::isfinite(term.recovery) && term.recovery >= 0, "recovery", "a finite number >= 0",
            term.recovery);
  }
  Material material = *this;
  material.backstresses = terms;
  return material;
}

Material Material::with_thermal(const Thermal& constants) const {
  if (elastic.is_rigid()) {
    throw std::invalid_argument("a rigid body does not expand: it has no thermal constants");
  }
  Material material = *this;
  material.thermal = constants;
  return material;
}

}  // namespace samcontact::plasticity
