// SPDX-License-Identifier: GPL-3.0-or-later
// What a body is made of: a material, or layers of several on a substrate, perfectly bonded.
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

/// Materials are counted from the surface down, the substrate last. Depths of their yield profiles
/// and initial stresses are those below the surface of the body.
class Body {
 public:
  // NOLINTNEXTLINE(*-explicit-constructor): a material is a body
  Body(Material substrate) : substrate_(std::move(substrate)) {}
  /// Throws std::invalid_argument as Stack::of.
  Body(Material substrate, std::vector<MaterialLayer> layers);

  bool operator==(const Body&) const = default;

  bool is_layered() const { return !layers_.empty(); }
  int count() const { return static_cast<int>(layers_.size()) + 1; }
  const Material& material(int number) const {
    return number < static_cast<int>(layers_.size()) ? layers_[number].material : substrate_;
  }
  /// Of the material at a depth; on an interface that below it.
  int number_at(double z) const;
  const Material& at(double z) const { return material(number_at(z)); }
  /// Depth of the bottom of each layer [m].
  std::vector<double> interfaces() const;
  Stack stack() const;

  bool is_plastic() const;
  bool has_initial_stress() const;
  /// Smallest strain at yield of all materials, yield stress / 3 G, before hardening; infinite
  /// where none yields.
  double strain_at_yield() const;
  /// Most that a material has.
  std::size_t backstresses() const;
  /// Whether depths at which strength changes are the same.
  bool changes_like(const Body& other) const;

 private:
  Material substrate_;
  std::vector<MaterialLayer> layers_;
};

}  // namespace samcontact::plasticity
