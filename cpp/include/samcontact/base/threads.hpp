// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace samcontact {

/// Floating-point operations (a power counts as a hundred) below which waking the threads costs
/// more than they save. The digits do not depend on it.
constexpr double worth_threads = 1e5;

}  // namespace samcontact
