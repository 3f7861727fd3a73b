// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/services/access/session_context.h"
#include "sim/core/text.h"

namespace torsio {

/// Finishes or undoes a move of this record during which the program was killed (begunMove()): finished if
/// the other database contains the whole copy, undone if it answers and does not. Audited. Needs no right: it
/// completes what somebody with the right began. Returns what was done, one sentence; empty: nothing, because
/// there is no such move, the copy is still being written, or the other database does not answer. Throws
/// DbError.
[[nodiscard]] Text settleMove(SessionContext& session);

}  // namespace torsio
