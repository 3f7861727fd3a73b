// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>

namespace torsio {

/// Returns whether this is a DbError because the server cannot be reached, which is temporary and retried.
[[nodiscard]] bool saysDatabaseAway(const std::exception_ptr& thrown);

}  // namespace torsio
