// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of a body due to the modes of its heat history: the part of a history that depends on the
// structure of the body.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/operators/heat/heat_modes.hpp"

namespace samcontact::operators {

enum class HeatQuantity { temperature, displacement, stress };

/// Sums over the nodes of all modes; empty where a quantity does not need them.
struct HeatProfiles {
  std::vector<double> depths;         // [m]
  std::array<ComplexField, 4> below;  // [depth][mode]
  ComplexField surface;               // [mode]
};

/// Sums of one level of modes.
class LevelResponse {
 public:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  virtual ~LevelResponse() = default;
  /// Sets the profiles of the modes of a block. amplitudes: [node][mode, real and imaginary].
  /// Thread-safe for different blocks.
  virtual void add(const HeatBlock& block, const Matrix& amplitudes,
                   HeatProfiles& profiles) const = 0;

 protected:
  LevelResponse() = default;
  LevelResponse(const LevelResponse&) = default;
  LevelResponse& operator=(const LevelResponse&) = default;
};

/// Immutable and thread-safe.
class HeatResponse {
 public:
  virtual ~HeatResponse() = default;

  /// Unit of the amplitudes of the fields.
  virtual double scale(HeatQuantity quantity) const = 0;
  /// Profiles of the right size for a quantity at some depths [m].
  virtual HeatProfiles profiles(HeatQuantity quantity, std::vector<double> depths) const = 0;
  /// number: of the level; first: its first mode.
  virtual std::unique_ptr<LevelResponse> level(std::size_t number, std::size_t first,
                                               HeatQuantity quantity,
                                               const std::vector<double>& depths) const = 0;
  /// Amplitudes of all modes of a component at depth d.
  virtual ComplexField component(HeatQuantity quantity, const HeatProfiles& profiles, std::size_t d,
                                 int component) const = 0;

 protected:
  HeatResponse() = default;
  HeatResponse(const HeatResponse&) = default;
  HeatResponse& operator=(const HeatResponse&) = default;
};

}  // namespace samcontact::operators
