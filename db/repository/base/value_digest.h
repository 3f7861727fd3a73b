// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "db/connection/value.h"
#include "sim/core/digest.h"

namespace torsio {

/// Adds a value with its type, so that null, 0 and empty text differ. `boolean`: the column holds booleans,
/// which SQLite returns as 0 and 1.
void addValue(Digest& digest, const Value& value, bool boolean);

}  // namespace torsio
