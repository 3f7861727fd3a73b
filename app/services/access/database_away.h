// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>

namespace torsio {

/// Whether this is a DbError that says that the server cannot be reached: it passes, and is tried again.
[[nodiscard]] bool saysDatabaseAway(const std::exception_ptr& thrown);

}  // namespace torsio
