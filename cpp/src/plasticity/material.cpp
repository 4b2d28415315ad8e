// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/plasticity/material.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "samcontact/base/deviator.hpp"
#include "samcontact/base/errors.hpp"

namespace samcontact::plasticity {
namespace {

void require_positive(const char* name, double value, const char* allowed) {
  require(std::isfinite(value) && value > 0, name, allowed, value);
}

void require_depths(const OverDepth& profile, const std::string& name, const std::string& of) {
  const auto& [depth, value] = profile;
  if (depth.empty() || depth.size() != value.size()) {
    throw std::invalid_argument(name + of + " must have one value for each depth in z");
  }
  const std::string z = "z" + of;
  require(depth.front() >= 0, z, ">= 0 [m] (depth below the surface)", depth.front());
  for (std::size_t n = 0; n < depth.size(); ++n) {
    require(std::isfinite(depth[n]), z, "finite [m]", depth[n]);
    require(n == 0 || depth[n] > depth[n - 1], z, "strictly ascending [m]", depth[n],
            "use two close depths for a jump");
  }
}

/// Both are piecewise linear in depth, and von Mises stress is convex: checks at the depths of both
/// suffice.
void require_below_yield(const Material& material) {
  if (!material.initial_stress || !material.is_plastic()) return;
  const InitialStress& stress = *material.initial_stress;
  const double yield_stress = material.hardening.yield_stress(0.0);
  std::vector<double> depths = stress.xx.depth;
  if (const auto& profile = material.yield_profile) {
    depths.insert(depths.end(), profile->depth.begin(), profile->depth.end());
  }
  for (const double z : depths) {
    const double limit = material.yield_factor(z) * yield_stress, found = stress.von_mises(z);
    require(found <= limit * (1 + 1e-9),
            "the von Mises stress of residual_stress at z = " + to_text(z) + " m",
            "at most the yield stress there, " + to_text(limit) + " Pa", found,
            "for a hardened case, set the yield profile first");
  }
}

}  // namespace

double InitialStress::von_mises(double z) const {
  const double x = xx.at(z), y = yy.at(z), mean = (x + y) / 3;
  return std::sqrt(3 * second_invariant(x - mean, y - mean, 0.0, 0.0, xy.at(z)));
}

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
    throw std::invalid_argument("kinematic hardening requires an elastic-plastic material");
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
    throw std::invalid_argument(
        "thermal constants cannot be set for a rigid body: it does not expand");
  }
  Material material = *this;
  material.thermal = constants;
  return material;
}

Material Material::with_yield_profile(OverDepth factor) const {
  if (!is_plastic()) {
    throw std::invalid_argument("a yield profile requires an elastic-plastic material");
  }
  require_depths(factor, "factor", " of yield_profile");
  for (const double f : factor.value) {
    require(f >= 1e-6 && f <= 1e6, "factor of yield_profile", "from 1e-6 to 1e6", f);
  }
  Material material = *this;
  material.yield_profile = std::move(factor);
  require_below_yield(material);
  return material;
}

Material Material::with_initial_stress(InitialStress stress) const {
  if (elastic.is_rigid()) {
    throw std::invalid_argument("residual stress cannot be set for a rigid body");
  }
  const std::pair<const char*, const OverDepth*> parts[] = {
      {"sxx", &stress.xx}, {"syy", &stress.yy}, {"sxy", &stress.xy}};
  for (const auto& [name, part] : parts) {
    require_depths(*part, name, " of residual_stress");
    for (const double s : part->value) {
      require(std::fabs(s) <= elastic.E, std::string(name) + " of residual_stress",
              "at most Young's modulus in magnitude [Pa]", s);
    }
  }
  Material material = *this;
  material.initial_stress = std::move(stress);
  require_below_yield(material);
  return material;
}

Material Material::with_free_faces(const FreeFaces& faces) const {
  if (elastic.is_rigid() || is_plastic()) {
    throw std::invalid_argument(
        "free_faces requires an elastic material: a rigid body does not deform, and plastic flow "
        "near a free face is not known");
  }
  require(faces.low < faces.high, "free_faces: high face", "above the low face [m]", faces.high);
  Material faced = *this;
  faced.free_faces = faces;
  return faced;
}

Material Material::with_relaxation(const Relaxation& terms) const {
  if (elastic.is_rigid()) {
    throw std::invalid_argument("relaxation requires a deformable material, got a rigid one");
  }
  if (is_plastic()) {
    throw std::invalid_argument(
        "relaxation cannot be combined with a yield stress in one body: choose a viscoelastic or "
        "an elastic-plastic material");
  }
  if (free_faces.any()) {
    throw std::invalid_argument("relaxation cannot be combined with free_faces");
  }
  if (initial_stress) {
    throw std::invalid_argument(
        "relaxation cannot be combined with residual_stress, which would relax");
  }
  Material relaxing = *this;
  relaxing.relaxation = terms;
  return relaxing;
}

}  // namespace samcontact::plasticity
