// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "db/connection/connection.h"
#include "sim/core/text.h"

namespace torsio {

/// Throws Error (kVerifyFailed) beginning with `what`, with the first finding, unless the audit trail of a
/// record verifies. Inside a transaction.
void requireSound(Connection& connection, const Text& what);

}  // namespace torsio
