// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/increment/softening.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "samcontact/base/errors.hpp"

namespace samcontact::simulation {

ThermalSoftening::ThermalSoftening(const IncrementTask& task) : task_(task), temperature_(task) {}

void ThermalSoftening::apply(PlasticBody& body, const Box& box) {
  Field& pressure = pressure_[body.index()];
  if (!pressure.empty() || !task_.settings.softening[body.index()]) return;
  pressure = body.tractions().pressure;
  soften(body, task_.setup().volume_below(pressure).united(box));
}

void ThermalSoftening::extend(PlasticBody& body, const Box& box) {
  if (body.cells().softening() && !body.cells().softening()->box.contains(box)) soften(body, box);
}

void ThermalSoftening::soften(PlasticBody& body, const Box& box) {
  const auto& known = body.cells().softening();
  body.soften(factor(body.index(), known ? known->box.united(box) : box));
}

std::shared_ptr<const BoxField> ThermalSoftening::factor(int body, const Box& box) {
  const Softening& law = task_.settings.softening[body];
  const Field rise = temperature_.rise(body, pressure_[body], box);
  const std::string name = "softening of body " + std::to_string(body + 1);
  Field factor = law(rise, box);
  require(factor.size() == rise.size(), name,
          "one value for each cell of the grid, " + std::to_string(rise.size()),
          static_cast<double>(factor.size()));
  for (const double f : factor) require(f > 0 && f <= 1, name, "in (0, 1]", f);
  if (*std::min_element(factor.begin(), factor.end()) == 1) return nullptr;
  return std::make_shared<const BoxField>(BoxField{box, std::move(factor)});
}

}  // namespace samcontact::simulation
