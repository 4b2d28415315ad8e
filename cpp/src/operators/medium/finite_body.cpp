// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/medium/finite_body.hpp"

#include <stdexcept>
#include <string>

#include "samcontact/operators/medium/half_space.hpp"
#include "samcontact/operators/medium/layered_half_space.hpp"

namespace samcontact::operators {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument(what +
                              " is not known in a body with free faces, whose theory covers "
                              "frictionless elastic contact only: omit free_faces");
}

class FiniteBody : public Medium {
 public:
  FiniteBody(const Elastic& elastic, const FreeFaces& faces)
      : body_{elastic, faces}, half_space_(half_space(elastic)) {}

  const FacedBody& body() const { return body_; }

  bool is_rigid() const override { return false; }
  bool operator==(const Medium& other) const override {
    const auto* finite = dynamic_cast<const FiniteBody*>(&other);
    return finite != nullptr && finite->body_.elastic == body_.elastic &&
           finite->body_.faces == body_.faces;
  }

  Field compliance(Traction traction, Axis axis, const Grid& grid,
                   const CellOffsets& offsets) const override {
    if (grid.period.is_on()) refuse("displacement of periodic surfaces");
    if (traction != Traction::pressure) refuse("displacement due to shear");
    if (axis != Axis::z) refuse("tangential displacement");
    return half_space_->compliance(traction, axis, grid, offsets);
  }
  double wave_compliance(double wavenumber) const override {
    return half_space_->wave_compliance(wavenumber);
  }
  std::optional<double> normal_ratio(Traction traction, const Medium& other) const override {
    const auto* finite = dynamic_cast<const FiniteBody*>(&other);
    return half_space_->normal_ratio(traction, finite ? *finite->half_space_ : other);
  }

  Field stress(Traction, const Grid&, const KernelOffsets&, double, Tensor) const override {
    refuse("stress");
  }
  Field stress(Traction, const Grid&, const CellOffsets&, double, Tensor) const override {
    refuse("stress");
  }
  Field residual_displacement(Axis, const Grid&, const CellOffsets&, int) const override {
    refuse("residual displacement");
  }
  std::unique_ptr<ResidualStress> residual_stress(const Grid&, const VolumeTransform&,
                                                  const ResidualSettings&) const override {
    refuse("residual stress");
  }
  std::unique_ptr<ResidualDisplacement> residual_displacement(
      Axis, const Grid&, const VolumeTransform&, Tensor,
      const ResidualDisplacement*) const override {
    refuse("residual displacement");
  }

 private:
  FacedBody body_;
  SharedMedium half_space_;
};

}  // namespace

SharedMedium finite_body(const Elastic& elastic, const FreeFaces& faces) {
  return std::make_shared<const FiniteBody>(elastic, faces);
}

std::optional<FacedBody> faced_body(const Medium& medium) {
  const auto* finite = dynamic_cast<const FiniteBody*>(&medium);
  return finite ? std::optional(finite->body()) : std::nullopt;
}

SharedMedium medium_of(const plasticity::Body& body) {
  const plasticity::Material& top = body.material(0);
  return top.free_faces.any() ? finite_body(top.elastic, top.free_faces) : medium_of(body.stack());
}

}  // namespace samcontact::operators
