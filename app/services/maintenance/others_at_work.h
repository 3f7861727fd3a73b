// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/services/access/session_context.h"
#include "sim/core/text.h"

namespace torsio {

/// Who else works at this record now, one plain sentence each: runs that go on, at this station too, and
/// other stations that sent a heartbeat in the last kStationSilence_us. kDatabaseRestore.
[[nodiscard]] std::vector<Text> othersAtWork(SessionContext& session);

/// Before a record is replaced or moved. kDatabaseRestore. Throws Error (kDatabase) with the first of
/// othersAtWork.
void requireNobodyAtWork(SessionContext& session);

}  // namespace torsio
