// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include "samcontact/base/team.hpp"

namespace samcontact::bindings {

/// Releases the GIL while it exists, and limits loops to as many threads as find a free processor.
class LongWork {
  const pybind11::gil_scoped_release release_;
  const Team team_;
};

}  // namespace samcontact::bindings
