// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include "samcontact/base/team.hpp"

namespace samcontact::bindings {

/// While it lives, other Python threads run, and loops have as many threads as find a processor.
class LongWork {
  const pybind11::gil_scoped_release release_;
  const Team team_;
};

}  // namespace samcontact::bindings
