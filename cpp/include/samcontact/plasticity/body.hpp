// SPDX-License-Identifier: GPL-3.0-or-later
// Structure of a body: one material, or layers of several materials on a substrate, perfectly
// bonded.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "samcontact/base/stack.hpp"
#include "samcontact/plasticity/material.hpp"

namespace samcontact::plasticity {

struct MaterialLayer {
  Material material;
  double thickness = 0.0;  // [m]

  bool operator==(const MaterialLayer&) const = default;
};

/// Materials are numbered from the surface down, the substrate last. Depths of their yield profiles
/// and initial stresses are counted from the surface of the body.
class Body {
 public:
  // NOLINTNEXTLINE(*-explicit-constructor): a material is a body
  Body(Material substrate) : substrate_(std::move(substrate)) {}
  /// Throws std::invalid_argument like Stack::of, and for materials that relax differently, or
  /// relax and flow plastically.
  Body(Material substrate, std::vector<MaterialLayer> layers);

  bool operator==(const Body&) const = default;

  bool is_layered() const { return !layers_.empty(); }
  int count() const { return static_cast<int>(layers_.size()) + 1; }
  const Material& material(int number) const {
    return number < static_cast<int>(layers_.size()) ? layers_[number].material : substrate_;
  }
  /// Index of the material at a depth; a depth on an interface belongs to the layer below it.
  int number_at(double z) const;
  const Material& at(double z) const { return material(number_at(z)); }
  /// Depth of the bottom of each layer [m].
  std::vector<double> interfaces() const;
  Stack stack() const;

  bool is_plastic() const;
  /// Relaxation of all deformable materials of the body.
  const Relaxation& relaxation() const { return material(0).relaxation; }
  bool is_viscoelastic() const { return relaxation().is_on(); }
  bool has_initial_stress() const;
  /// Minimum strain at yield of all materials, initial yield stress / 3 G [-]; infinite if all are
  /// elastic.
  double strain_at_yield() const;
  /// Maximum number of backstresses of a material.
  std::size_t backstresses() const;
  /// Whether the strength changes at the same depths as the strength of another body.
  bool changes_like(const Body& other) const;

 private:
  Material substrate_;
  std::vector<MaterialLayer> layers_;
};

}  // namespace samcontact::plasticity
